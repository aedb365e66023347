#include "lanthorn/core/settings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"

namespace lanthorn {
namespace {

enum class Search { march, secant };

void declare_test_settings(SettingsSchema& schema) {
    schema.declare<int>("gi.emc.count")
        .unit("maps")
        .range(1, 64)
        .initially(8)
        .presets({4, 8, 12, 16})
        .as_published(10)
        .cost("linear in ms and MB")
        .docs("environment maps that light is traced against");
    schema.declare<float>("gi.blur").range(0.0f, 2.5f).initially(0.1f).unit("m");
    schema.declare<bool>("gi.half").initially(false).presets({true, true, false, false});
    schema.declare<Search>("gi.emc.search").choices({"march", "secant"}).initially(Search::march);
    schema.declare<int>("seed");
}

class SettingsTest : public testing::Test {
  protected:
    SettingsTest() { declare_test_settings(schema_); }

    // The message of setting `assignment`, or "" if it was accepted.
    static std::string refusal(Settings& settings, const std::string& assignment) {
        try {
            settings.set_from_text(assignment);
        } catch (const InputError& error) {
            EXPECT_EQ(error.code(), ExitCode::bad_input);
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            return error.what();
        }
        return {};
    }

    SettingsSchema schema_;
};

TEST_F(SettingsTest, StartAtTheirDefaults) {
    const Settings settings(schema_);
    EXPECT_EQ(settings.get<int>("gi.emc.count"), 8);
    EXPECT_EQ(settings.get<float>("gi.blur"), 0.1f);
    EXPECT_FALSE(settings.get<bool>("gi.half"));
    EXPECT_EQ(settings.get<Search>("gi.emc.search"), Search::march);
    EXPECT_TRUE(settings.is_default("gi.emc.count"));
    EXPECT_EQ(settings.to_json(), "{}\n");
}

TEST_F(SettingsTest, TakeTextOfEveryType) {
    Settings settings(schema_);
    settings.set_from_text("gi.emc.count=64");
    settings.set_from_text("gi.blur=1e-1");
    settings.set_from_text("gi.half=on");
    settings.set_from_text("gi.emc.search=secant");
    settings.set_from_text("seed=-7");
    EXPECT_EQ(settings.get<int>("gi.emc.count"), 64);
    EXPECT_EQ(settings.get<float>("gi.blur"), 0.1f);
    EXPECT_TRUE(settings.get<bool>("gi.half"));
    EXPECT_EQ(settings.get<Search>("gi.emc.search"), Search::secant);
    EXPECT_EQ(settings.get<int>("seed"), -7);
    EXPECT_EQ(settings.text("gi.emc.search"), "secant");
}

TEST_F(SettingsTest, RangeIsInclusive) {
    Settings settings(schema_);
    for (const char* good : {"gi.emc.count=1", "gi.emc.count=64", "gi.blur=0", "gi.blur=2.5"}) {
        EXPECT_EQ(refusal(settings, good), "") << good;
    }
    for (const char* bad :
         {"gi.emc.count=0", "gi.emc.count=65", "gi.emc.count=99999999999999999999", "gi.blur=2.5001",
          "gi.blur=-0.1", "gi.blur=nan", "gi.blur=inf", "gi.blur=1e999"}) {
        EXPECT_NE(refusal(settings, bad), "") << bad;
    }
    EXPECT_EQ(settings.get<int>("gi.emc.count"), 64) << "a refused value changes nothing";
}

TEST_F(SettingsTest, MessagesNameSettingAndRange) {
    Settings settings(schema_);
    EXPECT_EQ(refusal(settings, "gi.emc.count=100"),
              "gi.emc.count: found '100', expected an integer from 1 to 64 maps");
    EXPECT_EQ(refusal(settings, "gi.blur=wide"), "gi.blur: found 'wide', expected a number from 0 to 2.5 m");
    EXPECT_EQ(refusal(settings, "gi.emc.search=newton"),
              "gi.emc.search: found 'newton', expected one of 'march', 'secant'");
    EXPECT_EQ(refusal(settings, "gi.half=maybe"), "gi.half: found 'maybe', expected true or false");
}

TEST_F(SettingsTest, WrongTypesAreRefused) {
    Settings settings(schema_);
    for (const char* bad : {"gi.emc.count=8.5", "gi.emc.count=", "gi.emc.count=8 ", "gi.emc.count=8x",
                            "gi.emc.search=1", "gi.half=2", "gi.emc.count", "=8", ""}) {
        EXPECT_NE(refusal(settings, bad), "") << bad;
    }
}

TEST_F(SettingsTest, UnknownNameSuggestsTheNearest) {
    Settings settings(schema_);
    EXPECT_EQ(refusal(settings, "gi.emc.cout=8"),
              "unknown setting 'gi.emc.cout', did you mean 'gi.emc.count'?");
    EXPECT_EQ(refusal(settings, "emc.count=8"), "unknown setting 'emc.count', did you mean 'gi.emc.count'?");
    const std::string far = refusal(settings, "completely.different.thing=8");
    EXPECT_EQ(far.find("did you mean"), std::string::npos) << far;
    EXPECT_NE(far.find("completely.different.thing"), std::string::npos);
}

TEST_F(SettingsTest, PresetsOverrideOnlyTheirSettings) {
    Settings settings(schema_);
    settings.set_from_text("seed=5");
    settings.apply_preset("high");
    EXPECT_EQ(settings.get<int>("gi.emc.count"), 12);
    EXPECT_FALSE(settings.get<bool>("gi.half"));
    EXPECT_EQ(settings.get<int>("seed"), 5);
    settings.apply_preset("low");
    EXPECT_EQ(settings.get<int>("gi.emc.count"), 4);
    EXPECT_TRUE(settings.get<bool>("gi.half"));
    EXPECT_THROW(settings.apply_preset("best"), InputError);
}

TEST_F(SettingsTest, ThePresetPaperIsWhatWasPublishedAndElseTheDefault) {
    Settings settings(schema_);
    settings.set_from_text("seed=5");
    settings.apply_preset("low");
    settings.apply_preset(kPaperPreset);
    EXPECT_EQ(settings.get<int>("gi.emc.count"), 10);
    EXPECT_FALSE(settings.get<bool>("gi.half")) << "nothing was published of it";
    EXPECT_EQ(settings.get<int>("seed"), 5);
    EXPECT_EQ(preset_names().back(), "paper");
    EXPECT_NE(schema_.list_text().find("4, 8, 12, 16; paper 10"), std::string::npos);
    EXPECT_NE(schema_.list_markdown().find("| 4, 8, 12, 16; paper 10 |"), std::string::npos);
    EXPECT_NE(schema_.list_json().find("\"paper\": 10"), std::string::npos);
}

TEST_F(SettingsTest, JsonRoundTrip) {
    Settings settings(schema_);
    settings.set("gi.emc.count", 3);
    settings.set("gi.blur", 0.3f);
    settings.set("gi.half", true);
    settings.set("gi.emc.search", Search::secant);
    const std::string json = settings.to_json();
    EXPECT_NE(json.find("\"gi.blur\": 0.3"), std::string::npos) << json;
    EXPECT_EQ(json.find("seed"), std::string::npos) << "defaults are not written";
    Settings other(schema_);
    other.load_json(json, "test");
    for (const SettingInfo& info : schema_.all()) {
        EXPECT_EQ(other.text(info.name), settings.text(info.name));
    }
}

TEST_F(SettingsTest, BadJsonChangesNothingAndNamesTheFile) {
    for (const char* bad :
         {"", "{", "[1]", "{\"gi.emc.count\": 8", R"({"gi.emc.count": "8"})", R"({"gi.emc.count": 8.5})",
          R"({"gi.emc.count": 1000})", R"({"gi.half": 1})", R"({"gi.emc.search": 0})",
          R"({"gi.emc.count": null})", R"({"gi.blur": 0.2, "nonsense": 1})", "\xff\xfe"}) {
        Settings settings(schema_);
        try {
            settings.load_json(bad, "quality.json");
            FAIL() << "accepted " << bad;
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()).rfind("quality.json: ", 0), 0u) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
        EXPECT_EQ(settings.to_json(), "{}\n") << bad;
    }
}

// What prints a value recurses: a million levels ended the program.
TEST_F(SettingsTest, DeepNestingIsRefused) {
    const std::string deep(1'000'000, '[');
    Settings settings(schema_);
    try {
        settings.load_json(R"({"gi.emc.count": )" + deep + std::string(deep.size(), ']') + "}",
                           "quality.json");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "quality.json: JSON line 1, column 81: found nesting deeper than 64 levels");
    }
    // In names nothing nests.
    const std::string named =
        R"({"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[\"": 1})";
    EXPECT_TRUE(json_if_valid(named));
    EXPECT_FALSE(json_if_valid(deep));
}

