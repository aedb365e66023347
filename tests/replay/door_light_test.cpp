// Opening the door brightens the dark half by bounces alone, over the next frames and without flicker.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "game/presentation/playthrough.h"
#include "game/presentation/quality.h"
#include "game/rules/components.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/median.h"
#include "tests/support/repository.h"

namespace lanthorn::game {
namespace {

constexpr ivec2 kSize(128, 96);
constexpr std::uint64_t kDoorStep = 100;  // when the player opens the door
// Until the door stands and the 16 frames after it that rays are shot in have passed, four steps apart.
constexpr std::uint64_t kSteps = 264;

// She walks up to the door, leaves the lantern on its table, and opens.
PlayerInput played(std::uint64_t step) {
    PlayerInput input;
    input.forward = axis(step < 40 ? 1 : 0);
    input.held = step == kDoorStep ? kUse : 0;
    return input;
}

// Median, so that the little of the lit half that is seen through the doorway does not count.
// RMS of the difference, relative to `scale`.
double change(const ImageF& a, const ImageF& b, double scale) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double d = double(a.pixels[i]) - double(b.pixels[i]);
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size())) / scale;
}

struct Frame {
    std::uint64_t step;
    double door;  // angle
    ImageF irradiance;
};

// The session as the camera in the dark half sees it: every fourth step from shortly before the door opens
// until shortly after it has come to rest.
std::vector<Frame> film() {
    Options options;
    options.level = support::repository_file("assets/lantern-room.glb");
    const auto context = gpu::create_headless_context();
    Playthrough playthrough(options, import_gltf(options.level));
    session::Session& session = playthrough.session();
    playthrough.set_devices([&session] { return played(session.steps()); });
    App& app = session.app();
    Quality(options, session.seed()).draw(app);
    app.view().size = kSize;
    app.view().camera = find_by_name(app.world(), "dark");
    const ecs::Entity door = find_by_name(app.world(), "door");
    std::vector<Frame> frames;
    while (session.steps() < kDoorStep + kSteps) {
        app.step();
        if (session.steps() + 12 < kDoorStep || session.steps() % 4 != 0) {
            continue;
        }
        app.show();
        const render::FrameRenderer& renderer = *app.world().resource<Renderer>().frame;
        frames.push_back(
            {session.steps(), app.world().get<Door>(door).angle, renderer.read(render::Aov::indirect)});
        EXPECT_EQ(renderer.nan_count(), 0u);
    }
    return frames;
}

TEST(DoorLight, BrightensTheDarkHalfWithoutFlicker) {
    const std::vector<Frame> frames = film();
    std::vector<double> lux;
    for (const Frame& frame : frames) {
        lux.push_back(static_cast<double>(support::median(frame.irradiance.pixels)));
    }
    const double before = lux.front(), after = lux.back();
    RecordProperty("lux_before", std::to_string(before));
    RecordProperty("lux_after", std::to_string(after));

    // Shut, what leaks is nothing to what comes through the open door.
    EXPECT_GT(after, 0.1);
    EXPECT_LT(before, 0.1 * after);

    double brightest = 0;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        // It grows with the door: never falls by more than a tenth of the final light below what it has been,
        brightest = std::max(brightest, lux[i]);
        EXPECT_GT(lux[i], brightest - 0.1 * after) << "step " << frames[i].step;
        // and never jumps by more than a quarter of it from frame to frame.
        EXPECT_LT(std::abs(lux[i] - lux[i - 1]), 0.25 * after) << "step " << frames[i].step;
    }
    // The light follows within frames: when the door has come to rest, it is there.
    const auto rest = std::find_if(frames.begin(), frames.end(),
                                   [&](const Frame& frame) { return frame.door == frames.back().door; });
    ASSERT_NE(rest, frames.end());
    EXPECT_NEAR(lux[static_cast<std::size_t>(rest - frames.begin())], after, 0.15 * after);
    // Then the picture stands.
    EXPECT_LT(change(frames[frames.size() - 2].irradiance, frames.back().irradiance, after), 0.01);
}

}  // namespace
}  // namespace lanthorn::game
