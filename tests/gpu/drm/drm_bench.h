// `drm` in an App.
#pragma once

#include "gi_module/techniques/drm/drm_technique.h"
#include "lanthorn/drm/drm.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

struct DrmBench : Bench {
    DrmBench() : Bench(add_drm()) {}
    DrmSettings& drm() { return settings.edit<DrmSettings>(); }
    const DrmTechnique& at_work() { return dynamic_cast<const DrmTechnique&>(technique()); }
    DrmStatistics now() { return technique().statistics(false).of<DrmStatistics>(); }
    void set_shadow_resolution(int texels) {
        render::RenderSettings render;
        render.shadow_resolution = texels;
        app.world().insert_resource(render);
    }
};

// A closed room of 4 x 2.6 x 3 m with a block in it, lit by a lamp.
inline FrameScene room_with_block(const vec3& lamp_at = vec3(0.6f, 2.2f, 1.5f)) {
    FrameScene scene = scene_of(
        {box(vec3(0), vec3(4, 2.6f, 3), true, 0), box(vec3(1.6f, 0, 0.7f), vec3(2.4f, 1.2f, 2.3f), false, 1)},
        {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))}, {point_light(lamp_at, 100)},
        vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
    return scene;
}

}  // namespace lanthorn::gi::test
