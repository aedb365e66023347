#include "engine/assets/gltf_vertices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/assets/gltf_accessor.h"

namespace lanthorn {

namespace {

// Colours of bytes that were written as floats.
bool are_of_255(const std::vector<float>& values) {
    return std::ranges::max(values) == 255 &&
           std::ranges::all_of(values, [](float value) { return value >= 0 && value == std::floor(value); });
}

// The first `components` of each four.
void divide_by_255(std::vector<float>& values, std::size_t components) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = i % 4 < components ? values[i] / 255 : values[i];
    }
}

}  // namespace

GltfVertices::GltfVertices(const GltfContext& context, const tinygltf::Primitive& primitive,
                           std::string place)
    : context_(context), primitive_(primitive), place_(std::move(place)) {
    if (has("POSITION")) {
        count_ = context.model.accessors[static_cast<std::size_t>(primitive.attributes.at("POSITION"))].count;
    }
}

std::vector<float> GltfVertices::attribute(const std::string& name, std::size_t min_components,
                                           std::size_t components, float fill, Integers integers) const {
    return read_attribute(context_, static_cast<std::size_t>(primitive_.attributes.at(name)), place_of(name),
                          {min_components, components, count_}, fill, integers);
}

bool GltfVertices::data_present() const {
    const bool indexed =
        primitive_.indices < 0 || has_data(context_, static_cast<std::size_t>(primitive_.indices));
    return indexed &&
           std::all_of(primitive_.attributes.begin(), primitive_.attributes.end(), [&](const auto& entry) {
               return has_data(context_, static_cast<std::size_t>(entry.second));
           });
}

// Where one is no number, the vertex takes another's place, and what is drawn does without it.
void GltfVertices::read_positions(Mesh& mesh) {
    const std::vector<float> values = attribute("POSITION", 3, 3);
    vec3 sound(0);
    for (std::size_t v = count_; v-- > 0;) {
        const vec3 position(values[v * 3], values[v * 3 + 1], values[v * 3 + 2]);
        if (std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z)) {
            sound = position;
        } else {
            nowhere_.insert(static_cast<std::uint32_t>(v));
        }
    }
    for (std::size_t v = 0; v < count_; ++v) {
        const bool lost = nowhere_.contains(static_cast<std::uint32_t>(v));
        mesh.vertices[v].position = lost ? sound : vec3(values[v * 3], values[v * 3 + 1], values[v * 3 + 2]);
    }
}

std::vector<std::uint32_t> GltfVertices::without_nowhere(const std::vector<std::uint32_t>& list,
                                                         std::size_t corners) const {
    if (nowhere_.empty()) {
        return list;
    }
    std::vector<std::uint32_t> result;
    for (auto shape = list.begin(); shape != list.end(); shape += static_cast<std::ptrdiff_t>(corners)) {
        const auto end = shape + static_cast<std::ptrdiff_t>(corners);
        if (std::none_of(shape, end, [&](std::uint32_t v) { return nowhere_.contains(v); })) {
            result.insert(result.end(), shape, end);
        }
    }
    if (const std::size_t lost = (list.size() - result.size()) / corners; lost > 0) {
        context_.warn(accessor_place(static_cast<std::size_t>(primitive_.attributes.at("POSITION"))),
                      fmt::format("{} positions are not finite; {} {} left out", nowhere_.size(), lost,
                                  lost == 1 ? "shape that uses them is" : "shapes that use them are"));
    }
    return result;
}

// Plain integers are numbers where KHR_mesh_quantization allows them, and where a texture is moved or scaled
// (KHR_texture_transform), which is how quantised coordinates are brought into range.
Integers GltfVertices::integers_of_texture_coordinates(const std::string& name) const {
    const nlohmann::json used = context_.file.json.value("extensionsUsed", nlohmann::json::array());
    const auto is_moved = [](const TextureRef* texture) {
        return texture->uv_transform != TextureRef().uv_transform;
    };
    if (std::ranges::find(used, "KHR_mesh_quantization") != used.end() ||
        (primitive_.material >= 0 &&
         std::ranges::any_of(
             context_.scene.materials[static_cast<std::size_t>(primitive_.material)].textures(), is_moved))) {
        return Integers::as_stated;
    }
    return integers_of(context_, static_cast<std::size_t>(primitive_.attributes.at(name)),
                       NumbersUpTo::a_sixteenth, place_of(name));
}

void GltfVertices::read_texture_coordinates(Mesh& mesh, std::uint32_t set, vec2 Vertex::*member) const {
    const std::string name = fmt::format("TEXCOORD_{}", set);
    if (!has(name)) {
        return;
    }
    std::vector<float> values = attribute(name, 2, 2, 0, integers_of_texture_coordinates(name));
    std::size_t bad = 0;
    for (float& value : values) {
        if (!std::isfinite(value)) {
            value = 0;
            ++bad;
        }
    }
    if (bad > 0) {
        context_.warn(place_of(name), fmt::format("{} values are not finite; 0 is used", bad));
    }
    for (std::size_t v = 0; v < count_; ++v) {
        mesh.vertices[v].*member = {values[v * 2], values[v * 2 + 1]};
    }
}

void GltfVertices::read_colours(Mesh& mesh) const {
    const auto index = static_cast<std::size_t>(primitive_.attributes.at("COLOR_0"));
    const std::string place = place_of("COLOR_0");
    std::vector<float> values =
        attribute("COLOR_0", 3, 4, 1.0f, integers_of(context_, index, NumbersUpTo::one, place));
    if (are_of_255(values)) {
        context_.warn(place, "floats that are whole numbers of 0 to 255; divided by 255");
        divide_by_255(values, static_cast<std::size_t>(context_.model.accessors[index].type));
    }
    std::size_t bad = 0;
    for (float& value : values) {
        if (!(value >= 0 && value <= 1)) {
            value = value > 0 ? 1.0f : 0.0f;
            ++bad;
        }
    }
    if (bad > 0) {
        context_.warn(place, fmt::format("{} values are outside 0..1; clamped", bad));
    }
    for (std::size_t v = 0; v < count_; ++v) {
        mesh.vertices[v].colour = {values[v * 4], values[v * 4 + 1], values[v * 4 + 2], values[v * 4 + 3]};
    }
}

void GltfVertices::read_frames(Mesh& mesh) const {
    if (has("NORMAL")) {
        const std::vector<float> values = attribute("NORMAL", 3, 3);
        for (std::size_t v = 0; v < count_; ++v) {
            mesh.vertices[v].normal = {values[v * 3], values[v * 3 + 1], values[v * 3 + 2]};
        }
    }
    if (has("TANGENT")) {
        const std::vector<float> values = attribute("TANGENT", 4, 4);
        for (std::size_t v = 0; v < count_; ++v) {
            mesh.vertices[v].tangent = {values[v * 4], values[v * 4 + 1], values[v * 4 + 2],
                                        values[v * 4 + 3]};
        }
    }
}

void GltfVertices::read_others(Mesh& mesh) const {
    read_frames(mesh);
    const UvSets sets = primitive_.material < 0
                            ? kPlainUvSets
                            : context_.uv_sets[static_cast<std::size_t>(primitive_.material)];
    read_texture_coordinates(mesh, sets[0], &Vertex::uv0);
    read_texture_coordinates(mesh, sets[1], &Vertex::uv1);
    if (has("COLOR_0")) {
        read_colours(mesh);
    }
}

}  // namespace lanthorn
