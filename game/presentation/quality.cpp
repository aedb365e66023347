#include "game/presentation/quality.h"

#include <algorithm>
#include <cmath>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/runtime/present_plugin.h"

namespace lanthorn::game {

namespace {
constexpr float kAir = 0.0012f;  // 1/m
}  // namespace

const SettingsSchema& Quality::declare(SettingsSchema& schema) {
    gi::declare_settings(schema);
    return schema;
}

Quality::Quality(const Options& options, std::uint64_t seed)
    : settings_(declare(schema_)), set_(options.set) {
    settings_.set("gi.seed", static_cast<int>(seed % 1'000'000'000));
    settings_.set("render.antialias", true);
    settings_.set_from_text("render.upscale=temporal");  // where fewer pixels are drawn
    settings_.set("render.exposure.darkest", 0.1f);      // nits: the dark stays dark
    settings_.set("render.bloom.share", 0.1f);
    settings_.set("render.rim", 0.2f);
    settings_.set("render.shoulder", 0.5f);
    choose({options.preset});
}

void Quality::choose(const shell::Spending& spending) {
    if (!spending.preset.empty()) {
        settings_.apply_preset(spending.preset);
    }
    // Beams are seen on their way, but not at the price of steps in the picture.
    settings_.set("render.air.scattering", spending.preset == "low" ? 0.0f : kAir);
    settings_.set("gi.gather.points", gi::EmcSettings().gather_points);
    for (const std::string& assignment : spending.set) {
        settings_.set_from_text(assignment);
    }
    const double points = spending.scale * spending.scale * settings_.get<int>("gi.gather.points");
    settings_.set("gi.gather.points", std::max(1, static_cast<int>(std::lround(points))));
    for (const std::string& assignment : set_) {
        settings_.set_from_text(assignment);
    }
}

void Quality::draw(App& app) const {
    if (app.has("present")) {
        gi::apply_settings(app, settings_);
        return;
    }
    gi::add_picture_plugins(app, settings_);
    app.add<PresentPlugin>();
}

void Quality::draw(App& app, const shell::Spending& spending) {
    choose(spending);
    draw(app);
}

}  // namespace lanthorn::game
