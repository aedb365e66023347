#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "tests/support/repository.h"
#include "tests/support/scene_names.h"
#include "tools/scene_generator/glb_bytes.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {
namespace {

std::string file_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

const NodeData& node(const SceneData& scene, const std::string& name) {
    for (const NodeData& candidate : scene.nodes) {
        if (candidate.name == name) {
            return candidate;
        }
    }
    throw std::runtime_error("no node " + name);
}

Aabb world_bounds(const SceneData& scene, const NodeData& n) {
    Aabb result;
    for (const std::uint32_t mesh : n.meshes) {
        result.add(transformed(scene.meshes[mesh].bounds, mat4(n.local.matrix())));
    }
    return result;
}

class CommittedScene : public testing::TestWithParam<NamedScene> {};
class EveryScene : public testing::TestWithParam<NamedScene> {};

TEST_P(CommittedScene, IsAsGenerated) {
    const std::string path = support::repository_file("assets/" + GetParam().name + ".glb");
    const std::string committed = file_bytes(path);
    ASSERT_FALSE(committed.empty()) << path << " is missing";
    EXPECT_TRUE(committed == glb_bytes(GetParam().make()))
        << path << " differs: run generate_scenes assets and look at what changed";
}

TEST_P(EveryScene, HasCameraAndLight) {
    const SceneData scene = GetParam().make();
    EXPECT_FALSE(scene.cameras.empty());
    bool emits = false;
    for (const Material& material : scene.materials) {
        emits = emits || material.emits();
    }
    EXPECT_TRUE(emits || !scene.lights.empty());
}

TEST_P(EveryScene, NormalsAgreeWithWinding) {
    const SceneData scene = GetParam().make();
    for (const Mesh& mesh : scene.meshes) {
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const Vertex* v[3];
            for (int k = 0; k < 3; ++k) {
                v[k] = &mesh.vertices.at(mesh.indices[i + k]);
                ASSERT_NEAR(glm::length(v[k]->normal), 1, 1e-6) << mesh.name;
            }
            const vec3 n = glm::cross(v[1]->position - v[0]->position, v[2]->position - v[0]->position);
            ASSERT_GT(glm::length(n), 0) << mesh.name << " has a triangle without area";
            for (const Vertex* vertex : v) {
                ASSERT_GT(glm::dot(glm::normalize(n), vertex->normal), 0.9) << mesh.name;
            }
        }
    }
}

// Every edge of a solid is shared by two triangles that run along it in opposite directions, and its faces
// look outwards.
TEST_P(EveryScene, SolidsAreClosed) {
    const SceneData scene = GetParam().make();
    using Point = std::tuple<float, float, float>;
    for (const Mesh& mesh : scene.meshes) {
        const bool boxed = GetParam().name == "cornell" || GetParam().name == "mirror-balls" ||
                           GetParam().name == "near-lamp" || GetParam().name.starts_with("thesis-box");
        if (boxed && mesh.name.find("block") == std::string::npos &&
            mesh.name.find("ball") == std::string::npos) {
            continue;  // the box itself is open to the camera, or of walls that are meshes of their own
        }
        if (mesh.name == "water") {
            continue;  // a sheet between banks
        }
        if (scene.materials.at(mesh.material).double_sided) {
            continue;  // a cloth
        }
        if (scene.materials.at(mesh.material).emits() && mesh.indices.size() == 6) {
            continue;  // a flat lamp
        }
        std::map<std::pair<Point, Point>, int> edges;
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const auto point = [&](std::size_t k) {
                const vec3 p = mesh.vertices[mesh.indices[k]].position;
                return Point(p.x, p.y, p.z);
            };
            const Point a = point(i), b = point(i / 3 * 3 + (i + 1) % 3);
            ++edges[{a, b}];
            --edges[{b, a}];
        }
        for (const auto& [edge, balance] : edges) {
            ASSERT_EQ(balance, 0) << mesh.name << " is open";
        }
        double volume = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) {
                return dvec3(mesh.vertices[mesh.indices[i + k]].position);
            };
            volume += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
        }
        const bool inward = GetParam().name == "furnace-sphere" || mesh.name == "rock";  // seen from within
        EXPECT_TRUE(inward ? volume < 0 : volume > 0) << mesh.name << " is inside out";
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, CommittedScene, testing::ValuesIn(all_scenes()), support::scene_name);
INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(all_scenes()), support::scene_name);
INSTANTIATE_TEST_SUITE_P(Levels, CommittedScene, testing::ValuesIn(level_scenes()), support::scene_name);
INSTANTIATE_TEST_SUITE_P(Levels, EveryScene, testing::ValuesIn(level_scenes()), support::scene_name);
INSTANTIATE_TEST_SUITE_P(LargeScenes, EveryScene, testing::ValuesIn(large_scenes()), support::scene_name);

