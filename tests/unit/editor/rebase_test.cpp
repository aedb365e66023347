// Edits on another export of their file: kept where they fit, listed where they do not, on no other node.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <numeric>

#include "lanthorn/core/error.h"
#include "lanthorn/lamplighter/lamplighter.h"
#include "tests/unit/editor/random_commands.h"
#include "tests/unit/tools/run_program.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/node_value.h"

namespace lanthorn::editor {
namespace {

using testing_tools::Dice;
using testing_tools::TemporaryFolder;

// A colleague's scene: which things there are, in no order. `id` stands in the extras, which nothing is
// recognised by.
struct Thing {
    int id;
    int room;  // its parent; -1: none
    std::string name;
    dvec3 at;
    int mesh = -1;  // of so many sides
    bool lit = false;
};

Mesh fan(int sides) {
    Mesh mesh;
    for (int i = 0; i < sides; ++i) {
        Vertex vertex;
        const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(sides);
        vertex.position = vec3(std::cos(angle), std::sin(angle), 0);
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(vertex.position);
        if (i >= 2) {
            mesh.indices.insert(mesh.indices.end(),
                                {0u, static_cast<std::uint32_t>(i - 1), static_cast<std::uint32_t>(i)});
        }
    }
    return mesh;
}

std::vector<Thing> things(Dice& dice) {
    std::vector<Thing> all;
    for (int i = 0; i < 4; ++i) {
        all.push_back({i, -1, "room_" + std::to_string(i), dvec3(10 * i, 0, 0)});
    }
    for (int i = 4; i < 40; ++i) {
        Thing thing{i, static_cast<int>(dice.below(4)), "",
                    dvec3(dice.between(-3, 3), dice.between(0, 3), dice.between(-3, 3))};
        const auto kind = dice.below(4);
        if (kind == 0) {
            thing.lit = true;
            thing.name = "lamp_" + std::to_string(i);
        } else {
            thing.mesh = static_cast<int>(3 + dice.below(6));
            thing.name = kind == 1 ? "crate" : "piece_" + std::to_string(i);  // some share a name
        }
        all.push_back(std::move(thing));
    }
    return all;
}

// As an exporter would write them: rooms first or last, things in any order.
std::string exported(const std::vector<Thing>& all, Dice& dice) {
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = order.size(); i-- > 1;) {
        std::swap(order[i], order[dice.below(i + 1)]);
    }
    std::ranges::stable_partition(order, [&](std::size_t i) { return all[i].room < 0; });
    SceneData scene;
    scene.materials.emplace_back();
    std::map<int, std::uint32_t> node_of, mesh_of;
    for (const std::size_t i : order) {
        const Thing& thing = all[i];
        NodeData node;
        node.name = thing.name;
        node.parent = thing.room < 0 ? kNone : node_of.at(thing.room);
        node.local.translation = thing.at;
        node.extras = "{\"id\":" + std::to_string(thing.id) + "}";
        if (thing.lit) {
            node.light = static_cast<std::uint32_t>(scene.lights.size());
            scene.lights.emplace_back();
            scene.lights.back().intensity = 20;
        }
        if (thing.mesh >= 0) {
            if (!mesh_of.contains(thing.mesh)) {
                mesh_of[thing.mesh] = static_cast<std::uint32_t>(scene.meshes.size());
                scene.meshes.push_back(fan(thing.mesh));
            }
            node.meshes = {mesh_of[thing.mesh]};
        }
        node_of[thing.id] = static_cast<std::uint32_t>(scene.nodes.size());
        scene.nodes.push_back(std::move(node));
    }
    return GltfDocument::of_scene(scene, "test").glb_bytes();
}

// What a colleague may do between two exports.
std::vector<Thing> worked_on(std::vector<Thing> all, Dice& dice) {
    for (Thing& thing : all) {
        if (thing.room < 0 && dice.below(2) == 0) {
            thing.name += "_new";  // renamed parents
        }
    }
    const std::size_t added = 3 + dice.below(5);
    for (std::size_t i = 0; i < added; ++i) {
        Thing more = all[4 + dice.below(36)];  // another of the same name and looks, elsewhere
        more.id = 1000 + static_cast<int>(i);
        more.at += dvec3(1.5, 0, dice.between(0.5, 2));
        all.push_back(more);
    }
    return all;
}

int id_of(const EditModel& model, const ecs::Registry& registry, std::uint32_t node) {
    return std::stoi(node_value(model, registry, node, "extras.id"));
}

TEST(Rebase, AHundredShuffledExports) {
    std::size_t commands = 0, kept = 0, left = 0, wrong = 0;
    const TemporaryFolder folder;
    const std::string file = folder.path("scene.glb");
    const auto write = [&](const std::string& bytes) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    };
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        Dice dice(seed);
        const std::vector<Thing> before = things(dice);
        write(exported(before, dice));
        EditSession session;
        session.open(file);
        // Each command writes its number beside the id of what it is meant for, or makes a node.
        std::map<std::string, int> meant;  // by note
        std::size_t given = 0;
        while (given < 15) {
            const std::vector<std::uint32_t> all = session.model().in_order();
            const std::uint32_t node = all[dice.below(all.size())];
            const std::string path = word(session.path_of(node));
            std::string line;
            switch (dice.below(5)) {
                case 0:
                    line = "move " + path + " 0.5 " + number(dice.between(0, 2)) + " 1";
                    break;
                case 1:
                    line = "duplicate " + path + " copy" + std::to_string(given);
                    break;
                case 2:
                    line = "rename " + path + " renamed" + std::to_string(given);
                    break;
                default: {
                    const std::string note = "n" + std::to_string(given);
                    line = "set " + path + " extras." + note + " 1";
                    meant[note] = id_of(session.model(), session.registry(), node);
                }
            }
            session.run(line);
            ++given;
        }
        write(exported(worked_on(before, dice), dice));
        ASSERT_TRUE(session.changed_outside());
        const Rebased result = session.reload();
        commands += given;
        kept += result.kept;
        left += result.left.size();
        for (const std::uint32_t node : session.model().in_order()) {
            for (const auto& [note, id] : meant) {
                const std::string& extras = session.model().node(node).extras;
                const bool has = extras.find('"' + note + '"') != std::string::npos;
                const bool is_wrong = has && id_of(session.model(), session.registry(), node) != id;
                wrong += is_wrong ? 1 : 0;
                EXPECT_FALSE(is_wrong) << "seed " << seed << ": " << note << ", meant for thing " << id
                                       << ", is on '" << session.path_of(node) << "', " << extras;
            }
        }
        ASSERT_EQ(result.kept + result.left.size(), given) << "seed " << seed;
        ASSERT_EQ(session.left().size(), result.left.size());
    }
    std::cout << "100 exports, " << commands << " commands: " << kept << " kept, " << left << " left, "
              << wrong << " on another node\n";
    EXPECT_EQ(wrong, 0u);
    EXPECT_EQ(kept + left, commands);
    EXPECT_GE(static_cast<double>(kept), 0.95 * static_cast<double>(commands));
}

