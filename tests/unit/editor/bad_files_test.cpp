// Broken files and large ones in a session that has something open.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "lanthorn/core/error.h"
#include "tests/unit/tools/run_program.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/core/edit_warnings.h"

namespace lanthorn::editor {
namespace {

namespace fs = std::filesystem;

TEST(BadFiles, AreRefusedInOneLineOrOpened) {
    const char* models = std::getenv("LANTHORN_MODELS");
    if (models == nullptr) {
        GTEST_SKIP() << "LANTHORN_MODELS is not set: the folder of shared models";
    }
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(models) / "validator")) {
        const fs::path ending = entry.path().extension();
        if (entry.is_regular_file() && (ending == ".gltf" || ending == ".glb")) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    EditSession session;
    session.new_room();
    std::size_t refused = 0;
    for (const fs::path& file : files) {
        SCOPED_TRACE(file);
        const std::uint64_t version = session.version();
        const std::string before = session.document().json_text();
        try {
            session.open(file);
            const std::string first = session.document().json_text();
            edit_warnings(session);
            if (session.model().node_count() > 0) {
                const std::string path = word(session.path_of(session.model().in_order().front()));
                for (const std::string& line :
                     {"move " + path + " 1 2 3", "duplicate " + path, "delete " + path}) {
                    try {
                        session.run(line);
                    } catch (const InputError&) {
                        continue;
                    }
                }
                session.go_to(0);
            }
            EXPECT_EQ(session.document().json_text(), first);
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            EXPECT_EQ(session.version(), version);
            EXPECT_EQ(session.document().json_text(), before);
            ++refused;
        }
    }
    std::cout << files.size() << " files, " << refused << " refused\n";
    EXPECT_GT(refused, 20u);
}

// Times are printed, not asserted. tools/editor/core/edit_history.cpp keeps fewer steps of large scenes.
TEST(LargeScenes, TwentyThousandNodes) {
    const testing_tools::TemporaryFolder folder;
    SceneData scene;
    scene.materials.emplace_back();
    NodeData root;
    root.name = "root";
    scene.nodes.push_back(root);
    for (int i = 0; i < 20000; ++i) {
        NodeData node;
        node.name = "n" + std::to_string(i);
        node.parent = 0;
        node.local.translation = {i, 0, 0};
        scene.nodes.push_back(node);
    }
    GltfDocument::of_scene(scene, "test").write(folder.path("large.glb"));
    const auto now = [] { return std::chrono::steady_clock::now(); };
    const auto ms = [](auto since) {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since).count();
    };
    EditSession session;
    auto start = now();
    session.open(folder.path("large.glb"));
    std::cout << "open " << ms(start);
    for (const std::string line : {"move /root/n777 1 2 3", "duplicate /root/n5", "delete /root/n9"}) {
        start = now();
        session.run(line);
        std::cout << " ms, " << line.substr(0, line.find(' ')) << ' ' << ms(start);
        start = now();
        session.undo();
        std::cout << " ms, undone " << ms(start);
        session.redo();
    }
    std::cout << " ms\n";
    session.go_to(0);
    EXPECT_FALSE(session.is_dirty());
    EXPECT_EQ(session.model().node_count(), 20001u);
}

}  // namespace
}  // namespace lanthorn::editor