// In no list: too large for a file that nothing needs.
TEST(DragonSized, HasTheDragonsTrianglesAndItsOutsideOut) {
    const SceneData scene = dragon_sized();
    std::size_t triangles = 0;
    for (const Mesh& mesh : scene.meshes) {
        triangles += mesh.indices.size() / 3;
        double volume = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]]; };
            const dvec3 a(corner(0).position), b(corner(1).position), c(corner(2).position);
            const dvec3 n = glm::cross(b - a, c - a);
            volume += glm::dot(a, n) / 6;
            ASSERT_GT(glm::dot(n, dvec3(corner(0).normal)), 0) << mesh.name << " " << i;
        }
        EXPECT_GT(volume, 0) << mesh.name << " is inside out";
    }
    EXPECT_NEAR(static_cast<double>(triangles), 871'414, 500);  // Frisvad et al. 2005, sec. 6
}

TEST(Cornell, MatchesTheMeasuredBox) {
    const SceneData scene = cornell();
    const Aabb red = world_bounds(scene, node(scene, "red-wall"));
    const Aabb green = world_bounds(scene, node(scene, "green-wall"));
    EXPECT_LT(red.upper.x, green.lower.x) << "red is on the left of a camera that looks along -z";
    EXPECT_NEAR(green.size().y, 0.5488f, 1e-6);
    EXPECT_NEAR(green.size().z, 0.5592f, 1e-6);
    const Aabb lamp = world_bounds(scene, node(scene, "lamp"));
    EXPECT_NEAR(lamp.size().x, 0.130f, 1e-6);
    EXPECT_NEAR(lamp.size().z, 0.105f, 1e-6);
    EXPECT_NEAR(glm::degrees(scene.cameras.at(0).y_fov), 39.31, 0.01);
    // White is nearly grey; the coloured walls reflect their colour at least five times as well as the
    // others.
    const vec3 white = scene.materials.at(0).base_colour, r = scene.materials.at(1).base_colour,
               g = scene.materials.at(2).base_colour;
    EXPECT_NEAR(white.r / white.b, 1, 0.01);
    EXPECT_NEAR(white.g, 0.736, 0.01);
    EXPECT_GT(r.r, 5 * std::max(r.g, r.b));
    EXPECT_GT(g.g, 4.5f * std::max(g.r, g.b));
}

TEST(LanternRoom, ClosedDoorFillsTheDoorway) {
    const SceneData scene = lantern_room();
    const Aabb door = world_bounds(scene, node(scene, "door"));
    const Aabb left = world_bounds(scene, node(scene, "divider-left"));
    const Aabb right = world_bounds(scene, node(scene, "divider-right"));
    const Aabb lintel = world_bounds(scene, node(scene, "divider-lintel"));
    EXPECT_LE(door.lower.z, left.upper.z);
    EXPECT_GE(door.upper.z, right.lower.z);
    EXPECT_LE(door.lower.y, 0);
    EXPECT_GE(door.upper.y, lintel.lower.y);
    EXPECT_NEAR(right.lower.z - left.upper.z, 1.0f, 1e-6);
    EXPECT_NEAR(lintel.lower.y, 2.1f, 1e-6);
}

// A door that stands open, clear of the doorway, and nothing else that differs.
TEST(LanternRoom, OpenDoorLeavesTheDoorwayFree) {
    const SceneData closed = lantern_room(), open = lantern_room_open();
    ASSERT_EQ(open.nodes.size(), closed.nodes.size());
    for (std::size_t i = 0; i < open.nodes.size(); ++i) {
        const Transform &a = open.nodes[i].local, &b = closed.nodes[i].local;
        EXPECT_EQ(a.translation, b.translation) << open.nodes[i].name;
        EXPECT_EQ(a.rotation == b.rotation, open.nodes[i].name != "door") << open.nodes[i].name;
        EXPECT_EQ(open.nodes[i].extras, closed.nodes[i].extras);
    }
    const Aabb door = world_bounds(open, node(open, "door"));
    EXPECT_GT(door.lower.x, world_bounds(open, node(open, "divider-left")).lower.x) << "on the dark side";
    EXPECT_LT(door.upper.z, world_bounds(open, node(open, "divider-left")).upper.z + 0.1f);
    EXPECT_NE(node(open, "dark").camera, kNone);
}

