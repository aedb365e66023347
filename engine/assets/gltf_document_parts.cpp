// Changing and adding a document's cameras and lights; adding images and textures.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "engine/assets/gltf_document_state.h"
#include "engine/assets/png_bytes.h"

namespace lanthorn {

namespace {

using Json = nlohmann::json;

void set_number(JsonText& object, const char* key, float value) {
    patch(object, key, plain_number(value), Json());
}

// Whether it had another type.
bool set_type(JsonText& object, const char* type) {
    const bool differs = parsed(object, "type") != type;
    patch(object, "type", type, Json());
    return differs;
}

// The member is there when `holds`, and says `value`.
void set_or_erase(JsonText& object, const char* key, bool holds, float value) {
    if (holds) {
        set_number(object, key, value);
    } else {
        object.erase(key);
    }
}

}  // namespace

void GltfDocument::State::patch_camera(JsonText& target, const Camera& camera,
                                       const std::string& place) const {
    const char* type = camera.orthographic ? "orthographic" : "perspective";
    const std::string lens_place = fmt::format("{}/{}", place, type);
    if (camera.orthographic) {
        expect_in(camera.x_mag, std::numeric_limits<float>::denorm_min(), kNoLimit, lens_place + "/xmag");
        expect_in(camera.y_mag, std::numeric_limits<float>::denorm_min(), kNoLimit, lens_place + "/ymag");
        expect_in(camera.z_near, 0, kNoLimit, lens_place + "/znear");
    } else {
        expect_in(camera.y_fov, 1e-3, kPi - 1e-3, lens_place + "/yfov");
        expect_in(camera.z_near, std::numeric_limits<float>::denorm_min(), kNoLimit, lens_place + "/znear");
    }
    const bool has_end = camera.orthographic || camera.z_far != 0;
    if (has_end) {
        expect_in(camera.z_far, std::nextafter(camera.z_near, HUGE_VALF), kNoLimit, lens_place + "/zfar");
    }
    if (set_type(target, type)) {
        target.erase(camera.orthographic ? "perspective" : "orthographic");
    }
    JsonText& lens = object_at(target, type);
    if (camera.orthographic) {
        // The importer takes sizes without their sign.
        for (const auto& [key, size] : {std::pair("xmag", camera.x_mag), std::pair("ymag", camera.y_mag)}) {
            const Json known = parsed(lens, key);
            if (!known.is_number() || std::abs(known.get<float>()) != size) {
                set_number(lens, key, size);
            }
        }
    } else {
        set_number(lens, "yfov", camera.y_fov);
    }
    set_number(lens, "znear", camera.z_near);
    set_or_erase(lens, "zfar", has_end, camera.z_far);
}

void GltfDocument::State::patch_light(JsonText& target, const Light& light, const std::string& place) const {
    constexpr const char* kTypes[] = {"directional", "point", "spot"};
    const bool is_spot = light.type == LightType::spot;
    expect_all_in(light.colour, 0, kNoLimit, place + "/color");
    expect_in(light.intensity, 0, kNoLimit, place + "/intensity");
    if (std::isfinite(light.range)) {
        expect_in(light.range, std::numeric_limits<float>::denorm_min(), kNoLimit, place + "/range");
    }
    if (is_spot) {
        expect_in(light.outer_cone, 1e-3f, static_cast<float>(kPi / 2), place + "/spot/outerConeAngle");
        expect_in(light.inner_cone, 0, std::nextafter(light.outer_cone, 0.0f),
                  place + "/spot/innerConeAngle");
    }
    if (set_type(target, kTypes[static_cast<int>(light.type)]) && !is_spot) {
        target.erase("spot");
    }
    patch(target, "color", plain_numbers(light.colour), Json{1, 1, 1});
    patch(target, "intensity", plain_number(light.intensity), 1);
    set_or_erase(target, "range", std::isfinite(light.range), light.range);
    if (is_spot) {
        JsonText& spot = object_at(target, "spot");
        patch(spot, "innerConeAngle", plain_number(light.inner_cone), 0);
        patch(spot, "outerConeAngle", plain_number(light.outer_cone), kPi / 4);
    }
}

void GltfDocument::set_camera(std::size_t index, const Camera& camera) {
    state_->patch_camera(state_->element("cameras", index), camera, fmt::format("/cameras/{}", index));
}

std::size_t GltfDocument::add_camera(const Camera& camera) {
    JsonText target("{}");
    state_->patch_camera(target, camera, fmt::format("/cameras/{}", camera_count()));
    return state_->append("cameras", std::move(target));
}

void GltfDocument::set_light(std::size_t index, const Light& light) {
    const std::string place = fmt::format("/extensions/KHR_lights_punctual/lights/{}", index);
    if (index >= light_count()) {
        state_->refuse(place, fmt::format("found index {}, expected one below {} (the number of lights)",
                                          index, light_count()));
    }
    state_->patch_light(state_->lights().at(index), light, place);
}

std::size_t GltfDocument::add_light(const Light& light) {
    JsonText target("{}");
    target.set("color", JsonText(plain_numbers(light.colour).dump()));
    target.set("intensity", JsonText(Json(plain_number(light.intensity)).dump()));
    if (light.type == LightType::spot) {
        target.set("spot", JsonText(Json{{"innerConeAngle", plain_number(light.inner_cone)},
                                         {"outerConeAngle", plain_number(light.outer_cone)}}
                                        .dump()));
    }
    state_->patch_light(target, light,
                        fmt::format("/extensions/KHR_lights_punctual/lights/{}", light_count()));
    state_->use_extension("KHR_lights_punctual");
    state_->lights().append(std::move(target));
    return light_count() - 1;
}

std::size_t GltfDocument::State::add_image(const Image& image) {
    const Json description = {{"bufferView", add_view(png_bytes(image), 0)}, {"mimeType", "image/png"}};
    JsonText target(description.dump());
    target.set("name", JsonText(json_quoted(image.name)));
    return append("images", std::move(target));
}

std::size_t GltfDocument::add_image(const Image& image) {
    return state_->add_image(image);
}

std::size_t GltfDocument::add_texture(const Texture& texture) {
    constexpr int kWrap[] = {10497, 33071, 33648};
    if (texture.image >= state_->count("images")) {
        state_->refuse(fmt::format("/textures/{}/source", state_->count("textures")),
                       fmt::format("found {}, expected an index below {} (the number of images)",
                                   texture.image, state_->count("images")));
    }
    const Sampler& s = texture.sampler;
    const bool smooth = s.min == Filter::linear;
    const Json sampler = {{"magFilter", s.mag == Filter::linear ? 9729 : 9728},
                          {"minFilter", s.mipmaps ? (smooth ? 9987 : 9984) : (smooth ? 9729 : 9728)},
                          {"wrapS", kWrap[static_cast<int>(s.wrap_s)]},
                          {"wrapT", kWrap[static_cast<int>(s.wrap_t)]}};
    const std::size_t index = state_->append("samplers", JsonText(sampler.dump()));
    return state_->append("textures", JsonText(Json{{"sampler", index}, {"source", texture.image}}.dump()));
}

}  // namespace lanthorn
