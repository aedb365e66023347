#include "game/screens/style.h"

namespace lanthorn::game::ui {

const lanthorn::ui::Theme& theme() {
    // Cabin, a humanist sans serif, for words; Quattrocento, a sober Roman, for headings (both SIL Open Font
    // License, packages fonts-cabin and fonts-quattrocento).
    static const lanthorn::ui::Theme lamplighter{
        .text = {"Cabin-Medium.otf", "cabin", 21},
        .heading = {"Quattrocento-Regular.otf", "quattrocento", 31},
        .title = {"Quattrocento-Regular.otf", "quattrocento", 86, kName},
        .name = kName,
        .chosen = vec3(0.980f, 0.760f, 0.420f),  // lamplight
        .words = vec3(0.965f, 0.925f, 0.860f),   // parchment
        .faint = vec3(0.750f, 0.690f, 0.610f),   // dust
        .behind = vec3(0.055f, 0.040f, 0.030f),  // night
    };
    return lamplighter;
}

ImU32 lamplight(float alpha) {
    return lanthorn::ui::packed(theme().chosen, alpha);
}
ImU32 parchment(float alpha) {
    return lanthorn::ui::packed(theme().words, alpha);
}
ImU32 night(float alpha) {
    return lanthorn::ui::packed(theme().behind, alpha);
}

}  // namespace lanthorn::game::ui
