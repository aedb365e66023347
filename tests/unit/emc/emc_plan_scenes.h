// A lit room to be planned, and the settings of both final stages.
#pragma once

#include <memory>

#include "lanthorn/emc/emc_settings.h"
#include "tests/unit/emc/emc_frames.h"

namespace lanthorn::gi::test {

inline FrameScene lit_room(float albedo) {
    auto assets = std::make_shared<SceneAssets>();
    assets->meshes.emplace_back();
    Material material;
    material.base_colour = vec4(vec3(albedo), 1);
    material.metallic = 0;
    material.specular = 0;
    assets->materials.push_back(material);
    FrameScene scene;
    scene.assets = assets;
    scene.instances.emplace_back();
    scene.lights.emplace_back();
    return scene;
}

inline void hold_still(FrameScene& scene) {
    scene.changes = {};
    scene.changes.assets = scene.changes.geometry = scene.changes.lights = scene.changes.camera = false;
}

inline GiSettings by_splats() {
    GiSettings settings;
    settings.edit<EmcSettings>().final_stage = EmcFinal::splat;
    return settings;
}

// gi.bounces reflections, by rays: endless ones go on for some frames.
inline GiSettings counted_gather() {
    GiSettings settings;
    settings.edit<EmcSettings>().gather_source = GatherSource::rays;
    settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    settings.edit<EmcSettings>().gather_endless = false;
    return settings;
}

// A still picture all of whose rays are in.
inline EmcFrames settled(const FrameScene& scene, const GiSettings& settings) {
    EmcFrames frames = running(scene, settings);
    frames.kept.texel_frames = frames.kept.point_frames = 16;
    return frames;
}

}  // namespace lanthorn::gi::test
