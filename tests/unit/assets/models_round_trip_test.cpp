// Every valid model of the shared collection, read and written again: nothing is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "lanthorn/assets/gltf_document.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "tests/unit/assets/file_map.h"
#include "tests/unit/assets/gltf_builder.h"
#include "tests/unit/assets/round_trip.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> models_in(const char* models) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(models)) {
        const fs::path ending = entry.path().extension();
        if (entry.is_regular_file() && (ending == ".gltf" || ending == ".glb")) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

TEST(ModelsRoundTrip, LoseNothing) {
    const char* models = std::getenv("LANTHORN_MODELS");
    if (models == nullptr) {
        GTEST_SKIP() << "LANTHORN_MODELS is not set: the folder of shared models";
    }
    const std::vector<fs::path> files = models_in(models);
    std::size_t count = 0;
    for (const fs::path& file : files) {
        SCOPED_TRACE(file);
        try {
            import_gltf(file);
        } catch (const InputError&) {
            continue;  // refused with one line: Conformance
        }
        const TemporaryFolder folder;
        EXPECT_NO_THROW(expect_lossless(file, folder.path()));
        ++count;
    }
    std::cout << count << " of " << files.size() << " files load, and come back\n";
    EXPECT_GE(count, 150u);
}

TEST(ModelsFileMap, EveryNodeHasItsEntity) {
    const char* models = std::getenv("LANTHORN_MODELS");
    if (models == nullptr) {
        GTEST_SKIP() << "LANTHORN_MODELS is not set: the folder of shared models";
    }
    std::size_t count = 0;
    for (const fs::path& file : models_in(models)) {
        try {
            expect_file_map(file);
            ++count;
        } catch (const InputError&) {
            continue;
        }
    }
    EXPECT_GE(count, 150u);
}

// What was imported as it stands is set again: no byte of the file changes.
TEST(ModelsRoundTrip, SettingWhatWasImportedChangesNothing) {
    const char* models = std::getenv("LANTHORN_MODELS");
    if (models == nullptr) {
        GTEST_SKIP() << "LANTHORN_MODELS is not set: the folder of shared models";
    }
    std::size_t count = 0;
    for (const fs::path& file : models_in(models)) {
        SCOPED_TRACE(file);
        SceneData scene;
        try {
            scene = import_gltf(file);
        } catch (const InputError&) {
            continue;
        }
        const auto is_mended = [&](const std::string& part) {
            return std::any_of(scene.warnings.begin(), scene.warnings.end(), [&](const std::string& warning) {
                return warning.find(part) != std::string::npos;
            });
        };
        GltfDocument document = GltfDocument::open(file);
        const std::string before = document.json_text();
        for (std::size_t i = 0; i < document.camera_count() && !is_mended("/cameras/"); ++i) {
            document.set_camera(i, scene.cameras.at(i));
            ++count;
        }
        for (std::size_t i = 0; i < document.light_count() && !is_mended("/lights/"); ++i) {
            document.set_light(i, scene.lights.at(i));
            ++count;
        }
        const bool restated = before.find("pbrSpecularGlossiness") != std::string::npos;
        for (std::size_t i = 0; i < document.material_count() && !restated && !is_mended("/materials/");
             ++i) {
            document.set_material(i, scene.materials.at(i));
            ++count;
        }
        EXPECT_TRUE(document.json_text() == before);
    }
    EXPECT_GE(count, 50u);
}

}  // namespace
}  // namespace lanthorn