TEST(LanternRoom, LampShinesAwayFromTheDarkHalf) {
    const SceneData scene = lantern_room();
    const NodeData& lamp = node(scene, "lamp");
    const Light& light = scene.lights.at(lamp.light);
    ASSERT_EQ(light.type, LightType::spot);
    const vec3 direction = lamp.local.rotation * vec3(0, 0, -1);
    const float to_dark_half = std::acos(glm::dot(direction, vec3(1, 0, 0)));
    EXPECT_GT(to_dark_half - light.outer_cone, glm::radians(90.0f)) << "some ray of the cone has +x";
    EXPECT_LT(lamp.local.translation.x, 0);
}

TEST(LanternRoom, LanternOnItsTableDoesNotShineThroughTheDoorway) {
    const SceneData scene = lantern_room();
    const dvec3 p = node(scene, "lantern").local.translation;
    const Aabb right = world_bounds(scene, node(scene, "divider-right"));
    const Aabb left = world_bounds(scene, node(scene, "divider-left"));
    // The ray that just passes the near jamb's lit edge must meet the far jamb inside the wall's thickness.
    const double slope = (right.lower.z - p.z) / (right.lower.x - p.x);
    EXPECT_LT(p.z + slope * (right.upper.x - p.x), left.upper.z);
}

TEST(LanternRoom, HasWhatTheGameLooksFor) {
    const SceneData scene = lantern_room();
    for (const auto& [name, component] : {std::pair("far_sensor", "light_sensor"),
                                          {"far_sensor", "goal"},
                                          {"door", "door"},
                                          {"door", "kinematic"},
                                          {"lantern", "lantern"},
                                          {"player", "character"},
                                          {"player-eyes", "eyes"},
                                          {"crate-1", "collider"},
                                          {"floor", "collider"},
                                          {"divider-left", "collider"}}) {
        EXPECT_NE(node(scene, name).extras.find(component), std::string::npos) << name;
    }
    EXPECT_GT(node(scene, "far_sensor").local.translation.x, 0);
    EXPECT_EQ(scene.lights.at(node(scene, "lantern-light").light).intensity, 15);
}

TEST(Clutter, BoxesFloatApart) {
    const SceneData scene = clutter();
    const Aabb room{{-3, 0, -3}, {3, 4, 3}};
    int boxes = 0;
    for (const NodeData& n : scene.nodes) {
        if (n.name.rfind("box-", 0) == 0) {
            ++boxes;
            const Aabb b = world_bounds(scene, n);
            EXPECT_TRUE(glm::all(glm::greaterThan(b.lower, room.lower)) &&
                        glm::all(glm::lessThan(b.upper, room.upper)))
                << n.name;
        }
    }
    EXPECT_EQ(boxes, 40);
}

// What is seen of the dark leg has no light but reflected light: the wall round the corner is in the way.
TEST(Corridor, TheLampIsRoundTheCorner) {
    const SceneData scene = corridor();
    const dvec3 lamp(node(scene, "lamp").local.translation), eye(node(scene, "camera").local.translation);
    const Aabb wall = world_bounds(scene, node(scene, "dark-wall"));
    const double share = (static_cast<double>(wall.upper.z) - eye.z) / (lamp.z - eye.z);
    const dvec3 through = eye + share * (lamp - eye);
    EXPECT_TRUE(share > 0 && share < 1);
    EXPECT_TRUE(through.x > static_cast<double>(wall.lower.x) &&
                through.x < static_cast<double>(wall.upper.x));
    EXPECT_TRUE(through.y > 0 && through.y < static_cast<double>(wall.upper.y));
}

TEST(Furnished, HasFortyThingsOnItsShelvesAndThinLegs) {
    const SceneData scene = furnished();
    int things = 0, legs = 0;
    for (const NodeData& n : scene.nodes) {
        if (n.name.starts_with("thing-")) {
            ++things;
            const Aabb b = world_bounds(scene, n);
            bool stands = false;
            for (const NodeData& board : scene.nodes) {
                const Aabb under = world_bounds(scene, board);
                stands = stands || (board.name.find("-board-") != std::string::npos &&
                                    std::abs(b.lower.y - under.upper.y) < 1e-3f &&
                                    b.lower.x > under.lower.x && b.upper.x < under.upper.x &&
                                    b.lower.z > under.lower.z && b.upper.z < under.upper.z);
            }
            EXPECT_TRUE(stands) << n.name;
        }
        if (n.name.starts_with("chair-") && n.name.find("-leg-") != std::string::npos) {
            ++legs;
            const Aabb& b = scene.meshes.at(n.meshes.at(0)).bounds;
            EXPECT_NEAR(b.upper.x - b.lower.x, 0.03, 1e-6) << n.name;
        }
    }
    EXPECT_EQ(things, 40);
    EXPECT_EQ(legs, 16);
}

