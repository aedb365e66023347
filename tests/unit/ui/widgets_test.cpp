// Pages of a program with looks of its own, drawn into memory.
#include "lanthorn/ui/widgets.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace lanthorn::ui {
namespace {

const Theme kGreen{
    .chosen = vec3(0, 1, 0), .words = vec3(1, 0, 0), .faint = vec3(0.7f, 0.7f, 0), .behind = vec3(0, 0, 1)};

class Program {
  public:
    Program() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {1280, 720};
        io.DeltaTime = 0.05f;
        io.ConfigFlags = ImGuiConfigFlags_NavEnableGamepad;
        io.BackendFlags = ImGuiBackendFlags_HasGamepad;
        page.theme = &kGreen;
        page.fonts = load_fonts(kGreen, 1, &missing);
        apply_style(kGreen, 1);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    }
    ~Program() { ImGui::DestroyContext(); }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    // A frame in which `input` is pressed; says what came of it.
    std::string frame(ImGuiNavInput input = ImGuiNavInput_COUNT, int number = 1) {
        if (input != ImGuiNavInput_COUNT) {
            ImGui::GetIO().NavInputs[input] = 1;
        }
        std::string done;
        ImGui::NewFrame();
        state.update(number, page);
        begin_column(page, "page", "Page", "with words");
        done += entry(page, "one", true) ? "one" : "";
        row(page, "two", "value", [&](int step) { done += "two" + std::to_string(step); });
        end_column(page);
        done += wants_back(page) ? "back" : "";
        ImGui::Render();
        return done;
    }
    std::string tap(ImGuiNavInput input) {
        std::string done = frame(input);
        for (int i = 0; i < 3; ++i) {
            done += frame();
        }
        return done;
    }
    std::set<ImU32> colours() const {
        std::set<ImU32> found;
        const ImDrawData& drawn = *ImGui::GetDrawData();
        for (int l = 0; l < drawn.CmdListsCount; ++l) {
            for (const ImDrawVert& vertex : drawn.CmdLists[l]->VtxBuffer) {
                found.insert(vertex.col);
            }
        }
        return found;
    }

    Page page;
    PageState state;
    std::string missing;
};

TEST(Widgets, AreChosenByAGamepad) {
    Program program;
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(program.frame(), "");
    }
    EXPECT_EQ(program.tap(ImGuiNavInput_Activate), "one");
    EXPECT_EQ(program.tap(ImGuiNavInput_DpadDown), "");
    EXPECT_EQ(program.tap(ImGuiNavInput_DpadRight), "two1");
    EXPECT_EQ(program.tap(ImGuiNavInput_DpadLeft), "two-1");
    EXPECT_EQ(program.tap(ImGuiNavInput_DpadDown), "") << "down from the last is the first";
    EXPECT_EQ(program.tap(ImGuiNavInput_Activate), "one");
    EXPECT_EQ(program.tap(ImGuiNavInput_Cancel), "back");
}

TEST(Widgets, HaveTheColoursOfTheTheme) {
    Program program;
    for (int i = 0; i < 3; ++i) {
        program.frame();
    }
    const std::set<ImU32> colours = program.colours();
    EXPECT_TRUE(colours.contains(packed(kGreen.chosen)));
    EXPECT_TRUE(colours.contains(packed(kGreen.words)));
    for (const ImU32 colour : colours) {
        EXPECT_EQ(colour & packed(kGreen.behind, 0), 0u) << "no shade was asked for";
    }
}

TEST(Widgets, AMissingFontIsNamedAndReplaced) {
    Program program;
    Theme lacking = kGreen;
    lacking.text = {"no-such-font.otf", "none", 21};
    std::string missing;
    EXPECT_NE(load_fonts(lacking, 1, &missing).text, nullptr);
    EXPECT_EQ(missing, "no-such-font.otf");
    EXPECT_EQ(program.missing, "") << "ImGui's own was asked for";
}

TEST(Pages, KnowHowLongTheyAreShown) {
    Program program;
    program.frame();
    EXPECT_TRUE(program.page.appearing);
    program.frame();
    EXPECT_FALSE(program.page.appearing);
    EXPECT_NEAR(program.page.shown_seconds, 0.05, 1e-6);
    EXPECT_EQ(program.frame(ImGuiNavInput_Cancel, 2), "") << "what led to the page does not leave it";
    EXPECT_TRUE(program.page.appearing);
    EXPECT_EQ(program.page.shown_seconds, 0);
}

TEST(Units, AreAPixelAt720LinesAndNeverTooSmallToRead) {
    EXPECT_EQ(unit_of({1280, 720}, 1), 1);
    EXPECT_EQ(unit_of({2560, 1440}, 1.5), 3);
    EXPECT_EQ(unit_of({1280, 360}, 1), 0.6f);
    EXPECT_EQ(unit_of({100000, 100000}, 1), 8);
}

}  // namespace
}  // namespace lanthorn::ui