TEST_F(SettingsTest, LoadFile) {
    const std::string path = testing::TempDir() + "/settings_test.json";
    std::ofstream(path) << R"({"gi.emc.count": 6})";
    Settings settings(schema_);
    settings.load_file(path);
    EXPECT_EQ(settings.get<int>("gi.emc.count"), 6);
    EXPECT_THROW(settings.load_file(path + ".missing"), InputError);
    EXPECT_THROW(settings.load_file(testing::TempDir()), InputError);
}

TEST_F(SettingsTest, RevisionCountsRealChanges) {
    Settings settings(schema_);
    const std::uint64_t before = settings.revision();
    settings.set("gi.emc.count", 8);
    EXPECT_EQ(settings.revision(), before);
    settings.set("gi.emc.count", 9);
    EXPECT_GT(settings.revision(), before);
    settings.reset("gi.emc.count");
    EXPECT_EQ(settings.get<int>("gi.emc.count"), 8);
}

TEST_F(SettingsTest, SetByTypeChecksTheRangeToo) {
    Settings settings(schema_);
    EXPECT_THROW(settings.set("gi.emc.count", 0), InputError);
    EXPECT_THROW(settings.set("gi.blur", std::nanf("")), InputError);
    EXPECT_EQ(settings.get<float>("gi.blur"), 0.1f);
}

