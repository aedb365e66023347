#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>

#include "engine/assets/glossiness.h"
#include "engine/assets/gltf_context.h"
#include "engine/assets/image_decode.h"
#include "engine/assets/uri.h"
#include "engine/assets/uri_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/parallel.h"

namespace lanthorn {

namespace {

constexpr int kNearest = TINYGLTF_TEXTURE_FILTER_NEAREST;
constexpr int kLinear = TINYGLTF_TEXTURE_FILTER_LINEAR;

std::vector<TextureRef*> textures_of(Material& material) {
    return {&material.base_colour_texture,     &material.metallic_roughness_texture,
            &material.normal_texture,          &material.occlusion_texture,
            &material.emissive_texture,        &material.specular_texture,
            &material.specular_colour_texture, &material.transmission_texture};
}

Wrap wrap_of(const GltfContext& context, int value, const std::string& place) {
    switch (value) {
        case TINYGLTF_TEXTURE_WRAP_REPEAT:
            return Wrap::repeat;
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return Wrap::clamp_to_edge;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return Wrap::mirrored_repeat;
        default:
            context.warn(place, fmt::format("{} is no wrapping mode; 10497 (repeat) is used", value));
            return Wrap::repeat;
    }
}

Sampler sampler_of(const GltfContext& context, int index) {
    Sampler sampler;
    if (index < 0) {
        return sampler;
    }
    const tinygltf::Sampler& source = context.model.samplers[static_cast<std::size_t>(index)];
    const std::string place = fmt::format("/samplers/{}", index);
    sampler.wrap_s = wrap_of(context, source.wrapS, place + "/wrapS");
    sampler.wrap_t = wrap_of(context, source.wrapT, place + "/wrapT");
    if (source.magFilter != -1 && source.magFilter != kNearest && source.magFilter != kLinear) {
        context.warn(place + "/magFilter",
                     fmt::format("{} is no magnification filter; 9729 (linear) is used", source.magFilter));
    }
    sampler.mag = source.magFilter == kNearest ? Filter::nearest : Filter::linear;
    switch (source.minFilter) {
        case kNearest:
            sampler.min = Filter::nearest;
            sampler.mipmaps = false;
            break;
        case kLinear:
            sampler.mipmaps = false;
            break;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
            sampler.min = Filter::nearest;
            break;
        case -1:
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR:
            break;
        default:
            context.warn(
                place + "/minFilter",
                fmt::format("{} is no minification filter; 9987 (trilinear) is used", source.minFilter));
    }
    return sampler;
}

// Numbers that the result uses for the glTF indices in use, handed out in order of first use.
class Numbering {
  public:
    void add(std::size_t from) {
        if (numbers_.emplace(from, order_.size()).second) {
            order_.push_back(from);
        }
    }
    const std::vector<std::size_t>& order() const { return order_; }

  private:
    std::map<std::size_t, std::size_t> numbers_;
    std::vector<std::size_t> order_;
};

// The encoded bytes of an image: those of a buffer, or its own.
struct EncodedImage {
    std::span<const std::uint8_t> bytes;
    std::vector<std::uint8_t> own;
    std::string problem, note;
};

EncodedImage read_file(const GltfFile& file, const std::string& uri) {
    EncodedImage result;
    const UriFile found = find_uri_file(file.folder, uri, file.allow_outside, *file.folders);
    if (!found.problem.empty()) {
        result.problem = found.problem;
        return result;
    }
    try {
        result.own = read_bytes(found.path, "", "");
        result.bytes = result.own;
    } catch (const InputError&) {
        result.problem = fmt::format("'{}' cannot be read", found.path.string());
    }
    if (!found.note.empty()) {
        result.note = fmt::format("'{:.80}' {}", uri, found.note);
    }
    return result;
}

EncodedImage encoded_image(const GltfContext& context, const tinygltf::Image& source) {
    EncodedImage result;
    if (source.bufferView >= 0) {
        const auto& view = context.model.bufferViews[static_cast<std::size_t>(source.bufferView)];
        const auto& bytes = context.model.buffers[static_cast<std::size_t>(view.buffer)].data;
        if (bytes.empty()) {
            result.problem = fmt::format("lies in buffer {}, which has no data", view.buffer);
        } else {
            result.bytes = {bytes.data() + view.byteOffset, view.byteLength};
        }
    } else if (is_data_uri(source.uri)) {
        auto bytes = decode_data_uri(source.uri);
        if (bytes) {
            result.own = std::move(*bytes);
            result.bytes = result.own;
        } else {
            result.problem = "is a broken data URI";
        }
    } else if (has_foreign_scheme(source.uri)) {
        result.problem = fmt::format("'{:.80}' is neither a relative path nor a data URI", source.uri);
    } else {
        result = read_file(context.file, source.uri);
    }
    return result;
}

DecodedImage load_image(const GltfContext& context, std::size_t index) {
    const tinygltf::Image& source = context.model.images[index];
    const EncodedImage encoded = encoded_image(context, source);
    DecodedImage result;
    if (encoded.problem.empty()) {
        result = decode_image(encoded.bytes);
    }
    result.problem += encoded.problem;
    if (!encoded.note.empty()) {
        result.note = encoded.note + (result.note.empty() ? "" : "; ") + result.note;
    }
    if (const auto factor = context.file.glossiness.find(index); factor != context.file.glossiness.end()) {
        roughness_of_glossiness(result.image, factor->second);
    }
    result.image.name = !source.name.empty() || is_data_uri(source.uri) ? source.name : source.uri;
    return result;
}

// For each image the first that is the same picture from the same place.
std::vector<std::size_t> first_alike(const GltfContext& context) {
    const auto key = [&](std::size_t index) {
        const tinygltf::Image& image = context.model.images[index];
        const auto factor = context.file.glossiness.find(index);
        const std::string_view uri(image.uri);
        return std::tuple(image.bufferView, image.bufferView < 0 ? uri : std::string_view(),
                          factor == context.file.glossiness.end() ? -1 : factor->second);
    };
    std::map<decltype(key(0)), std::size_t> first;
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < context.model.images.size(); ++i) {
        result.push_back(first.emplace(key(i), i).first->second);
    }
    return result;
}

}  // namespace