std::size_t count_named(const SceneData& scene, const std::string& prefix) {
    return static_cast<std::size_t>(std::ranges::count_if(scene.nodes, [&](const NodeData& n) {
        return n.name.rfind(prefix, 0) == 0 && n.meshes.size() == 1;
    }));
}

TEST(Building, HasFiftyRoomsTenLampsOfTheirOwnColoursAndDoorsThatSwing) {
    const SceneData scene = building();
    EXPECT_EQ(count_named(scene, "walls-"), 50u);
    EXPECT_NEAR(node(scene, "room-49").local.translation.y, 3, 1e-9) << "the second floor";
    std::set<std::tuple<float, float, float>> colours;
    for (const Light& light : scene.lights) {
        colours.emplace(light.colour.r, light.colour.g, light.colour.b);
    }
    EXPECT_EQ(colours.size(), 10u);
    ASSERT_EQ(scene.animations.size(), 1u);
    const std::vector<AnimationChannel>& swings = scene.animations[0].channels;
    EXPECT_EQ(swings.size(), count_named(scene, "door-"));
    EXPECT_GE(swings.size(), 30u);
    for (const AnimationChannel& swing : swings) {
        const auto y = [&](std::size_t key) { return swing.values.at(4 * key + 1); };
        EXPECT_GT(std::abs(y(2) - y(1)), 0.7f) << scene.nodes[swing.node].name << " swings wide";
        EXPECT_EQ(y(0), y(5)) << "and comes back";
        EXPECT_NEAR(scene.nodes[swing.node].local.rotation.y, y(0), 1e-6f) << "it begins where it stands";
    }
}

// What is measured is what more lamps cost, not more light.
TEST(TwoRooms, MoreLampsShareTheLightOfOne) {
    const SceneData one = two_rooms();
    for (const auto& [made, lamps] : {std::pair(two_rooms_lamps_4(), 4u), {two_rooms_lamps_16(), 16u}}) {
        double candela = 0;
        std::set<double> heights;
        for (const NodeData& n : made.nodes) {
            if (n.name.starts_with("lamp")) {
                candela += static_cast<double>(made.lights.at(n.light).intensity);
                heights.insert(n.local.translation.y);
                EXPECT_LT(glm::distance(n.local.translation, node(one, "lamp").local.translation), 0.4);
            }
        }
        EXPECT_NEAR(candela, static_cast<double>(one.lights.at(0).intensity), 1e-3);
        EXPECT_EQ(heights.size(), lamps);  // all of them, no two in one place
        EXPECT_EQ(made.triangle_count(), one.triangle_count());
    }
}

// What is measured is what more rooms cost, not more lamps or another picture.
TEST(Building, FewerRoomsAreTheFirstRoomsOfTheWhole) {
    const SceneData whole = building();
    for (const auto& [part, rooms] : {std::pair(building_of_10(), 10u), {building_of_25(), 25u}}) {
        EXPECT_EQ(count_named(part, "walls-"), rooms);
        EXPECT_EQ(part.lights.size(), whole.lights.size());
        EXPECT_EQ(node(part, "camera").local.translation, node(whole, "camera").local.translation);
        EXPECT_EQ(node(part, "lamp-0").local.translation, node(whole, "lamp-0").local.translation);
        for (const char* name : {"walls-0", "door-0-x"}) {
            const Mesh& a = part.meshes.at(node(part, name).meshes.at(0));
            const Mesh& b = whole.meshes.at(node(whole, name).meshes.at(0));
            EXPECT_EQ(a.bounds.lower, b.bounds.lower) << name;
            EXPECT_EQ(a.bounds.upper, b.bounds.upper) << name;
        }
    }
}