class Reload : public testing::Test {
  protected:
    void export_room(const std::vector<std::string>& lines) {
        EditSession maker;
        maker.new_room();
        if (!lines.empty()) {
            maker.run("made", lines);
        }
        maker.save(folder.path("room.glb"));
    }
    TemporaryFolder folder;
    EditSession session;
};

TEST_F(Reload, WhatIsGoneIsListedAndKept) {
    export_room({"add-light /room lamp_2 point 1 1 1"});
    session.open(folder.path("room.glb"));
    session.run("move /room/lamp_2 2 1 1");
    session.run("set /room/lamp light.intensity 33");
    session.run("duplicate /room/lamp_2 lamp_3");
    session.run("move /room/lamp_3 0 0 0");
    session.select({session.node_at("/room/floor")});
    export_room({});
    const Rebased result = session.reload();
    EXPECT_EQ(result.kept, 1u);
    ASSERT_EQ(result.left.size(), 3u);
    EXPECT_EQ(result.left[0].command.text, "move /room/lamp_2 2 1 1");
    EXPECT_EQ(result.left[0].nearest, "/room/lamp");
    EXPECT_EQ(
        node_value(session.model(), session.registry(), session.node_at("/room/lamp"), "light.intensity"),
        "33.0");
    EXPECT_EQ(session.selection(), std::vector<std::uint32_t>{session.node_at("/room/floor")});
    EXPECT_TRUE(session.is_dirty());
    session.undo();
    EXPECT_FALSE(session.is_dirty());
    session.drop_left();
    EXPECT_TRUE(session.left().empty());
}

TEST_F(Reload, ABrokenFileKeepsTheLastGoodScene) {
    export_room({});
    session.open(folder.path("room.glb"));
    session.run("move /room/lamp 1 2 0");
    const std::string before = session.document().json_text();
    std::ofstream(folder.path("room.glb"), std::ios::binary | std::ios::trunc) << "glTF, half of it";
    EXPECT_TRUE(session.changed_outside());
    EXPECT_THROW(session.reload(), InputError);
    EXPECT_EQ(session.document().json_text(), before);
    EXPECT_TRUE(session.world().alive(session.entity_of(session.node_at("/room/lamp"))));
    export_room({"move /room/floor 0 -0.1 0"});
    EXPECT_EQ(session.reload().kept, 1u);
    EXPECT_EQ(node_value(session.model(), session.registry(), session.node_at("/room/lamp"), "translation"),
              "[1,2,0]");
    EXPECT_EQ(node_value(session.model(), session.registry(), session.node_at("/room/floor"), "translation"),
              "[0,-0.1,0]");
}

}  // namespace
}  // namespace lanthorn::editor
