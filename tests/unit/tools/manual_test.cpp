// Manual pages and completion against the programs themselves: what --help shows is in both, whatever is
// added to it.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/unit/tools/run_program.h"

namespace lanthorn {
namespace {

using testing_tools::run_program;

struct Program {
    const char* name;
    const char* path;
};

constexpr Program kPrograms[] = {
    {"lanthorn", LANTHORN_BINARY},
#ifdef LAMPLIGHTER_BINARY
    {"lamplighter", LAMPLIGHTER_BINARY},
#endif
};

// With its commands: {"measure", "hits"}.
using Command = std::vector<std::string>;

std::string help_of(const Program& program, Command command) {
    command.push_back("--help");
    const auto outcome = run_program(program.path, command);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
}

// The lines below "Subcommands:" begin with a name.
std::vector<std::string> commands_in(const std::string& help) {
    std::vector<std::string> names;
    std::istringstream lines(help.substr(std::min(help.find("Subcommands:"), help.size())));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line) && line.starts_with("  ")) {
        if (line[2] != ' ') {
            names.push_back(line.substr(2, line.find(' ', 2) - 2));
        }
    }
    return names;
}

// Options of all lines that begin with one.
std::set<std::string> options_in(const std::string& help) {
    std::set<std::string> options;
    std::istringstream lines(help);
    const std::regex option("--?[a-zA-Z][a-z0-9-]*");
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("  -")) {
            continue;
        }
        const std::string names = line.substr(2, line.find(' ', 2) - 2);
        for (std::sregex_iterator at(names.begin(), names.end(), option), end; at != end; ++at) {
            options.insert(at->str());
        }
    }
    return options;
}

// Of a program and all its commands.
using Helps = std::vector<std::pair<Command, std::string>>;
void collect(const Program& program, const Command& command, Helps& all) {
    const std::string help = help_of(program, command);
    all.emplace_back(command, help);
    for (const std::string& name : commands_in(help)) {
        Command below = command;
        below.push_back(name);
        collect(program, below, all);
    }
}

// Asked for once a program.
const Helps& helps(const Program& program) {
    static std::map<std::string, Helps> of_programs;
    Helps& list = of_programs[program.path];
    if (list.empty()) {
        collect(program, {}, list);
    }
    return list;
}

std::string joined(const Command& words) {
    std::string text;
    for (const std::string& word : words) {
        text += " " + word;
    }
    return text;
}

// As a reader sees it: without the marks of roff.
std::string plain(const std::string& page) {
    return std::regex_replace(std::regex_replace(page, std::regex("\\\\-"), "-"), std::regex("\\\\f[BIR]"),
                              "");
}

class Manual : public testing::TestWithParam<Program> {
  protected:
    // Once a program.
    std::string printed(const std::string& option) const {
        static std::map<std::string, std::string> texts;
        std::string& text = texts[GetParam().path + option];
        if (text.empty()) {
            const auto outcome = run_program(GetParam().path, {option});
            EXPECT_EQ(outcome.code, 0) << outcome.err;
            EXPECT_EQ(outcome.err, "");
            text = outcome.out;
        }
        return text;
    }

    // What bash offers for the last of `words`.
    std::set<std::string> offered(const std::string& words) const {
        const testing_tools::TemporaryFolder folder;
        std::ofstream(folder.path("completion")) << printed("--print-completion");
        std::ofstream(folder.path("ask")) << "source " << folder.path("completion") << "\nCOMP_WORDS=("
                                          << words << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_"
                                          << GetParam().name << "\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
        const auto outcome = run_program("/bin/bash", {folder.path("ask")});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        std::istringstream lines(outcome.out);
        std::set<std::string> list;
        for (std::string line; std::getline(lines, line);) {
            list.insert(line);
        }
        list.erase("");
        return list;
    }
};

