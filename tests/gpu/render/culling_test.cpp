// What lies outside of a view is not drawn, and nobody can tell from the pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace culling_test {

using testing::SceneBuilder;

constexpr ivec2 kSize(160, 96);

// Boxes and spheres all round the origin, near and far, some of glass; and three kinds of light.
SceneBuilder clutter_all_round() {
    std::mt19937 random(11);
    const auto number = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random()) / static_cast<float>(std::mt19937::max());
    };
    SceneBuilder b;
    std::vector<std::uint32_t> materials;
    for (int i = 0; i < 6; ++i) {
        materials.push_back(b.add_lambert(vec3(number(0.2f, 0.9f), number(0.2f, 0.9f), number(0.2f, 0.9f))));
    }
    Material glass;
    glass.alpha_mode = AlphaMode::blend;
    glass.base_colour = vec4(0.3f, 0.6f, 0.9f, 0.4f);
    materials.push_back(b.add_material(glass));
    for (int i = 0; i < 150; ++i) {
        const vec3 direction = glm::normalize(vec3(number(-1, 1), number(-1, 1), number(-1, 1)));
        const vec3 centre = direction * number(2, 12);
        const std::uint32_t material = materials[static_cast<std::size_t>(i) % materials.size()];
        if (i % 5 == 0) {
            b.add_sphere(material, centre, number(0.2f, 0.8f));
        } else {
            b.add_box(material, centre, vec3(number(0.1f, 1), number(0.1f, 1), number(0.1f, 1)),
                      number(0, 3));
        }
    }
    b.add_point(vec3(0.5f, 1, -0.3f), 300);
    b.add_spot(vec3(-3, 4, 1), vec3(0.4f, -1, -0.2f), 2000, 0.3f, 0.6f);
    b.add_directional(vec3(0.3f, -1, 0.2f), 5);
    return b;
}

// The same scene with every box so large, about its own centre, that no view is without it.
FrameScene never_culled(FrameScene scene) {
    for (Instance& instance : scene.instances) {
        const vec3 centre = instance.bounds.centre();
        instance.bounds = {centre - 1000.0f, centre + 1000.0f};
    }
    return scene;
}

struct Picture {
    int drawn = 0;
    std::vector<std::vector<float>> values;
};

Picture picture(const FrameScene& scene) {
    render::FrameRenderer renderer;
    renderer.settings.shadow_resolution = 64;
    testing::render_once(renderer, scene, kSize);
    Picture result;
    result.drawn = renderer.gbuffer().instances_drawn();
    for (const render::Aov aov : {render::Aov::final, render::Aov::radiance, render::Aov::direct,
                                  render::Aov::albedo, render::Aov::normal, render::Aov::depth}) {
        result.values.push_back(renderer.read(aov).pixels);
    }
    result.values.push_back(renderer.light_maps().distance().read_floats(1));
    result.values.push_back(renderer.light_maps().albedo().read_floats(4));
    return result;
}

int count_opaque(const FrameScene& scene) {
    return static_cast<int>(std::ranges::count_if(scene.instances, [&](const Instance& i) {
        return scene.assets->materials[scene.assets->meshes[i.mesh].material].alpha_mode != AlphaMode::blend;
    }));
}

TEST(Culling, PicturesAreBitEqualWithAndWithoutIt) {
    testing::context();
    SceneBuilder b = clutter_all_round();
    int view = 0, drawn = 0, all = 0;
    const auto compare = [&] {
        const FrameScene scene = b.build();
        const Picture with = picture(scene), without = picture(never_culled(scene));
        ASSERT_EQ(without.drawn, count_opaque(scene));
        EXPECT_LT(with.drawn, without.drawn);
        drawn += with.drawn;
        all += without.drawn;
        for (std::size_t i = 0; i < with.values.size(); ++i) {
            EXPECT_EQ(with.values[i], without.values[i]) << "view " << view << ", image " << i;
        }
        ++view;
    };
    for (const vec3& to : {vec3(1, 0, 0), vec3(-1, 0.2f, 0), vec3(0.1f, 1, 0.1f), vec3(0.3f, -0.5f, 1)}) {
        b.look(vec3(0), to, 1.0f);
        compare();
    }
    b.look(vec3(9, 3, 9), vec3(0), 0.6f);
    compare();
    b.look_orthographic(vec3(0, 0, 4), vec3(0, 0, 3), 4, 3);
    compare();
    EXPECT_LT(drawn, all / 2) << "of the opaque instances in all views";
    EXPECT_GT(drawn, all / 20);
}

TEST(Culling, DeformedMeshesAreWhereTheirVerticesAre) {
    testing::context();
    SceneBuilder b;
    const std::uint32_t grey = b.add_lambert(vec3(0.5f));
    const std::uint32_t quad =
        b.add_quad(grey, vec3(0, 0, 5), vec3(1, 0, 0), vec3(0, 1, 0));  // behind the camera
    b.add_quad(grey, vec3(0, -1, -5), vec3(3, 0, 0), vec3(0, 0, -3));
    b.add_point(vec3(0, 1, -2), 100);
    b.look(vec3(0), vec3(0, 0, -1), 1);
    FrameScene scene = b.build();
    EXPECT_EQ(picture(scene).drawn, 1);
    auto vertices = std::make_shared<std::vector<VertexFrame>>();
    DeformedMesh deformed;
    for (const Vertex& v : scene.assets->meshes[quad].vertices) {
        vertices->push_back({v.position - vec3(0, 0, 10), v.normal, v.tangent});
        deformed.bounds.add(vertices->back().position);
    }
    deformed.version = 1;
    deformed.vertices = std::move(vertices);
    scene.deformed.push_back(deformed);
    scene.instances[quad].deformed = 0;
    scene.instances[quad].version = 1;
    scene.instances[quad].bounds = deformed.bounds;
    const Picture seen = picture(scene);
    EXPECT_EQ(seen.drawn, 2);
    EXPECT_EQ(seen.values, picture(never_culled(scene)).values);
    const std::vector<float>& depth = seen.values[5];
    EXPECT_NEAR(depth[static_cast<std::size_t>(kSize.y / 2 * kSize.x + kSize.x / 2)], 5, 1e-2);
}

}  // namespace culling_test
}  // namespace lanthorn
