// Maps of many triangles, drawn of those alone that rays have seen, are the maps drawn of all.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "gi_module/shared/rays/embree_rays.h"
#include "gi_module/shared/rays/exact_rays.h"
#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "gi_module/techniques/emc/maps/layered_maps.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr int kMany = 100;  // 20 000 triangles: more than eight a texel of a face of 32 x 32

// Hills of 2 * side^2 triangles over 4 m x 4 m.
Mesh hills(int side, std::uint32_t material) {
    Mesh mesh;
    mesh.material = material;
    for (int j = 0; j <= side; ++j) {
        for (int i = 0; i <= side; ++i) {
            Vertex v;
            const vec2 p = 4.0f * vec2(i, j) / static_cast<float>(side);
            v.position = vec3(p.x, 0.2f * std::sin(3 * p.x) * std::cos(4 * p.y), p.y);
            v.normal = vec3(0, 1, 0);
            mesh.vertices.push_back(v);
            mesh.bounds.add(v.position);
        }
    }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (side + 1) + i); };
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            for (const std::uint32_t k :
                 {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i + 1, j)}) {
                mesh.indices.push_back(k);
            }
        }
    }
    return mesh;
}

// Hills under a roof of two sheets in one place, a post, and a block that will move.
FrameScene hills_and_things(int side) {
    FrameScene scene = scene_of(
        {hills(side, 0), box(vec3(0, 2, 0), vec3(4, 2, 4), false, 1),
         box(vec3(1, -0.2f, 1), vec3(1.2f, 1.5f, 1.2f), false, 1), box(vec3(-0.3f), vec3(0.3f), false, 1)},
        {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))}, {point_light(vec3(2, 1, 2), 100)},
        vec3(2, 1, 3.8f), vec3(2, 0, 1));
    return scene;
}

void place_block(FrameScene& scene, const vec3& at) {
    hold_still(scene);
    mat4 transform(1);
    transform[3] = vec4(at, 1);
    move_instance(scene, 3, transform);
    scene.instances[3].is_static = false;
    ++scene.frame;
}

// Counts how often it is asked.
struct CountedSight final : TriangleSight {
    explicit CountedSight(TriangleSight& the_rays) : rays(the_rays) {}
    std::vector<std::vector<SeenTriangle>> see(std::span<const CubeFace> faces,
                                               std::span<const std::uint8_t> stands) override {
        ++asked;
        return rays.see(faces, stands);
    }
    bool whole(std::uint32_t instance) const override { return rays.whole(instance); }

    TriangleSight& rays;
    int asked = 0;
};

struct Maps {
    Maps(MapUse use, int resolution, TriangleSight* by) : layered(use, 3, resolution), sight(by) {
        layered.place(0, vec3(0.7f, 0.6f, 0.8f));
        layered.place(1, vec3(3.1f, 1.1f, 1.9f));
        layered.place(2, vec3(2.03f, 0.31f, 2.6f));
    }
    std::vector<float> show(const FrameScene& scene, const render::GpuScene& gpu_scene) {
        layered.update(scene, gpu_scene, {0, 1, 2}, 0, sight);
        const CubeMaps& maps = layered.maps();
        return maps.albedo() ? maps.albedo().read_floats(4) : maps.planes().read_floats(4);
    }
    LayeredMaps layered;
    TriangleSight* sight;
};

// Texels that differ by more than a share of what they are.
double share_that_differs(const std::vector<float>& a, const std::vector<float>& b, float share) {
    EXPECT_EQ(a.size(), b.size());
    std::size_t other = 0;
    for (std::size_t i = 0; i < a.size(); i += 4) {
        bool same = true;
        for (std::size_t k = i; k < i + 4; ++k) {
            same = same && std::abs(a[k] - b[k]) <= share * std::abs(b[k]) + 1e-6f;
        }
        other += same ? 0 : 1;
    }
    return 4.0 * static_cast<double>(other) / static_cast<double>(a.size());
}

class SeenTriangles : public testing::Test {
  protected:
    void SetUp() override {
        context();
        add_embree_rays();
        rays = make_exact_rays();
        sight = std::make_unique<CountedSight>(*rays);
        gpu_scene = std::make_unique<render::GpuScene>();
    }
    void follow(const FrameScene& scene) {
        gpu_scene->update(scene);
        rays->follow(scene, RayDetail::coarser);
    }
    std::unique_ptr<ExactRays> rays;
    std::unique_ptr<CountedSight> sight;
    std::unique_ptr<render::GpuScene> gpu_scene;
};

TEST_F(SeenTriangles, MakeTheMapsThatAllTrianglesMake) {
    FrameScene scene = hills_and_things(kMany);
    follow(scene);
    for (const auto& [use, resolution] : {std::pair(MapUse::coverage, 32), std::pair(MapUse::tracing, 32)}) {
        Maps whole(use, resolution, nullptr), seen(use, resolution, sight.get());
        const std::vector<float> all = whole.show(scene, *gpu_scene);
        EXPECT_LT(share_that_differs(seen.show(scene, *gpu_scene), all, 1e-4f), 2e-4);
    }
    EXPECT_EQ(sight->asked, 2);
}

TEST_F(SeenTriangles, LieBehindWhatMoves) {
    FrameScene scene = hills_and_things(kMany);
    follow(scene);
    place_block(scene, vec3(2, 0.5f, 2));
    follow(scene);
    Maps whole(MapUse::coverage, 32, nullptr), seen(MapUse::coverage, 32, sight.get());
    whole.show(scene, *gpu_scene);
    seen.show(scene, *gpu_scene);
    // It moves while they look on, away from ground that nobody has drawn since.
    for (const vec3& at : {vec3(2.2f, 0.5f, 2), vec3(3.4f, 0.6f, 3.2f), vec3(2, 9, 2)}) {
        place_block(scene, at);
        follow(scene);
        const std::vector<float> all = whole.show(scene, *gpu_scene);
        EXPECT_LT(share_that_differs(seen.show(scene, *gpu_scene), all, 1e-4f), 3e-4);
    }
    EXPECT_GT(sight->asked, 0);
}

TEST_F(SeenTriangles, LetAsGoodMapsBeChosen) {
    FrameScene scene = hills_and_things(kMany);
    follow(scene);
    GiSettings settings;
    settings.edit<EmcSettings>().candidates = 12;
    settings.edit<EmcSettings>().count = 4;
    EnvironmentMaps whole, seen;
    whole.select(scene, *gpu_scene, settings);
    seen.see_by(sight.get());
    seen.select(scene, *gpu_scene, settings);
    EXPECT_GT(sight->asked, 0);
    EXPECT_EQ(seen.count(), whole.count());
    EXPECT_NEAR(seen.statistics().coverage, whole.statistics().coverage, 0.01);
}

}  // namespace
}  // namespace lanthorn::gi::test
