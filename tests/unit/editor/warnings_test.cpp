// Warnings, and the commands that put right what they are about.
#include <gtest/gtest.h>

#include <sstream>

#include "tools/editor/core/edit_session.h"
#include "tools/editor/core/edit_warnings.h"

namespace lanthorn::editor {
namespace {

const EditWarning* find(const std::vector<EditWarning>& all, const std::string& kind) {
    for (const EditWarning& warning : all) {
        if (warning.kind == kind) {
            return &warning;
        }
    }
    return nullptr;
}

// What makes it appear; its fix must make it go.
struct Case {
    const char* kind;
    std::vector<std::string> lines;
};

class Warns : public testing::TestWithParam<Case> {};

TEST_P(Warns, AndIsPutRight) {
    EditSession session;
    session.new_room();
    EXPECT_EQ(find(edit_warnings(session), GetParam().kind), nullptr);
    for (const std::string& line : GetParam().lines) {
        session.run(line);
    }
    const std::vector<EditWarning> all = edit_warnings(session);
    const EditWarning* warning = find(all, GetParam().kind);
    ASSERT_NE(warning, nullptr);
    if (warning->fix.empty()) {
        return;
    }
    std::vector<std::string> fix;
    std::istringstream lines(warning->fix);
    for (std::string line; std::getline(lines, line);) {
        fix.push_back(line);
    }
    if (fix == std::vector<std::string>{"adopt"}) {
        session.adopt();
    } else {
        session.run("fix", fix);
    }
    EXPECT_EQ(find(edit_warnings(session), GetParam().kind), nullptr)
        << warning->text << "; " << warning->fix;
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, Warns,
    testing::Values(Case{"watts", {"set /room/lamp light.intensity 10870"}},
                    Case{"guest", {"delete /room/lamp"}}, Case{"dark", {"set /room/lamp light.intensity 0"}},
                    Case{"noon", {"add-light / sun directional 0 0 0 500000"}},
                    Case{"range", {"set /room/lamp light.range 2"}},
                    Case{"colour", {"set /room/lamp light.colour [3,3,3]"}},
                    Case{"hidden", {"hide /room/lamp"}},
                    Case{"tint", {"set /room/lamp light.colour [0.1,1,0.1]"}},
                    Case{"albedo", {"set-material walls base_colour [1,1,1,1]"}},
                    Case{"albedo", {"set-material walls base_colour [0,0,0,1]"}},
                    Case{"metal", {"set-material walls metallic 0.5"}},
                    Case{"glare", {"set-material walls emissive [1000000,0,0]"}},
                    Case{"names", {"add-node / a", "add-node / a"}}, Case{"units", {"scale /room 1000"}}),
    [](const auto& info) { return std::string(info.param.kind) + std::to_string(info.index); });

}  // namespace
}  // namespace lanthorn::editor