TEST_F(SettingsTest, MistakesInTheProgramAreLogicErrors) {
    Settings settings(schema_);
    EXPECT_THROW(settings.get<int>("gi.unknown"), std::logic_error);
    EXPECT_THROW(settings.get<float>("gi.emc.count"), std::logic_error);
    EXPECT_THROW(settings.set("gi.emc.count", 1.0f), std::logic_error);
    EXPECT_THROW(schema_.declare<int>("gi.emc.count"), std::logic_error);
    for (const char* name : {"", ".a", "a.", "a..b", "A", "a b"}) {
        EXPECT_THROW(schema_.declare<int>(name), std::logic_error) << name;
    }
    SettingsSchema outside;
    outside.declare<int>("a").range(1, 2).initially(3);
    EXPECT_THROW(Settings{outside}, std::logic_error);
    SettingsSchema without_choices;
    without_choices.declare<Search>("a");
    EXPECT_THROW(Settings{without_choices}, std::logic_error);
}

TEST_F(SettingsTest, ListsShowEverythingDeclared) {
    const std::string text = schema_.list_text(), json = schema_.list_json();
    for (const char* part :
         {"gi.emc.count", "1..64", "maps", "linear in ms and MB", "march|secant", "0..2.5"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    }
    for (const char* part : {"\"gi.blur\"", "\"default\": 0.1", "\"ultra\": 16", "\"choices\""}) {
        EXPECT_NE(json.find(part), std::string::npos) << part << "\n" << json;
    }
}

TEST(SettingLists, HaveWhatIsForMeasuringInAGroupAtTheEnd) {
    SettingsSchema schema;
    schema.declare<bool>("gi.plan.maps").for_measuring();
    schema.declare<int>("gi.photons");
    for (const std::string& list : {schema.list_text(), schema.list_markdown()}) {
        const std::size_t photons = list.find("gi.photons"), heading = list.find("For measuring alone");
        EXPECT_LT(photons, heading) << list;
        EXPECT_LT(heading, list.find("gi.plan.maps")) << list;
        EXPECT_NE(list.find("gi.plan.maps"), std::string::npos) << list;
    }
    SettingsSchema none;
    none.declare<int>("gi.photons");
    EXPECT_EQ(none.list_text().find("For measuring"), std::string::npos);
    EXPECT_EQ(none.list_markdown().find("For measuring"), std::string::npos);
}

TEST(EditDistance, CountsEdits) {
    EXPECT_EQ(edit_distance("", ""), 0u);
    EXPECT_EQ(edit_distance("abc", ""), 3u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
    EXPECT_EQ(edit_distance("sitting", "kitten"), 3u);
}

}  // namespace
}  // namespace lanthorn
