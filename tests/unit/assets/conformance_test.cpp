// The shared model collection: every valid file loads, no invalid one does harm.
// LANTHORN_MODELS names a folder with validator/ (files of KhronosGroup/glTF-Validator, each with
// FILE.report.json) and bevy/.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "tests/unit/assets/scene_invariants.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;

class Conformance : public testing::Test {
  protected:
    void SetUp() override {
        const char* folder = std::getenv("LANTHORN_MODELS");
        if (folder == nullptr) {
            GTEST_SKIP() << "LANTHORN_MODELS is not set: the folder of shared models";
        }
        models_ = folder;
        ASSERT_TRUE(fs::is_directory(models_ / "validator")) << models_;
    }

    std::vector<fs::path> files(const char* folder) const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(models_ / folder)) {
            const fs::path ending = entry.path().extension();
            if (entry.is_regular_file() && (ending == ".gltf" || ending == ".glb")) {
                found.push_back(entry.path());
            }
        }
        std::sort(found.begin(), found.end());
        return found;
    }

    fs::path models_;
};

bool report_has_error(const fs::path& file) {
    std::ifstream stream(file.string() + ".report.json");
    const nlohmann::json report = nlohmann::json::parse(stream);
    for (const auto& message : report["issues"]["messages"]) {
        if (message["severity"] == 0) {
            return true;
        }
    }
    return false;
}

TEST_F(Conformance, EveryValidFileLoads) {
    std::size_t count = 0;
    for (const fs::path& file : files("validator")) {
        SCOPED_TRACE(file.string());
        if (!report_has_error(file)) {
            ++count;
            EXPECT_NO_THROW(expect_scene_invariants(import_gltf(file)));
        }
    }
    EXPECT_GE(count, 70u);
}

// Refused with one line that names file and place, or loaded with the damage confined.
TEST_F(Conformance, NoInvalidFileDoesHarm) {
    std::size_t refused = 0;
    std::size_t confined = 0;
    for (const fs::path& file : files("validator")) {
        SCOPED_TRACE(file.string());
        if (!report_has_error(file)) {
            continue;
        }
        try {
            expect_scene_invariants(import_gltf(file));
            ++confined;
        } catch (const InputError& error) {
            expect_places_in(error, file);
            ++refused;
        }
    }
    std::cout << refused << " refused, " << confined << " loaded\n";
    EXPECT_GE(refused, 1u);
}

TEST_F(Conformance, EveryModelLoads) {
    std::size_t count = 0;
    for (const fs::path& file : files("bevy")) {
        SCOPED_TRACE(file.string());
        SceneData scene;
        ASSERT_NO_THROW(scene = import_gltf(file));
        expect_scene_invariants(scene);
        EXPECT_GT(scene.nodes.size(), 0u);
        for (const std::string& warning : scene.warnings) {
            EXPECT_EQ(warning.find("/images"), std::string::npos) << warning;
        }
        ++count;
    }
    EXPECT_GE(count, 8u);
}

// Files as exporters write them, with what they do against the specification: nothing is refused.
TEST_F(Conformance, EveryExportedModelLoads) {
    std::size_t count = 0;
    for (const fs::path& file : files("more")) {
        SCOPED_TRACE(file.string());
        SceneData scene;
        ASSERT_NO_THROW(scene = import_gltf(file));
        expect_scene_invariants(scene);
        EXPECT_GT(scene.nodes.size(), 0u);
        ++count;
    }
    EXPECT_GE(count, 9u);
}

}  // namespace
}  // namespace lanthorn
