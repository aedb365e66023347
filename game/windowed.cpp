#include "game/windowed.h"

#include <epoxy/gl.h>
// epoxy first: GLFW must not pull in another GL header
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdio>

#include "game/devices.h"
#include "game/menu.h"
#include "game/presentation.h"
#include "game/quality.h"
#include "game/session.h"
#include "lanthorn/gpu/window_context.h"

namespace lanthorn::game {

namespace {

// A frame that took longer than this many steps slows the game down instead of making the next frame longer
// still.
constexpr int kMaxSteps = 6;

}  // namespace

ExitCode run_windowed(const Options& options, const SceneData& scene, const Level& level) {
    Session session(options, level);
    Quality quality(options);
    gpu::WindowContext window("lamplighter", options.size.value_or(ivec2(1280, 720)), true);
    Presentation presentation(scene, level, window.info());
    Menu menu(window.handle());
    Devices devices(window.handle());

    Menu::Choices choices{.size = picture_size(options, window.info().software), .preset = options.preset};
    double waiting = 0;  // simulated time not yet stepped, seconds
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
        if (!choices.open) {
            waiting = std::min(waiting + seconds, kMaxSteps * kStep);
            for (; waiting >= kStep && !session.done(); waiting -= kStep) {
                session.step(devices.take());
            }
        }

        const ivec2 framebuffer = window.framebuffer_size();
        if (framebuffer.x > 0 && framebuffer.y > 0) {
            presentation.draw(between(session.view_before(), session.view(), waiting / kStep), choices.size,
                              quality.settings());
            presentation.show(framebuffer);
            const std::string preset = choices.preset;
            menu.draw(choices, session.view(), frame_ms);
            if (choices.preset != preset) {
                quality.choose(choices.preset);
            }
        }
        window.swap_buffers();
    }
    session.finish();
    if (const auto& divergence = session.divergence()) {
        std::fprintf(stderr, "lamplighter: %s: %s\n", options.replay.c_str(), divergence->describe().c_str());
        return ExitCode::check_failed;
    }
    return session.recording_failed() ? ExitCode::bad_input : ExitCode::ok;
}

}  // namespace lanthorn::game
