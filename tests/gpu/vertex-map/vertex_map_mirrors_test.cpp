// Mirrors under `vertex-map`: what one shows is what a camera behind it sees, and what the path tracer finds.
#include "tests/gpu/gi/mirror_room.h"
#include "tests/gpu/vertex-map/vertex_map_bench.h"

namespace lanthorn::gi::test {
namespace {

const Material kMirror = metal(vec3(1), 0);

// All photons are shot anew at once when something changes, and triangles stay as they are split at first:
// then a picture does not depend on what was seen before.
struct Mirrors : VertexMap {
    Mirrors() {
        own().per_frame = own().total;
        own().density = 0;
    }
};

TEST(VertexMapMirrors, ShowWhatACameraBehindThemSees) {
    Mirrors before, behind;
    expect_the_view_from_behind("vertex-map", before, behind, kSize);
    EXPECT_GT(before.now().mirror_rays, 10'000u);
    EXPECT_EQ(behind.now().mirror_rays, 0u);
}

TEST(VertexMapMirrors, ShowTheWallsThatThePathTracerFinds) {
    VertexMap bench;
    bench.own().total = bench.own().per_frame = 200'000;
    bench.own().nearest = 500;
    bench.own().max_level = 4;
    expect_the_walls_that_the_path_tracer_finds("vertex-map", bench, kSize, 4);
}

TEST(VertexMapMirrors, ALampThatMovesIsSeenInThemWithoutRays) {
    Mirrors kept, fresh;
    expect_a_lamp_to_be_followed(kept, fresh, kSize, [&] { EXPECT_EQ(kept.now().mirror_rays, 0u); });
}

// The first of the instances, and of many triangles: without it all others have other numbers.
FrameScene room_behind_a_mirror() {
    const FrameScene room = mirror_room(kMirror);
    std::vector<Mesh> meshes{room.assets->meshes[7]};
    for (std::size_t i = 0; i < 7; ++i) {
        meshes.push_back(room.assets->meshes[i]);
    }
    FrameScene scene = scene_of(std::move(meshes),
                                {lambertian(vec3(0.7f)), lambertian(vec3(0.2f, 0.3f, 0.7f)),
                                 lambertian(vec3(0.7f, 0.3f, 0.2f)), kMirror},
                                room.lights, vec3(2, 1.3f, 2), vec3(4, 1, 1.2f));
    scene.camera.camera.y_fov = 0.6f;
    return scene;
}

// All of the instances, which a fresh technique has not seen yet.
FrameScene unseen(FrameScene scene) {
    scene.changes = {};
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        scene.changes.moved.push_back(i);
        scene.changes.dirty.add(scene.instances[i].bounds);
    }
    return scene;
}

TEST(VertexMapMirrors, LeaveNothingBehindWhenTheyGo) {
    Mirrors kept, fresh;
    kept.own().edge = fresh.own().edge = 0.02f;
    FrameScene scene = room_behind_a_mirror();
    radiance_of(kept, scene, kSize);
    EXPECT_GT(kept.now().mirror_rays, 10'000u);
    hold_still(scene);
    scene.changes.geometry = true;
    scene.changes.dirty = scene.instances[0].bounds;
    scene.instances.erase(scene.instances.begin());
    const ImageF after = radiance_of(kept, scene, kSize);
    EXPECT_FALSE(kept.technique().statistics(false).plan.on("mirrors"));
    EXPECT_EQ(after.pixels, radiance_of(fresh, unseen(scene), kSize).pixels);
    EXPECT_EQ(kept.now().estimates, fresh.now().estimates);  // of what is seen now alone
}

// Nor when their rays are turned off while something comes or goes.
TEST(VertexMapMirrors, LeaveNothingBehindWhenTheirRaysAreTurnedOff) {
    Mirrors kept, fresh;
    FrameScene scene = room_behind_a_mirror();
    radiance_of(kept, scene, kSize);
    hold_still(scene);
    kept.settings.specular_roughness = fresh.settings.specular_roughness = 0;
    scene.changes.geometry = true;
    scene.changes.dirty = scene.instances[6].bounds;
    scene.instances.erase(scene.instances.begin() + 6);
    const ImageF after = radiance_of(kept, scene, kSize);
    EXPECT_EQ(after.pixels, radiance_of(fresh, unseen(scene), kSize).pixels);
    EXPECT_EQ(kept.now().estimates, fresh.now().estimates);
}

// Photons meet coarser shapes then; mirrors show the scene as it is drawn.
TEST(VertexMapMirrors, ShowFineShapesWherePhotonsMeetCoarseOnes) {
    const auto ball_in_a_mirror = [](float simplify) {
        FrameScene scene = mirror_room(kMirror);
        FrameScene with_ball =
            scene_of({scene.assets->meshes[0], scene.assets->meshes[1], scene.assets->meshes[2],
                      scene.assets->meshes[3], scene.assets->meshes[4], scene.assets->meshes[6],
                      scene.assets->meshes[7], support::sphere(vec3(1, 1.3f, 1.5f), 0.5f, 4, false, 0)},
                     {lambertian(vec3(0.7f)), lambertian(vec3(0.2f, 0.3f, 0.7f)),
                      lambertian(vec3(0.7f, 0.3f, 0.2f)), kMirror},
                     scene.lights, vec3(2.6f, 1.3f, 1.5f), vec3(4, 1.3f, 1.5f));
        Mirrors bench;
        bench.own().simplify = simplify;
        return radiance_of(bench, with_ball, kSize);
    };
    const ImageF fine = ball_in_a_mirror(0), coarse = ball_in_a_mirror(0.1f);
    double squares = 0;
    for (std::size_t i = 0; i < fine.pixels.size(); ++i) {
        squares += std::pow(static_cast<double>(fine.pixels[i] - coarse.pixels[i]), 2);
    }
    const double off = std::sqrt(squares / static_cast<double>(fine.pixels.size())) / mean_of(fine);
    std::printf("vertex-map, mirrored ball, simplified: off by %.4f\n", off);
    EXPECT_GT(off, 0);    // the same to the bit if photons met the fine shapes too
    EXPECT_LT(off, 0.1);  // other photons; a coarser outline is off by a third
}

}  // namespace
}  // namespace lanthorn::gi::test
