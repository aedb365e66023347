#include "game/windowed.h"

#include <epoxy/gl.h>
// epoxy first: GLFW must not pull in another GL header
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdio>

#include "game/devices.h"
#include "game/menu.h"
#include "game/quality.h"
#include "game/session.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/window_context.h"
#include "lanthorn/runtime/present_plugin.h"

namespace lanthorn::game {

namespace {

// A frame that took longer than this many steps slows the game down instead of making the next frame longer
// still.
constexpr int kMaxSteps = 6;

}  // namespace

ExitCode run_windowed(const Options& options, const SceneData& scene) {
    gpu::WindowContext window("lamplighter", options.size.value_or(ivec2(1280, 720)), true);
    Session session(options, scene);
    App& app = session.app();
    Quality quality(options, session.seed());
    gi::add_picture_plugins(app, quality.settings());
    app.add<PresentPlugin>();
    Menu menu(window.handle());
    Devices devices(window.handle());
    session.set_devices([&devices] { return devices.take(); });

    Menu::Choices choices{.size = picture_size(options, window.info().software), .preset = options.preset};
    double frame_ms = 0;
    double last = glfwGetTime();
    for (int frame = 0; !window.should_close() && !choices.quit && !session.done(); ++frame) {
        if (options.close_after > 0 && frame == options.close_after) {
            break;
        }
        glfwPollEvents();
        const double now = glfwGetTime();
        const double seconds = now - last;
        last = now;
        frame_ms += 0.1 * (1000 * seconds - frame_ms);

        devices.poll(seconds, !choices.open);
        if (devices.menu_pressed()) {
            choices.open = !choices.open;
        }
        app.view().size = choices.size;
        const ivec2 framebuffer = window.framebuffer_size();
        app.world().resource_mut<PresentTarget>().size = framebuffer;
        app.frame(choices.open ? 0 : seconds, kMaxSteps);

        if (framebuffer.x > 0 && framebuffer.y > 0) {
            const std::string preset = choices.preset;
            menu.draw(choices, app.world(), frame_ms);
            if (choices.preset != preset) {
                quality.choose(choices.preset);
                gi::apply_settings(app, quality.settings());
            }
        }
        window.swap_buffers();
    }
    session.finish();
    if (const std::string divergence = session.divergence(); !divergence.empty()) {
        std::fprintf(stderr, "lamplighter: %s: %s\n", options.replay.c_str(), divergence.c_str());
        return ExitCode::check_failed;
    }
    return session.recording_failed() ? ExitCode::bad_input : ExitCode::ok;
}

}  // namespace lanthorn::game