TEST_P(Manual, HasEveryOptionOfEveryCommand) {
    const std::string page = plain(printed("--print-manual"));
    for (const auto& [command, help] : helps(GetParam())) {
        const std::string heading = ".SS " + std::string(GetParam().name) + joined(command) + "\n";
        const std::size_t begin = command.empty() ? page.find(".SH OPTIONS\n") : page.find(heading);
        ASSERT_NE(begin, std::string::npos) << heading;
        const std::string part = page.substr(begin, page.find("\n.S", begin) - begin);
        const std::set<std::string> options = options_in(help);
        EXPECT_TRUE(options.contains("--help")) << help;
        for (const std::string& option : options) {
            EXPECT_TRUE(std::regex_search(part, std::regex("\n([^.\n][^\n]*, )?" + option + "[, \n]")))
                << heading << option;
        }
    }
}

TEST_P(Manual, NamesNoPlaceOfThisBuild) {
    const std::string page = printed("--print-manual");
    EXPECT_EQ(page.find(LANTHORN_SOURCE_FOLDER), std::string::npos);
    EXPECT_EQ(printed("--print-completion").find(LANTHORN_SOURCE_FOLDER), std::string::npos);
}

TEST_P(Manual, IsFreeOfWarnings) {
    if (access("/usr/bin/groff", X_OK) != 0) {
        GTEST_SKIP() << "groff is not installed";
    }
    const testing_tools::TemporaryFolder folder;
    std::ofstream(folder.path("page")) << printed("--print-manual");
    const auto outcome = run_program("/usr/bin/groff", {"-man", "-ww", "-Tutf8", folder.path("page")});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out, "");
}

TEST_P(Manual, CompletionOffersEveryOption) {
    for (const auto& [command, help] : helps(GetParam())) {
        EXPECT_EQ(offered(GetParam().name + joined(command) + " -"), options_in(help)) << joined(command);
        const std::vector<std::string> below = commands_in(help);
        if (!below.empty()) {
            EXPECT_EQ(offered(GetParam().name + joined(command) + " ''"),
                      std::set<std::string>(below.begin(), below.end()));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Programs, Manual, testing::ValuesIn(kPrograms),
                         [](const auto& info) { return std::string(info.param.name); });

class LanthornManual : public Manual {};

TEST_P(LanthornManual, CompletionOffersValues) {
    EXPECT_EQ(offered("lanthorn render --preset ''"),
              (std::set<std::string>{"low", "medium", "high", "ultra", "paper"}));
    EXPECT_EQ(offered("lanthorn render box.glb --technique e"), (std::set<std::string>{"emc"}));
    EXPECT_EQ(offered("lanthorn compare --metric hd"), (std::set<std::string>{"hdrflip"}));
    EXPECT_EQ(offered("lanthorn render --set gi.emc.cou"), (std::set<std::string>{"gi.emc.count="}));
    EXPECT_EQ(offered("lanthorn render --frames ''"), std::set<std::string>());
    EXPECT_EQ(offered("lanthorn measure hi"), (std::set<std::string>{"hits"}));
    EXPECT_EQ(offered("lanthorn render /usr/bi"), (std::set<std::string>{"/usr/bin"}));
}

// Each AOV that is offered is one: asked for together, what is refused is the scene. Starting the program is
// what takes time here.
TEST_P(LanthornManual, OfferedAovsExist) {
    const std::set<std::string> aovs = offered("lanthorn render --aov ''");
    EXPECT_GE(aovs.size(), 7u);
    const testing_tools::TemporaryFolder folder;
    std::vector<std::string> arguments = {"render", "/none.glb", "-o", folder.path("x.exr")};
    for (const std::string& aov : aovs) {
        arguments.insert(arguments.end(), {"--aov", aov});
    }
    const auto outcome = run_program(LANTHORN_BINARY, arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("/none.glb"), std::string::npos) << outcome.err;
    arguments.insert(arguments.end(), {"--aov", "none"});
    EXPECT_NE(run_program(LANTHORN_BINARY, arguments).err.find("--aov"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Programs, LanthornManual, testing::Values(Program{"lanthorn", LANTHORN_BINARY}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace lanthorn
