// A window in which an App is seen: opened, fed with input, drawn into, shown. A program with a window is
//
//   shell::Window window({.title = "lamp", .actions = kActs});
//   App app;
//   add_scene_plugins(app);
//   gi::add_picture_plugins(app, "medium");
//   app.add<shell::WindowPlugin>(window);
//   spawn_scene(app, import_gltf("room.glb"));
//   app.view().camera = find_by_name(app.world(), "camera");
//   while (window.next_frame()) {
//       window.draw(app);
//   }
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lanthorn/core/image.h"
#include "lanthorn/core/math.h"
#include "lanthorn/gpu/window_context.h"
#include "lanthorn/input/devices.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/plugin.h"
#include "lanthorn/shell/frame_budget.h"

namespace lanthorn::shell {

// When next_frame() returns.
enum class Loop {
    continuous,  // at once: games
    on_events,   // when something happens to the window, or request_frame() was called: editors
};

// How a window is opened.
struct WindowOptions {
    std::string title = "Lanthorn";
    ivec2 size{1280, 720};  // pixels
    bool full_screen = false;
    bool vsync = true;
    Loop loop = Loop::continuous;
    // What a person can do in the program; must outlive the window.
    std::span<const input::Action> actions = {};
    // Milliseconds that a frame may take before the picture gets smaller, then plainer; 0: any time. Without
    // it, what usual_frame_ms() says of the device.
    std::optional<double> frame_ms = {};
    // The preset that is drawn where there is time for it. Empty: what usual_preset() says of the device.
    std::string preset = {};
};

class Window {
  public:
    // Opens it; its OpenGL context is current from then on, and outlives what draws in it: declare the window
    // before the App. Throws Error(ExitCode::no_gl) without a display or usable OpenGL, InputError for a
    // table of actions that is none.
    explicit Window(const WindowOptions& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Shows what has been drawn since the call before, and takes in what has happened to window and devices.
    // False when the program is to end: the person has closed the window, close() was called, or a StopSignal
    // was asked.
    bool next_frame();
    double seconds() const;   // from the frame before to this one; 0 in the first
    double frame_ms() const;  // the same in milliseconds, smoothed over some ten frames
    // The next next_frame() returns false; until then the window stays open.
    void close();
    // A frame is due though nothing happens to the window: something converges or moves. Any thread may call
    // it.
    void request_frame();

    // The App's picture, moved on by `seconds` (App::frame), in the whole window. The App needs a
    // WindowPlugin, or a PresentPlugin of its own. Frames of 0 seconds stand still and are no measure for
    // the frame budget.
    void draw(App& app, double seconds, int most_steps = 6);
    // Moved on by seconds(), as a program does that plays in real time.
    void draw(App& app) { draw(app, seconds()); }
    // What the App has drawn last once more, for a frame in which nothing of it can have changed: costs a
    // copy. The App must have drawn a frame.
    void draw_again(App& app);
    // Waits for an event, at most so many seconds: on pages on which nothing moves.
    void rest(double seconds);
    // Instead of a picture.
    void clear(const vec3& colour);
    // Shows what has been drawn so far, before something that takes long.
    void flush();

    // What is being spent on the picture. `follow` is called by the next draw() and when the preset or the
    // scale is another: gi::apply_preset(app, spending.preset) belongs there.
    void on_spending(std::function<void(const Spending&)> follow);
    const Spending& spending() const;  // as the next draw() will have it
    // To set what a frame may take, or to say that some frames are no measure.
    FrameBudget& budget();
    // As many pixels as the picture has where the budget allows; its shape is the window's, to which it is
    // scaled. 0: the window's own, on a CPU no more than usual_picture_size().
    void set_picture_size(ivec2 size);
    ivec2 picture_size() const;  // as it is drawn, pixels; at least 16 by 16
    // The same where the budget allows all: what render.upscale makes of fewer pixels.
    ivec2 whole_size() const;

    // Whether the devices reach the steps; while they do not the mouse is free. From the next frame on.
    void set_playing(bool playing);
    input::Devices& devices();  // what feeds the steps; see set_playing()
    bool lost_focus() const;    // in this frame

    // What the window is called.
    void set_title(const std::string& title);
    // What stands for it among others, in several sizes: three or four channels, display-encoded. Empty: the
    // system's own. Nothing where windows have none (Wayland).
    void set_icons(std::span<const ImageF> icons);

    // The whole first monitor, in its own mode, or back in a window of the size before. Nothing without a
    // monitor.
    void set_full_screen(bool whole);
    gpu::WindowContext& context();                          // OpenGL's and GLFW's
    const gpu::GlInfo& info() { return context().info(); }  // of the driver
    ivec2 framebuffer_size() const;                         // 0 by 0: minimised

    // What the window shows so far in this frame: three channels, display-encoded.
    ImageF read();
    // The same as a PNG file of its own in the folder `screenshots` of the user's data of `program`, named
    // after the time. Throws InputError where it cannot be written.
    std::filesystem::path keep_screenshot(std::string_view program);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

// The picture goes to the window, and every fixed step finds what the devices do as its resource input::Step.
// A program that records its sessions takes the steps by itself instead (session::InputStream), and adds
// PresentPlugin alone. The window must outlive the App.
//
//   fixed:  restore -> input -> gameplay.begin
class WindowPlugin final : public Plugin {
  public:
    explicit WindowPlugin(Window& window) : window_(window) {}
    std::string_view name() const override { return "window"; }
    void build(App& app) override;

  private:
    Window& window_;
};

}  // namespace lanthorn::shell
