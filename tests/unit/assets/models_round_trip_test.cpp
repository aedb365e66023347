// Every valid model of the shared collection, read and written again: nothing is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "tests/unit/assets/gltf_builder.h"
#include "tests/unit/assets/round_trip.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;

TEST(ModelsRoundTrip, LoseNothing) {
    const char* models = std::getenv("LANTHORN_MODELS");
    if (models == nullptr) {
        GTEST_SKIP() << "LANTHORN_MODELS is not set: the folder of shared models";
    }
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(models)) {
        const fs::path ending = entry.path().extension();
        if (entry.is_regular_file() && (ending == ".gltf" || ending == ".glb")) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
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

}  // namespace
}  // namespace lanthorn
