// A change of the scene updates everything that depends on it, whatever has changed before and whether there
// was light then: the picture is, bit for bit, that of a technique that starts with the changed scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/render/render_settings.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

// What a picture is of.
struct Shown {
    FrameScene scene;
    GiSettings settings;
    render::RenderSettings render;
    ivec2 size{40};
};

constexpr std::uint32_t kBlock = 1;  // instance, and its material

Shown room(EmcFinal stage) {
    Shown shown;
    shown.scene = scene_of(
        {box(vec3(0), vec3(4, 2.6f, 3), true, 0), box(vec3(1.6f, 0, 0.7f), vec3(2.4f, 2.0f, 2.3f), false, 1),
         box(vec3(2.8f, 0, 0.5f), vec3(3.2f, 0.6f, 0.9f), false, 2)},
        {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f)), metal(vec3(0.8f), 0.05f)},
        {point_light(vec3(0.6f, 2.2f, 1.5f), 100)}, vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
    shown.settings.photons = 600;
    shown.settings.accumulate = 2;
    auto& emc = shown.settings.edit<EmcSettings>();
    emc.final_stage = stage;
    emc.rays = EmcRays::bvh;
    emc.count = 3;
    emc.candidates = 6;
    emc.resolution = 32;
    emc.caustic_photons = 300;
    emc.gather_grid = 8;
    emc.gather_points = 1;
    // Else they go on from light, photons or rays of before.
    emc.gather_source = GatherSource::rays;
    emc.gather_endless = emc.gather_guide = false;
    emc.reserved = 0;
    shown.render.shadow_resolution = 64;
    return shown;
}

void edit_block(FrameScene& scene, const std::function<void(Material&)>& alter) {
    auto assets = std::make_shared<SceneAssets>(*scene.assets);
    assets->materials.edit(kBlock, alter);
    assets->serial = next_asset_version();
    scene.assets = assets;
    scene.changes.assets = true;
    scene.changes.materials.push_back(kBlock);
}

struct Change {
    const char* name;
    void (*make)(Shown&);
    bool rays_go_on = false;  // the gather's: those of before serve other points
};

void turn_light(FrameScene& scene) {
    float& candela = scene.lights[0].light.intensity;
    candela = candela > 0 ? 0 : 100;
    scene.changes.lights = true;
}

const Change kChanges[] = {
    {"lamp on or off", [](Shown& s) { turn_light(s.scene); }},
    {"lamp on or off, and a block moved in the dark",
     [](Shown& s) {
         turn_light(s.scene);
         if (s.scene.lights[0].light.intensity == 0) {
             const float x = s.scene.instances[kBlock].transform[3].x;
             move_instance(s.scene, kBlock, glm::translate(mat4(1), vec3(x > 0 ? 0 : 0.2f, 0, 0)));
         }
     }},
    {"lamp moved",
     [](Shown& s) {
         float& x = s.scene.lights[0].position.x;
         x = x > 0.9f ? 0.6f : x + 0.1f;
         s.scene.changes.lights = true;
     }},
    {"camera moved",
     [](Shown& s) {
         s.scene.camera.position.x -= 0.02f;
         s.scene.camera.view = glm::translate(s.scene.camera.view, vec3(0.02f, 0, 0));
         s.scene.changes.camera = true;
     },
     true},
    {"block painted",
     [](Shown& s) {
         edit_block(s.scene, [](Material& m) { m.base_colour.y = m.base_colour.y > 0.5f ? 0.3f : 0.8f; });
         s.scene.changes.painted = {kBlock};
     }},
    {"another resolution of the light maps",
     [](Shown& s) { s.render.shadow_resolution = s.render.shadow_resolution == 64 ? 128 : 64; }},
    {"another size", [](Shown& s) { s.size.y = s.size.y == 40 ? 32 : 40; }},
    {"photons", [](Shown& s) { s.settings.photons = s.settings.photons == 600 ? 500 : 600; }},
    {"caustics",
     [](Shown& s) {
         int& photons = s.settings.edit<EmcSettings>().caustic_photons;
         photons = photons == 300 ? 0 : photons == 0 ? 200 : 300;
     }},
    {"roughest surface that mirrors",
     [](Shown& s) { s.settings.specular_roughness = s.settings.specular_roughness > 0.2f ? 0.1f : 0.3f; }},
};

// The picture's irradiance and its specular part, once it is still.
std::vector<float> still_picture(Bench& bench, Shown& shown, int frames) {
    bench.settings = shown.settings;
    bench.app.world().insert_resource(shown.render);
    std::vector<float> pixels;
    for (int i = 0; i < frames; ++i) {
        pixels = bench.frame(shown.scene, shown.size).pixels;
        hold_still(shown.scene);
    }
    const auto& light = bench.app.world().resource<render::IndirectLight>();
    if (light.specular != nullptr) {
        const std::vector<float> specular = light.specular->read_floats(4);
        pixels.insert(pixels.end(), specular.begin(), specular.end());
    }
    return pixels;
}

void walk(EmcFinal stage, int steps, int frames) {
    std::minstd_rand random(7);
    std::vector<Change> possible;
    std::ranges::copy_if(kChanges, std::back_inserter(possible), [&](const Change& change) {
        return stage == EmcFinal::splat || !change.rays_go_on;
    });
    Shown shown = room(stage);
    Bench kept;
    still_picture(kept, shown, frames);
    std::string changes;
    for (int step = 0; step < steps; ++step) {
        const Change& change = possible[random() % possible.size()];
        change.make(shown);
        changes += std::string(changes.empty() ? "" : ", ") + change.name;
        // Another one follows at once, or in the next frame.
        if (const auto more = random() % 3; more > 0) {
            if (more == 2) {
                still_picture(kept, shown, 1);
            }
            const Change& other = possible[random() % possible.size()];
            other.make(shown);
            changes += std::string(more == 2 ? ", " : " and ") + other.name;
        }
        const std::vector<float> picture = still_picture(kept, shown, frames);
        Shown fresh_view = shown;
        fresh_view.scene.changes = {};
        Bench fresh;
        const std::vector<float> expected = still_picture(fresh, fresh_view, frames);
        ASSERT_EQ(picture == expected, true) << "after " << changes;
    }
}

TEST(SceneChanges, SplatsAreThoseOfAFreshTechnique) {
    walk(EmcFinal::splat, 30, 3);
}

TEST(SceneChanges, TheGatherIsThatOfAFreshTechnique) {
    walk(EmcFinal::gather, 12, RememberedHits::kFrames + 2);
}

}  // namespace
}  // namespace lanthorn::gi::test