// The stairs end on the floor above, under a hole in both slabs.
TEST(Building, TheStairsLeadThroughAHole) {
    const SceneData scene = building();
    const auto meets = [&](const std::string& name, const vec3& p) {  // from above and below, within its slab
        const Mesh& mesh = scene.meshes.at(node(scene, name).meshes.at(0));
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const vec3 a = mesh.vertices[mesh.indices[i]].position;
            const vec3 b = mesh.vertices[mesh.indices[i + 1]].position;
            const vec3 c = mesh.vertices[mesh.indices[i + 2]].position;
            const auto side = [&](const vec3& u, const vec3& v) {
                return (v.x - u.x) * (p.z - u.z) - (v.z - u.z) * (p.x - u.x);
            };
            const float s = side(a, b), t = side(b, c), u = side(c, a);
            if ((s > 0 && t > 0 && u > 0) || (s < 0 && t < 0 && u < 0)) {
                return true;
            }
        }
        return false;
    };
    const vec3 steps(0.4f, 0, 1.4f), beside(0.4f, 0, -1.3f);
    for (const char* slab : {"ceiling-24", "floor-49"}) {
        EXPECT_FALSE(meets(slab, steps)) << slab;
        EXPECT_TRUE(meets(slab, beside)) << slab;
    }
    const Aabb& stairs = scene.meshes.at(node(scene, "stairs").meshes.at(0)).bounds;
    EXPECT_NEAR(stairs.upper.y, 3 - 0.2f, 1e-5f) << "one step below the floor";
}

std::uint64_t placed_triangles(const SceneData& scene) {
    std::uint64_t count = 0;
    for (const NodeData& n : scene.nodes) {
        for (const std::uint32_t mesh : n.meshes) {
            count += scene.meshes[mesh].indices.size() / 3;
        }
    }
    return count;
}

// Yao et al. 2010, Table 1.
TEST(ScenesOfThePaper, AreAsLargeAsItsOwn) {
    EXPECT_NEAR(static_cast<double>(placed_triangles(nave())), 79000, 5000);
    EXPECT_NEAR(static_cast<double>(placed_triangles(diffuse_box())), 15000, 1000);
    EXPECT_NEAR(static_cast<double>(placed_triangles(dimpled())), 21000, 1000);
    EXPECT_NEAR(static_cast<double>(placed_triangles(pool())), 54000, 2000);
    EXPECT_LE(placed_triangles(living_room()), 84000u);
}

TEST(ScenesOfThePaper, GlassAndWaterBoundVolumes) {
    const std::pair<SceneData, int> cases[] = {
        {glass_ball(), 1}, {dimpled(), 1}, {pool(), 1}, {living_room(), 3}};
    for (const auto& [scene, expected] : cases) {
        int volumes = 0;
        for (const Mesh& mesh : scene.meshes) {
            volumes += scene.materials.at(mesh.material).bounds_volume() ? 1 : 0;
        }
        EXPECT_EQ(volumes, expected);
    }
}

// A square image repeats over a floor whose UVs are in metres.
TEST(Textures, RepeatByTheMetre) {
    const SceneData scene = pool();
    const Mesh& bottom = scene.meshes.at(node(scene, "bottom").meshes.at(0));
    const TextureRef& tiles = scene.materials.at(bottom.material).base_colour_texture;
    ASSERT_TRUE(tiles.present());
    const Image& image = scene.images.at(scene.textures.at(tiles.texture).image);
    EXPECT_EQ(image.rgba.size(), std::size_t{4} * image.width * image.height);
    float widest = 0;
    for (const Vertex& a : bottom.vertices) {
        for (const Vertex& b : bottom.vertices) {
            widest = std::max(widest, glm::dot(tiles.uv_transform[0], vec3(a.uv0 - b.uv0, 0)));
        }
    }
    EXPECT_NEAR(widest, 6 / 0.6, 1e-4) << "6 m of a basin";
}

TEST(Pool, TheWaterIsAHeightFieldOfTravellingWaves) {
    const SceneData scene = pool();
    const Mesh& water = scene.meshes.at(node(scene, "water").meshes.at(0));
    EXPECT_NEAR(static_cast<double>(water.indices.size() / 3), 54000, 500);
    EXPECT_EQ(water.morphs.size(), water.morph_weights.size());
    for (const MorphTarget& target : water.morphs) {
        EXPECT_EQ(target.vertices.size(), water.vertices.size());
        for (const vec3& p : target.positions) {
            ASSERT_EQ(p.x, 0);
            ASSERT_EQ(p.z, 0);
        }
    }
}

TEST(Crowd, AHundredShareTheirMeshes) {
    const SceneData scene = crowd();
    EXPECT_EQ(scene.skins.size(), 100u);
    EXPECT_EQ(scene.meshes.size(), puppet().meshes.size() - 2);  // its ball and pedestal are not here
    EXPECT_EQ(scene.animations.size(), 1u);
}

}  // namespace
}  // namespace lanthorn::scene_generator
