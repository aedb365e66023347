// From entities to the file's nodes, and back.
#include <gtest/gtest.h>

#include "tests/support/repository.h"
#include "tests/unit/assets/file_map.h"

namespace lanthorn {
namespace {

TEST(FileMap, OfEverySceneAndLevelOfTheProject) {
    std::size_t count = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(support::repository_file("assets"))) {
        if (entry.path().extension() == ".glb") {
            expect_file_map(entry.path());
            ++count;
        }
    }
    EXPECT_GE(count, 20u);
}

}  // namespace
}  // namespace lanthorn
