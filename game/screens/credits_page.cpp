#include <fmt/format.h>

#include <array>
#include <string>

#include "game/screens/pages.h"

namespace lanthorn::game::ui {

namespace {

struct Credit {
    const char *what, *licence;
};
// What the program is linked with, and the licence of each.
constexpr std::array kLibraries = {Credit{"Bullet Physics", "zlib"},
                                   Credit{"CLI11", "BSD-3-Clause"},
                                   Credit{"Dear ImGui", "MIT"},
                                   Credit{"Draco", "Apache-2.0"},
                                   Credit{"Embree", "Apache-2.0"},
                                   Credit{"{fmt}", "MIT"},
                                   Credit{"GLFW", "zlib"},
                                   Credit{"GLM", "MIT"},
                                   Credit{"JSON for Modern C++", "MIT"},
                                   Credit{"libepoxy", "MIT"},
                                   Credit{"libjpeg-turbo", "IJG, BSD-3-Clause"},
                                   Credit{"libpng", "libpng-2.0"},
                                   Credit{"libwebp", "BSD-3-Clause"},
                                   Credit{"meshoptimizer", "MIT"},
                                   Credit{"nanoflann", "BSD-2-Clause"},
                                   Credit{"OpenAL Soft", "LGPL-2.0-or-later"},
                                   Credit{"OpenEXR, Imath", "BSD-3-Clause"},
                                   Credit{"OpenSubdiv", "Apache-2.0"},
                                   Credit{"xxHash", "BSD-2-Clause"},
                                   Credit{"Zstandard", "BSD-3-Clause"}};
constexpr std::array kFonts = {Credit{"Cabin, by Pablo Impallari and others", "OFL-1.1"},
                               Credit{"Quattrocento, by Pablo Impallari", "OFL-1.1"}};

// A line each, which keys go through as through entries, so that they scroll; the licence at the right, or on
// a line of its own where both do not fit.
void list(const Model& model, const auto& credits) {
    const auto& page = model.page;
    for (const Credit& credit : credits) {
        const float width = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight();
        const float left = ImGui::CalcTextSize(credit.what).x, right = ImGui::CalcTextSize(credit.licence).x;
        const bool fits = left + right + line < width;
        ImGui::InvisibleButton(credit.what, {width, fits ? line : 2 * line});
        const bool chosen = lanthorn::ui::is_chosen(page);
        const ImVec2 low = ImGui::GetItemRectMin();
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const auto colour = lanthorn::ui::packed(chosen ? page.theme->chosen : page.theme->words);
        draw.AddText(low, colour, credit.what);
        draw.AddText({low.x + width - right, fits ? low.y : low.y + line},
                     lanthorn::ui::packed(page.theme->faint), credit.licence);
    }
}

}  // namespace

std::optional<Event> draw_credits(const Model& model) {
    std::optional<Event> event;
    draw_shade(model.page, 0.72f, 0.92f, lanthorn::ui::kColumnUnits);
    begin_column(model.page, "credits", model.say("Credits"),
                 model.say("Rooms, figures, sounds and music are made by the program itself."));
    if (lanthorn::ui::entry(model.page, model.say("Back").c_str(), true)) {
        event = {Happening::back};
    }
    section(model.page, model.say("The game").c_str());
    constexpr std::array kGame = {Credit{"lamplighter, Lanthorn", "MIT"}};
    list(model, kGame);
    section(model.page, model.say("Fonts").c_str());
    list(model, kFonts);
    section(model.page, model.say("Libraries").c_str());
    list(model, kLibraries);
    end_column(model.page);
    return wants_back(model.page) ? Event{Happening::back} : event;
}

}  // namespace lanthorn::game::ui
