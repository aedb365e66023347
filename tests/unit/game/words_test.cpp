// Words of a language, what it lacks, and lessons.
#include "game/screens/words.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "game/level/campaign.h"
#include "game/level/hints.h"
#include "game/level/story.h"
#include "game/presentation/languages.h"
#include "game/rules/actions.h"
#include "game/rules/components.h"
#include "game/screens/lessons.h"
#include "lanthorn/core/error.h"
#include "tests/support/repository.h"

namespace lanthorn::game {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = support::repository_file("assets/languages");

// A folder of languages of its own.
class Folder {
  public:
    Folder() {
        fs::remove_all(path);
        fs::create_directories(path);
    }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    void put(const std::string& name, const std::string& text) const { std::ofstream(path / name) << text; }

    const fs::path path = fs::temp_directory_path() / ("languages-" + std::to_string(::getpid()));
    std::vector<std::string> said;
    shell::Say say() {
        return [this](const std::string& line) { said.push_back(line); };
    }
};

constexpr const char* kTwo = R"({"language": "English", "words": {"Play": "Play", "Quit": "Quit"}})";

TEST(Words, AreTheTablesElseTheEnglishOnes) {
    const Words words = Words::from_json(R"({"language": "Deutsch", "words": {"Play": "Spielen"}})", "de");
    EXPECT_EQ(words.language(), "Deutsch");
    EXPECT_EQ(words.say("Play"), "Spielen");
    EXPECT_EQ(words.say("Quit"), "Quit");
    EXPECT_EQ(words.unknown(), std::set<std::string>{"Quit"});
    EXPECT_EQ(Words().say("Play"), "Play");
}

TEST(Words, WhatIsNoLanguageIsRefusedByName) {
    for (const auto& [text, name] : std::vector<std::pair<std::string, std::string>>{
             {"", "JSON"},
             {"[]", "JSON"},
             {"{}", "language"},
             {R"({"language": "", "words": {}})", "language"},
             {R"({"language": "x"})", "words"},
             {R"({"language": "x", "words": ["Play"]})", "words"},
             {R"({"language": "x", "words": {"Play": 3}})", "words/Play"}}) {
        try {
            Words::from_json(text, "xx.json");
            ADD_FAILURE() << text << " was accepted";
        } catch (const InputError& e) {
            const std::string line = e.what();
            EXPECT_TRUE(line.starts_with("xx.json")) << line;
            EXPECT_NE(line.find(name), std::string::npos) << line;
        }
    }
}

TEST(Words, FillIn) {
    const auto named = [](std::string_view name) { return name == "use" ? "E" : std::string(); };
    EXPECT_EQ(fill_in("Open it ({use}), {not} now {use}", named), "Open it (E), {not} now E");
    EXPECT_EQ(fill_in("{use", named), "{use");
    EXPECT_EQ(fill_in("", named), "");
}

TEST(Languages, OneWithHolesStaysEnglishThereAndSaysSoOnce) {
    Folder folder;
    folder.put("en.json", kTwo);
    folder.put("xx.json", R"({"language": "Xish", "words": {"Quit": "Xuit", "Play": ""}})");
    Languages languages(folder.path, folder.say());
    EXPECT_EQ(languages.codes(), (std::vector<std::string>{"en", "xx"}));
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(languages.words("xx").say("Quit"), "Xuit");
        EXPECT_EQ(languages.words("xx").say("Play"), "Play");
    }
    ASSERT_EQ(folder.said.size(), 1u);
    EXPECT_NE(folder.said[0].find("xx.json: has no words for 1 of the English ones, the first 'Play'"),
              std::string::npos)
        << folder.said[0];
}

TEST(Languages, ADamagedOneOrNoneIsEnglish) {
    Folder folder;
    folder.put("en.json", kTwo);
    folder.put("xx.json", R"({"language": "Xish", "words": )");
    Languages languages(folder.path, folder.say());
    EXPECT_EQ(languages.words("xx").say("Play"), "Play");
    EXPECT_EQ(folder.said.size(), 1u);
    EXPECT_EQ(Languages(folder.path / "nowhere", folder.say()).words("de").say("Play"), "Play");
    EXPECT_EQ(folder.said.size(), 1u);
}

