// Importing what a GltfBuilder has built.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "tests/unit/assets/gltf_builder.h"
#include "tests/unit/assets/scene_invariants.h"

namespace lanthorn {

class ImportTest : public testing::Test {
  protected:
    // Both containers must give the same scene; the .glb's is returned.
    SceneData import() {
        const SceneData scene = import_gltf(folder.write("scene.glb", builder.glb()));
        const SceneData same = import_gltf(folder.write("scene.gltf", builder.gltf()));
        EXPECT_EQ(scene.triangle_count(), same.triangle_count());
        EXPECT_EQ(scene.warnings, same.warnings);
        expect_scene_invariants(scene);
        return scene;
    }

    SceneData import_within(const ImportBudget& budget) {
        GltfOptions options;
        options.budget = budget;
        return import_gltf(folder.write("scene.gltf", builder.gltf()), options);
    }

    // Expects a refusal at `place` whose line contains `part`.
    void expect_refused(const std::string& place, const std::string& part = "") {
        expect_file_refused(folder.write("scene.gltf", builder.gltf()), place, part);
    }

    static void expect_file_refused(const std::filesystem::path& file, const std::string& place,
                                    const std::string& part) {
        try {
            import_gltf(file);
            ADD_FAILURE() << "loaded, expected a refusal at " << place;
        } catch (const InputError& error) {
            const std::string line = error.what();
            EXPECT_TRUE(line.starts_with(file.string() + ": " + place + ": ")) << line;
            EXPECT_NE(line.find(part), std::string::npos) << line;
            EXPECT_EQ(line.find_first_of("\r\n"), std::string::npos) << line;
            EXPECT_EQ(error.code(), ExitCode::bad_input);
        }
    }

    // Expects exactly one warning, at `place`, which contains `part`.
    static void expect_warning(const SceneData& scene, const std::string& place,
                               const std::string& part = "") {
        ASSERT_EQ(scene.warnings.size(), 1u) << testing::PrintToString(scene.warnings);
        EXPECT_TRUE(scene.warnings[0].starts_with(place + ": ")) << scene.warnings[0];
        EXPECT_NE(scene.warnings[0].find(part), std::string::npos) << scene.warnings[0];
    }

    static void expect_near(const vec3& a, const vec3& b, float tolerance = 1e-6f) {
        EXPECT_LE(glm::length(a - b), tolerance) << "(" << a.x << ", " << a.y << ", " << a.z << ") is not ("
                                                 << b.x << ", " << b.y << ", " << b.z << ")";
    }

    GltfBuilder builder;
    TemporaryFolder folder;
};

}  // namespace lanthorn
