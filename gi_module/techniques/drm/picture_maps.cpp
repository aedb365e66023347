#include "gi_module/techniques/drm/picture_maps.h"

#include "gi_module/techniques/drm/radiance_sample.h"

namespace lanthorn::gi {

namespace {

constexpr float kNear = 1e-5f;  // of the scene's diagonal

Frustum frustum_of(const render::LightData& light, int face) {
    Frustum frustum = Frustum::of_cube_face(light.position, face);
    frustum.cut(light.direction);
    return frustum;
}

}  // namespace

int PictureMaps::draw(const render::LightInputs& inputs, const LightPictures& pictures, int resolution) {
    // Never shorter than the uniform blocks that the shaders declare.
    upload(lights_, pictures.lights, render::kMaxUniformLights);
    upload(shapes_, pictures.shapes, 1);
    int layers = 0;
    for (const LightPicture& shape : pictures.shapes) {
        layers += shape.drawn_here != 0 ? 6 : 0;
    }
    maps_.allocate(resolution, layers);
    if (layers == 0) {
        return 0;
    }
    program_.prepare(inputs.gpu_scene.variants());
    lights_.bind_storage(render::kLightsBinding);
    program_.set("near", kNear * inputs.scene.diagonal());
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    int faces = 0;
    for (std::size_t i = 0; i < pictures.lights.size(); ++i) {
        if (pictures.shapes[i].drawn_here == 0) {
            continue;
        }
        render::LightData light = pictures.lights[i];
        light.texel = 2 / static_cast<float>(resolution);
        program_.set("light_index", static_cast<int>(i));
        program_.set("light_position", light.position);
        program_.set("light_direction", light.direction);
        for (int face = 0; face < 6; ++face) {
            faces += draw_face(inputs, light, face) ? 1 : 0;
        }
    }
    glDisable(GL_DEPTH_TEST);
    return faces;
}

bool PictureMaps::draw_face(const render::LightInputs& inputs, const render::LightData& light, int face) {
    const Frustum frustum = frustum_of(light, face);
    const render::TexelSize texel{light.position, light.texel, 0};
    visible_.clear();
    for (const std::uint32_t i : inputs.gpu_scene.instances(render::DrawSet::all)) {
        if (!frustum.touches(inputs.scene.instances[i].bounds)) {
            continue;
        }
        const std::uint32_t level = inputs.gpu_scene.level(i, texel);
        if (level != render::GpuScene::kTooSmall) {
            visible_.push_back({i, level});
        }
    }
    maps_.begin(static_cast<int>(light.first_layer) + face);
    if (visible_.empty()) {
        return false;
    }
    program_.set("face", face);
    inputs.gpu_scene.draw(program_, visible_, render::Culling::none);
    return true;
}

void PictureMaps::bind(const gpu::Program& program, const render::LightInputs& inputs) const {
    program.use();
    lights_.bind_storage(render::kLightsBinding);
    shapes_.bind_storage(kPicturesBinding);
    inputs.gpu_scene.bind_materials();
    const render::LightMaps& light_maps = inputs.light_maps;
    const gpu::Texture* maps[] = {&light_maps.distance(), &light_maps.normals(), &light_maps.albedo(),
                                  &maps_.distance(),      &maps_.normals(),      &maps_.albedo()};
    const char* names[] = {"light_distance", "light_normals", "light_albedo",
                           "lamp_distance",  "lamp_normals",  "lamp_albedo"};
    for (GLuint unit = 0; unit < 6; ++unit) {
        maps[unit]->bind(unit);
        program.set(names[unit], static_cast<int>(unit));
    }
}

}  // namespace lanthorn::gi
