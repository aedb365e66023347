#include "tools/editor/core/two_sides.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "lanthorn/core/error.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/render_plugin.h"

namespace lanthorn::editor {

namespace {

constexpr double kDarkestEv = -20, kBrightestEv = 40;  // that render.exposure.ev100 takes
constexpr const char* kUpscale = "render.upscale";

}  // namespace

std::string words_of(const DrawnAs& as) {
    return as.technique() + (as.preset.empty() ? "" : " " + as.preset);
}

DrawnAs drawn_as(std::string_view words, const DrawnAs& now) {
    const std::size_t slash = words.find('/');
    const std::string technique(words.substr(0, slash));
    DrawnAs result = now;
    if (slash != std::string_view::npos) {
        result.preset = std::string(words.substr(slash + 1));
        Settings fresh(now.settings.schema());
        fresh.apply_preset(result.preset);
        fresh.set_from_text("gi.technique", now.technique());
        fresh.set_from_text(kUpscale, now.settings.text(kUpscale));
        result.settings = std::move(fresh);
    }
    if (!technique.empty() || slash == std::string_view::npos) {
        result.settings.set_from_text("gi.technique", technique);
    }
    return result;
}

double ev100_of(const Settings& settings, double exposure) {
    return render::ev100_of_exposure(exposure) +
           static_cast<double>(settings.get<float>("render.exposure.compensation"));
}

Settings with_exposure(Settings settings, double ev100) {
    settings.set_from_text("render.exposure.mode", "manual");
    settings.set_from_text(
        "render.exposure.ev100",
        fmt::format("{}", static_cast<float>(std::clamp(ev100, kDarkestEv, kBrightestEv))));
    return settings;
}

DrawnSide draw_side(EditSession& session, const DrawnAs& as, const CheckedFrames& what,
                    std::optional<double> ev100) {
    begin_cold(session, ev100 ? with_exposure(as.settings, *ev100) : as.settings, what.size);
    const ecs::World& world = std::as_const(session.app()).world();
    const auto frame_made = [&]() -> const render::FrameRenderer& {
        return *world.resource<Renderer>().frame;
    };
    for (int i = 1; i < what.frames; ++i) {
        session.app().show();
        frame_made().read(render::Aov::depth);  // the last frame's time holds nothing of it
    }
    const auto begun = std::chrono::steady_clock::now();
    session.app().show();
    const render::FrameRenderer& frame = frame_made();
    DrawnSide side;
    side.final = frame.read(render::Aov::final);  // waits for the frame
    side.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
    side.indirect = frame.read(render::Aov::indirect);
    side.ev100 = ev100_of(as.settings, static_cast<double>(frame.exposure()));
    return side;
}

ImageF side_by_side(const ImageF& a, const ImageF& b, double divider) {
    ImageF both = b;
    const int at = static_cast<int>(std::lround(divider * b.width));
    for (int y = 0; y < b.height; ++y) {
        for (int x = 0; x <= std::min(at, b.width - 1); ++x) {
            for (int c = 0; c < b.channels; ++c) {
                both.at(x, y, c) = x == at ? 1.0f : a.at(x, y, c);
            }
        }
    }
    return both;
}

}  // namespace lanthorn::editor