// Everything that the code and the levels can say has a place in the table, and German leaves none out.
TEST(Languages, GermanIsComplete) {
    Folder folder;
    Languages languages(kFolder, folder.say());
    const Words english = languages.words("en"), german = languages.words("de");
    EXPECT_EQ(german.language(), "Deutsch");
    EXPECT_TRUE(folder.said.empty()) << folder.said.front();
    EXPECT_TRUE(english.holes(german).empty()) << english.holes(german).front();
    for (const input::Action& action : actions()) {
        german.say(action.words);
    }
    for (const std::string_view stem : campaign()) {
        const LevelInfo info = read_level_info(level_path(stem));
        german.say(info.title);
        german.say(story_of(stem));
        for (const std::string& hint : info.hints) {
            german.say(hint);
        }
    }
    Hints none;
    none.ask({});
    german.say(none.shown());
    german.say(kEnding);
    german.say("wait here");
    german.say("come along");
    for (const std::string& word : german.unknown()) {
        ADD_FAILURE() << "de.json has no word for '" << word << "'";
    }
}

// A hint names only keys that there are.
TEST(Languages, TheKeysInWordsAreThoseOfActions) {
    Folder folder;
    Languages languages(kFolder, folder.say());
    for (const char* code : {"en", "de"}) {
        const Words& words = languages.words(code);
        for (const std::string_view stem : campaign()) {
            for (const std::string& hint : read_level_info(level_path(stem)).hints) {
                const std::string filled = fill_in(words.say(hint), [](std::string_view name) {
                    const bool there = std::ranges::any_of(
                        actions(), [&](const input::Action& action) { return action.name == name; });
                    return std::string(there ? "K" : "");
                });
                EXPECT_EQ(filled.find('{'), std::string::npos) << filled;
            }
        }
    }
}

std::vector<std::string> said(const Lessons& lessons, const Hud& hud, float least = 0.99f) {
    std::vector<std::string> words;
    for (const Prompt& prompt : lessons.prompts(hud)) {
        if (prompt.strength >= least) {
            words.emplace_back(prompt.words);
        }
    }
    return words;
}

Doing does(Action action) {
    Doing doing;
    doing.used.set(static_cast<std::size_t>(action));
    return doing;
}

TEST(Lessons, SayHowToWalkAndLookUntilBothWereDone) {
    Lessons lessons;
    EXPECT_EQ(said(lessons, {}), (std::vector<std::string>{"walk", "look about"}));
    lessons.pass({.walked = true}, 1);
    EXPECT_EQ(said(lessons, {}), std::vector<std::string>{"look about"});
    lessons.pass({.turned = -1}, 0.1);
    EXPECT_TRUE(said(lessons, {}).empty());
    lessons.begin_level();
    EXPECT_TRUE(said(lessons, {}).empty());
}

TEST(Lessons, SayWhatALanternCanDoUntilItWasDoneAndFaintlyThen) {
    Lessons lessons;
    lessons.pass({.walked = true, .turned = 1}, 1);
    const Hud carried{.carries = true, .lit = true, .glasses = 2};
    EXPECT_EQ(said(lessons, carried),
              (std::vector<std::string>{"put out", "another glass", "brighter, darker", "put down"}));
    lessons.pass(does(Action::light), 0.1);
    EXPECT_EQ(said(lessons, carried),
              (std::vector<std::string>{"another glass", "brighter, darker", "put down"}));
    EXPECT_EQ(said(lessons, carried, 0.5f)[3], "put out");
    lessons.pass(does(Action::dim_up), 0.1);
    EXPECT_EQ(said(lessons, carried)[1], "brighter, darker");  // down is another key
    lessons.pass(does(Action::dim_down), 0.1);
    EXPECT_EQ(said(lessons, carried), (std::vector<std::string>{"another glass", "put down"}));
    const Hud dark{.carries = true};
    EXPECT_EQ(said(lessons, dark, 0.5f)[1], "light");
}

TEST(Lessons, TheHintsKeyGoesAndComesAgainForThoseWhoAreStuck) {
    Lessons lessons;
    const auto hint = [&] {
        return !lessons.prompts({}).empty() && lessons.prompts({}).back().actions[0] == Action::menu;
    };
    lessons.pass({.walked = true, .turned = 1}, 1);
    lessons.pass(does(Action::view), 0.1);
    EXPECT_TRUE(hint());
    lessons.pass({}, Lessons::kAlwaysSeconds);
    EXPECT_FALSE(hint());
    lessons.pass({}, Lessons::kStuckSeconds - Lessons::kAlwaysSeconds);
    EXPECT_TRUE(hint());
}

}  // namespace
}  // namespace lanthorn::game
