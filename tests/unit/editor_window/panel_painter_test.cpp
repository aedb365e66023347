// Which parts of the window are drawn: those of panels that differ from what stands there.
#include "tools/editor/window/panel_painter.h"

#include <gtest/gtest.h>

#include <bit>
#include <functional>

namespace lanthorn::edit_window {
namespace {

constexpr ivec2 kSize(400, 300);

// Panels beside each other, and now and then one over both, in an ImGui without a window.
class PanelPainterTest : public testing::Test {
  protected:
    PanelPainterTest() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {400, 300};
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        io.Fonts->SetTexID(image_id(1));
    }
    ~PanelPainterTest() override { ImGui::DestroyContext(); }
    static ImTextureID image_id(std::uintptr_t number) { return std::bit_cast<ImTextureID>(number); }
    static void panel(const char* name, float x, float width, const std::function<void()>& fill) {
        ImGui::SetNextWindowPos({x, 0});
        ImGui::SetNextWindowSize({width, 300});
        ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground);
        fill();
        ImGui::End();
    }
    // What is drawn, without drawing it.
    std::vector<Box> paint(const char* words, bool popup = false, std::uint64_t pictures = 0) {
        ImGui::GetIO().DeltaTime = 0.1f;
        ImGui::NewFrame();
        panel("left", 0, 100, [&] { ImGui::TextUnformatted(words); });
        panel("right", 100, 300, [&] { ImGui::Image(image_id(7), {50, 50}); });
        if (popup) {
            panel("over", 50, 100, [] { ImGui::TextUnformatted("over both"); });
        }
        ImGui::Render();
        drawn_ = 0;
        const std::vector<Box> parts =
            painter_.paint(*ImGui::GetDrawData(), {}, kSize, pictures, [&](ImDrawData& some) {
                drawn_ += some.CmdListsCount;
                for (int i = 0; i < some.CmdListsCount; ++i) {
                    for (const ImDrawCmd& command : some.CmdLists[i]->CmdBuffer) {
                        clips_.push_back(command.ClipRect);
                    }
                }
            });
        return parts;
    }

    PanelPainter painter_;
    std::vector<ImVec4> clips_;
    int drawn_ = 0;
};

const std::vector<Box> kAll = {{0, 0, 400, 300}};

TEST_F(PanelPainterTest, PaintsWhatDiffers) {
    EXPECT_EQ(paint("one"), kAll);
    paint("one");  // ImGui sizes a window in its second frame
    EXPECT_TRUE(paint("one").empty());
    EXPECT_EQ(drawn_, 0);
    clips_.clear();
    const std::vector<Box> parts = paint("two");
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_LE(parts[0].x + parts[0].width, 100);
    EXPECT_GE(drawn_, 1);
    for (const ImVec4& clip : clips_) {
        EXPECT_LE(clip.z, 100) << "nothing is drawn beside it";
    }
    EXPECT_TRUE(paint("two").empty());
}

// The words of a window are its own; a texture's texels are not among them.
TEST_F(PanelPainterTest, PaintsPicturesThatShowSomethingElse) {
    paint("one");
    paint("one");
    ASSERT_TRUE(paint("one").empty());
    const std::vector<Box> parts = paint("one", false, 1);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_GE(parts[0].x, 100);
    EXPECT_TRUE(paint("one", false, 1).empty());
}

TEST_F(PanelPainterTest, PaintsAllOfItWhereWindowsComeAndGoOrNothingStands) {
    paint("one");
    paint("one");
    ASSERT_TRUE(paint("one").empty());
    EXPECT_EQ(paint("one", true), kAll);
    paint("one", true);
    EXPECT_TRUE(paint("one", true).empty());
    EXPECT_EQ(paint("one"), kAll);
    ASSERT_TRUE(paint("one").empty());
    painter_.forget();
    EXPECT_EQ(paint("one"), kAll);
}

TEST(PanelParts, CoverAllAndDoNotMeet) {
    const std::vector<Box> apart = {{0, 0, 10, 10}, {20, 0, 10, 10}};
    EXPECT_EQ(without_overlaps(apart), apart);
    // The third joins what the first two left apart.
    const std::vector<Box> joined = without_overlaps({{0, 0, 10, 10}, {20, 0, 10, 10}, {5, 5, 20, 2}});
    ASSERT_EQ(joined.size(), 1u);
    EXPECT_EQ(joined[0], (Box{0, 0, 30, 10}));
    EXPECT_TRUE(common({0, 0, 10, 10}, {10, 0, 5, 5}).empty());
}

}  // namespace
}  // namespace lanthorn::edit_window
