// What a scene is given that has no light of its own.
#include "lanthorn/workbench/load_scene.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <glm/gtx/quaternion.hpp>
#include <tuple>

#include "lanthorn/core/colour.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/extract.h"
#include "tools/workbench/load/default_light.h"

namespace lanthorn::workbench {
namespace {

// A square of 2 m that faces +Z, around `at`.
NodeData square(const dvec3& at) {
    NodeData node;
    node.local.translation = at;
    node.meshes = {0};
    return node;
}

// One square at the origin, seen by a camera 10 m in front of it, 100 km out.
SceneData bare() {
    const dvec3 far_out(1e5, 0, 0);
    SceneData s;
    s.source = "bare.glb";
    s.materials.resize(1);
    Mesh& mesh = s.meshes.emplace_back();
    for (const vec3& p : {vec3(-1, -1, 0), vec3(1, -1, 0), vec3(1, 1, 0), vec3(-1, 1, 0)}) {
        mesh.vertices.emplace_back().position = p;
        mesh.vertices.back().normal = vec3(0, 0, 1);
        mesh.bounds.add(p);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    s.nodes = {square(far_out)};
    NodeData eye;
    eye.name = "eye";
    eye.camera = 0;
    eye.local.translation = far_out + dvec3(0, 0, 10);
    s.nodes.push_back(eye);
    s.cameras.resize(1);
    return s;
}

SceneView through(const std::string& camera) {
    SceneView view;
    view.camera = camera;
    return view;
}

TEST(DefaultLight, IsADaysSkyAndSunUnderTheOpenSky) {
    SceneData s = bare();
    const auto note = add_default_light(s, "");
    ASSERT_TRUE(note);
    EXPECT_NE(note->find("the sky and the sun of a clear day"), std::string::npos) << *note;
    ASSERT_EQ(s.skies.size(), 1u);
    ASSERT_EQ(s.lights.size(), 1u);
    EXPECT_EQ(s.lights[0].type, LightType::directional);
    const vec3 shines = s.nodes.back().local.rotation * vec3(0, 0, -1);
    EXPECT_LT(shines.y, -0.5f) << "from above";
    EXPECT_GT(shines.x, 0.2f) << "from the left of a camera that looks along -Z";
    EXPECT_LT(shines.z, -0.2f) << "from behind it";
    EXPECT_FALSE(add_default_light(s, "")) << "there is one now";
}

// Six squares around the camera, which looks at the one in front of it.
SceneData room() {
    SceneData s = bare();
    const dvec3 eye(1e5, 0, 10);
    s.nodes.erase(s.nodes.begin());
    for (const auto& [axis, angle, at] :
         {std::tuple(vec3(0, 1, 0), 0.0f, dvec3(0, 0, -1)), std::tuple(vec3(0, 1, 0), 180.0f, dvec3(0, 0, 1)),
          std::tuple(vec3(0, 1, 0), 90.0f, dvec3(-1, 0, 0)),
          std::tuple(vec3(0, 1, 0), -90.0f, dvec3(1, 0, 0)), std::tuple(vec3(1, 0, 0), 90.0f, dvec3(0, 1, 0)),
          std::tuple(vec3(1, 0, 0), -90.0f, dvec3(0, -1, 0))}) {
        NodeData wall = square(eye + at);
        wall.local.rotation = glm::angleAxis(glm::radians(angle), axis);
        s.nodes.push_back(wall);
    }
    return s;
}

TEST(DefaultLight, IsALampOverTheShoulderInARoom) {
    SceneData s = room();
    const auto note = add_default_light(s, "eye");
    ASSERT_TRUE(note);
    EXPECT_NE(note->find("over the camera's shoulder"), std::string::npos) << *note;
    EXPECT_TRUE(s.skies.empty());
    ASSERT_EQ(s.lights.size(), 1u);
    EXPECT_EQ(s.lights[0].type, LightType::point);
    const dvec3 at = s.nodes.back().local.translation - dvec3(1e5, 0, 10);
    EXPECT_NEAR(glm::length(at - dvec3(-0.35, 0.35, 0)), 0, 1e-2) << "0.35 of the metre to the wall";
    const double d2 = glm::dot(at - dvec3(0, 0, -1), at - dvec3(0, 0, -1));
    EXPECT_NEAR(static_cast<double>(s.lights[0].intensity), 1000 * d2, 2);
}

TEST(DefaultLight, StaysOnThisSideOfAWall) {
    SceneData s = room();
    NodeData wall = square(dvec3(1e5 - 0.1, 0.1, 10));  // across the way up and to the left
    wall.local.rotation = glm::angleAxis(glm::radians(90.0f), vec3(0, 1, 0));
    s.nodes.insert(s.nodes.begin(), wall);
    ASSERT_TRUE(add_default_light(s, "eye"));
    const dvec3 at = s.nodes.back().local.translation - dvec3(1e5, 0, 10);
    EXPECT_NEAR(at.x, -0.08, 1e-2);
    EXPECT_NEAR(at.y, 0.08, 1e-2);
}

// Adds a sun that shines that way, `lux` on what is square to it.
SceneData with_sun(SceneData s, const vec3& shines, float lux) {
    NodeData node;
    node.light = 0;
    node.local.rotation = glm::rotation(vec3(0, 0, -1), glm::normalize(shines));
    s.nodes.push_back(node);
    Light& sun = s.lights.emplace_back();
    sun.type = LightType::directional;
    sun.intensity = lux;
    return s;
}

TEST(DefaultLight, IsTheSkyOfASunThatHasNone) {
    double shares[2];
    for (const float lux : {100'000.0f, 1.0f}) {
        SceneData s = with_sun(bare(), vec3(1, -1, -1), lux);
        const auto note = add_default_light(s, "");
        ASSERT_TRUE(note);
        EXPECT_NE(note->find("a sun and no sky"), std::string::npos) << *note;
        ASSERT_EQ(s.skies.size(), 1u);
        EXPECT_EQ(s.lights.size(), 1u) << "its own";
        // A clear day's sky gives the ground 5 to 45 % of what its sun gives a surface square to it.
        const SkyImage& image = *s.skies[0].image;
        double on_ground = 0;
        for (std::uint32_t y = 0; y < image.height / 2; ++y) {
            for (std::uint32_t x = 0; x < image.width; ++x) {
                const vec3 way = sky_direction((vec2(x, y) + 0.5f) / vec2(image.width, image.height));
                on_ground += luminance(dvec3(image.at(x, y))) * static_cast<double>(way.y) *
                             image.pixel_solid_angle(y);
            }
        }
        on_ground *= static_cast<double>(s.skies[0].intensity);
        on_ground /= static_cast<double>(lux);
        EXPECT_GT(on_ground, 0.05);
        EXPECT_LT(on_ground, 0.45);
        shares[lux > 1 ? 0 : 1] = on_ground;
    }
    EXPECT_NEAR(shares[0] / shares[1], 1, 1e-5) << "a dim sun has as dim a sky";
}

TEST(DefaultLight, IsNoSkyInARoomOrUnderASunFromBelowOrBesideALamp) {
    SceneData inside = with_sun(room(), vec3(0, -1, -1), 1000);
    EXPECT_FALSE(add_default_light(inside, "eye"));
    SceneData below = with_sun(bare(), vec3(0, 1, -1), 1000);
    EXPECT_FALSE(add_default_light(below, ""));
    SceneData lamp_too = with_sun(bare(), vec3(0, -1, -1), 1000);
    lamp_too.lights.emplace_back();
    lamp_too.nodes[1].light = 1;
    EXPECT_FALSE(add_default_light(lamp_too, ""));
    SceneData dark = with_sun(bare(), vec3(0, -1, -1), 0);
    EXPECT_FALSE(add_default_light(dark, ""));
}

TEST(DefaultLight, OnlyWhereItIsNeededAndCanBeSeen) {
    SceneData lit = bare();
    lit.lights.resize(1);
    lit.nodes[1].light = 0;
    EXPECT_FALSE(add_default_light(lit, ""));
    SceneData glowing = bare();
    glowing.materials[0].emissive = vec3(1);
    EXPECT_FALSE(add_default_light(glowing, ""));
    SceneData empty = bare();
    empty.nodes[0].meshes.clear();
    EXPECT_FALSE(add_default_light(empty, ""));
    SceneData unseen = bare();
    EXPECT_THROW(add_default_light(unseen, "roof"), InputError);
}

// A square of a square centimetre that shines with `nits`.
void add_filament(SceneData& s, float nits, const dvec3& at) {
    s.materials.emplace_back().emissive = vec3(nits);
    s.meshes.push_back(s.meshes[0]);
    s.meshes.back().material = 1;
    NodeData filament = square(at);
    filament.meshes = {1};
    filament.local.scale = vec3(0.005f);
    s.nodes.push_back(filament);
}

TEST(DefaultLight, ComesBesideAFilamentThatIsTooFaintUnderTheOpenSky) {
    SceneData faint = bare();
    add_filament(faint, 1000, dvec3(1e5, 0, 0));  // 0.3 lm on a box of 8 square metres
    const auto note = add_default_light(faint, "");
    ASSERT_TRUE(note);
    EXPECT_NE(note->find("shine faintly or as colours"), std::string::npos) << *note;
    EXPECT_EQ(faint.skies.size(), 1u);
    SceneData bright = bare();
    add_filament(bright, 5000, dvec3(1e5, 0, 0));
    EXPECT_FALSE(add_default_light(bright, ""));
    bright.materials.back().alpha_mode = AlphaMode::blend;
    for (Vertex& v : bright.meshes.back().vertices) {
        v.colour.a = 0.2f;
    }
    EXPECT_TRUE(add_default_light(bright, "")) << "it shines as far as it is covered";
}

// glTF's emissiveFactor is at most 1: whoever means a lamp says how strong it is.
TEST(DefaultLight, ComesBesideColoursThatShine) {
    for (const float nits : {1.0f, 2.0f}) {
        SceneData s = bare();
        s.materials.emplace_back().emissive = vec3(0, 0.5f * nits, nits);
        s.meshes.push_back(s.meshes[0]);
        s.meshes.back().material = 1;
        s.nodes.push_back(square(dvec3(1e5, 0, -1)));
        s.nodes.back().meshes = {1};
        EXPECT_EQ(add_default_light(s, "").has_value(), nits <= 1) << nits;
    }
}

TEST(DefaultLight, LeavesAFaintLampInARoomAlone) {
    SceneData s = room();
    add_filament(s, 1, dvec3(1e5, 0.5, 10));
    EXPECT_FALSE(add_default_light(s, "eye"));
}

TEST(ListedScene, HasTheCameraBehindItsName) {
    const ListedScene plain = listed_scene("a/b.glb", through("front"));
    EXPECT_EQ(plain.file, "a/b.glb");
    EXPECT_EQ(plain.name, "b");
    EXPECT_EQ(plain.view.camera, "front");
    const ListedScene named = listed_scene("a/b@c.glb@dark", through("front"));
    EXPECT_EQ(named.file, "a/b@c.glb");
    EXPECT_EQ(named.name, "b@c-dark");
    EXPECT_EQ(named.view.camera, "dark");
    const std::string whole = "/tmp/lanthorn@" + std::to_string(::getpid()) + ".glb";
    std::ofstream(whole) << "there";
    EXPECT_EQ(listed_scene(whole, {}).file, whole) << "a file of that name is the scene";
    std::filesystem::remove(whole);
}

}  // namespace
}  // namespace lanthorn::workbench