std::vector<DecodedImage> load_images(const GltfContext& context, const std::vector<std::size_t>& indices) {
    std::vector<DecodedImage> result(indices.size());
    std::vector<std::uint64_t> texels(indices.size());
    ecs::detail::parallel_for(indices.size(), [&](std::size_t i) {
        texels[i] = stated_texels(encoded_image(context, context.model.images[indices[i]]).bytes);
    });
    for (std::size_t i = 0; i < indices.size(); ++i) {
        // More than one image may have is told by the decoder.
        if (texels[i] <= kMaxDecodedTexels && !take(context.left.texels, texels[i])) {
            result[i].problem = fmt::format(
                "states {} texels, more than are left of what a file's images may have", texels[i]);
        }
    }
    ecs::detail::parallel_for(indices.size(), [&](std::size_t i) {
        if (result[i].problem.empty()) {
            result[i] = load_image(context, indices[i]);
        }
    });
    return result;
}

void import_textures(const GltfContext& context) {
    const std::vector<std::size_t> alike = first_alike(context);
    Numbering used_textures;
    Numbering used_images;
    for (Material& material : context.scene.materials) {
        for (const TextureRef* ref : textures_of(material)) {
            if (ref->present()) {
                used_textures.add(ref->texture);
                const int image = context.model.textures[ref->texture].source;
                if (image >= 0) {
                    used_images.add(alike[static_cast<std::size_t>(image)]);
                }
            }
        }
    }

    std::vector<DecodedImage> decoded = load_images(context, used_images.order());
    std::map<std::size_t, std::uint32_t> image_numbers;  // of those that are whole
    for (std::size_t i = 0; i < decoded.size(); ++i) {
        const std::size_t source = used_images.order()[i];
        const std::string place = fmt::format("/images/{}", source);
        if (!decoded[i].problem.empty()) {
            context.warn(place, fmt::format("the image {}; materials go without it", decoded[i].problem));
            continue;
        }
        if (!decoded[i].note.empty()) {
            context.warn(place, decoded[i].note);
        }
        image_numbers[source] = static_cast<std::uint32_t>(context.scene.images.size());
        context.scene.images.push_back(std::move(decoded[i].image));
        context.scene.file.images.push_back(static_cast<std::uint32_t>(source));
    }

    std::map<std::size_t, std::uint32_t> texture_numbers;
    for (const std::size_t texture : used_textures.order()) {
        const tinygltf::Texture& source = context.model.textures[texture];
        const nlohmann::json::json_pointer basis("/extensions/KHR_texture_basisu");
        if (source.source < 0 && context.file.json["textures"][texture].contains(basis)) {
            continue;  // check_extensions() has told
        }
        if (source.source < 0) {
            context.warn(fmt::format("/textures/{}", texture),
                         "has no image that we read; materials go without it");
            continue;
        }
        const auto image = image_numbers.find(alike[static_cast<std::size_t>(source.source)]);
        if (image != image_numbers.end()) {
            texture_numbers[texture] = static_cast<std::uint32_t>(context.scene.textures.size());
            context.scene.textures.push_back({image->second, sampler_of(context, source.sampler)});
            context.scene.file.textures.push_back(static_cast<std::uint32_t>(texture));
        }
    }
    for (Material& material : context.scene.materials) {
        for (TextureRef* ref : textures_of(material)) {
            if (ref->present()) {
                const auto number = texture_numbers.find(ref->texture);
                *ref = number == texture_numbers.end() ? TextureRef{} : *ref;
                ref->texture = number == texture_numbers.end() ? kNoTexture : number->second;
            }
        }
    }
}

}  // namespace lanthorn
