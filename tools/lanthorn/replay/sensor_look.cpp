#include "tools/lanthorn/replay/sensor_look.h"

#include <algorithm>

#include "lanthorn/core/settings.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gi/gi_settings.h"

namespace lanthorn::tools {

namespace {

// As many pictures of a session, and frames before each, as the game makes without a window
// (game/presentation/headless.cpp): exposure and the choice of environment maps settle over frames.
constexpr std::uint64_t kPictures = 30;
constexpr std::uint64_t kStepsAFrame = 4;
constexpr std::uint64_t kMostSensorFrames = 8;
constexpr ivec2 kSize{64, 36};
constexpr std::uint64_t kSensorSeeds = 1'000'000'000;

}  // namespace

SensorLook::SensorLook() : context_(gpu::create_headless_context()) {}

void SensorLook::draw(App& app, std::uint64_t seed) {
    SettingsSchema schema;
    gi::declare_settings(schema);
    Settings settings(schema);
    settings.set("gi.seed", static_cast<int>(seed % kSensorSeeds));
    gi::add_picture_plugins(app, settings);
    app.view().size = kSize;
}

void SensorLook::look(App& app, std::uint64_t step, std::uint64_t steps) {
    const std::uint64_t every = std::max<std::uint64_t>(steps / kPictures, 1);
    if (step % every != 0 && step != steps) {
        return;
    }
    const std::uint64_t frames =
        std::clamp<std::uint64_t>((step - looked_) / kStepsAFrame, 1, kMostSensorFrames);
    for (std::uint64_t i = 0; i < frames; ++i) {
        app.show_at(static_cast<double>(step) / kStepsPerSecond);
    }
    looked_ = step;
}

}  // namespace lanthorn::tools
