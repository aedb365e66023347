// A|B: ways to draw one scene that are held against each other.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lanthorn/core/image.h"
#include "lanthorn/core/settings.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/core/same_as_game.h"

namespace lanthorn::editor {

// A way to draw.
struct DrawnAs {
    Settings settings;
    std::string preset;  // that the settings began with; empty: not known
    std::string technique() const { return settings.text("gi.technique"); }
};

// "emc high": technique and, where it is known, preset.
std::string words_of(const DrawnAs& as);
// By "TECHNIQUE", "TECHNIQUE/PRESET" or "/PRESET", what is left out as `now` has it. Another preset's
// settings are as declared otherwise; the ones of the upscaling stay. Throws InputError for what is none.
DrawnAs drawn_as(std::string_view words, const DrawnAs& now);

// One side, drawn.
struct DrawnSide {
    ImageF final, indirect;  // display-encoded; lux. Rows from the top
    double ms = 0;           // of its last frame
    double ev100 = 0;        // that its picture is exposed by
};

// The session's scene from its pose, from cold, as that says; with that exposure, if one is given: light is
// compared, so what is brighter is to look brighter. Needs what editor_frames() needs.
DrawnSide draw_side(EditSession& session, const DrawnAs& as, const CheckedFrames& what,
                    std::optional<double> ev100 = {});
// What `settings` are with the exposure held there: EV100, before the compensation that they ask for.
Settings with_exposure(Settings settings, double ev100);
// What with_exposure() takes for the exposure that a frame of these settings has (FrameRenderer::exposure()).
double ev100_of(const Settings& settings, double exposure);
// `a` left of a bright line at that share of the width, `b` right of it. They have one size.
ImageF side_by_side(const ImageF& a, const ImageF& b, double divider);

}  // namespace lanthorn::editor
