#include "tools/tables/tables.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "lanthorn/core/error.h"
#include "tests/support/repository.h"

namespace lanthorn::tools {
namespace {

std::string text_of(const char* path) {
    std::ifstream file(support::repository_file(path), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// After a change of what is declared: build the target update-tables.
TEST(Tables, InThePagesAreWhatIsDeclared) {
    for (const char* path :
         {"docs/level-fields.md", "docs/settings.md", "docs/what-you-get.md", "docs/plan.md"}) {
        const std::string page = text_of(path);
        EXPECT_EQ(with_tables(page, support::repository_file(path)), page) << path;
    }
}

TEST(Tables, SayWhatAnAuthorMaySet) {
    const std::string components = table("components");
    EXPECT_NE(
        components.find(
            "| **`door`** | | | | a leaf that turns about its node's +Y |\n"
            "| | `open_angle` | a number from -3.141593 to 3.141593 rad | `1.9` | how far it opens |\n"),
        std::string::npos)
        << components;
    EXPECT_EQ(components.find("`angle`"), std::string::npos) << "the simulation's";
    EXPECT_EQ(components.find("world_transform"), std::string::npos);
    const std::string settings = table("settings");
    EXPECT_NE(settings.find("| `gi.emc.count` | an integer from 1 to 32 maps | 8 | "), std::string::npos)
        << settings;
    EXPECT_THROW(table("doors"), InputError);
}

TEST(Tables, PagesWithoutMarksAreRefused) {
    EXPECT_THROW(with_tables("a page\n", "p"), InputError);
    EXPECT_THROW(with_tables("<!-- table settings -->\n", "p"), InputError);
    EXPECT_THROW(with_tables("<!-- table doors -->\n<!-- end of doors -->\n", "p"), InputError);
    EXPECT_THROW(
        with_tables("<!-- table advice from p.csv -->\n<!-- end of advice from p.csv -->\n", "/nowhere/p"),
        InputError);
    EXPECT_EQ(with_tables("a\n<!-- table settings -->\nold\n<!-- end of settings -->\nb\n", "p"),
              "a\n<!-- table settings -->\n" + table("settings") + "<!-- end of settings -->\nb\n");
}

}  // namespace
}  // namespace lanthorn::tools
