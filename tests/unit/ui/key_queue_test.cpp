// Keys typed faster than frames come, without a window.
#include "lanthorn/ui/navigation.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <vector>

namespace lanthorn::ui {
namespace {

constexpr int kEnter = 7, kUp = 8;

class Keys : public testing::Test {
  protected:
    Keys() {
        ImGui::CreateContext();
        ImGui::GetIO().KeyMap[ImGuiKey_Enter] = kEnter;
    }
    ~Keys() override { ImGui::DestroyContext(); }

    // The key that is down then; -1: none.
    int frame(const std::vector<int>& pressed = {}, bool takes_keys = true) {
        queue_.feed(1, takes_keys, pressed, [](int) { return false; });
        for (int key = 0; key < static_cast<int>(std::size(ImGui::GetIO().KeysDown)); ++key) {
            if (ImGui::GetIO().KeysDown[key]) {
                return key;
            }
        }
        return -1;
    }

  private:
    KeyQueue queue_;
};

TEST_F(Keys, ComeOneEveryOtherFrameInTheirOrder) {
    frame();
    const int first = frame({kUp, kEnter, kUp});
    std::vector<int> shown{first};
    for (int i = 0; i < 7; ++i) {
        shown.push_back(frame());
    }
    EXPECT_EQ(shown, (std::vector{-1, kUp, -1, kEnter, -1, kUp, -1, -1}));
}

TEST_F(Keys, OfNoScreenAreDropped) {
    frame({}, false);
    frame({kUp}, false);
    frame({kUp});
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(frame(), -1);
    }
}

TEST_F(Keys, ThatImGuiCannotNumberAreDropped) {
    frame();
    frame({-1, 100000});
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(frame(), -1);
    }
}

}  // namespace
}  // namespace lanthorn::ui
