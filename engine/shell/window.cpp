#include "lanthorn/shell/window.h"

#include <epoxy/gl.h>
// epoxy first: GLFW must not pull in another GL header
#include <GLFW/glfw3.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/shell/frame_clock.h"
#include "engine/shell/full_screen.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/runtime/render_plugin.h"

namespace lanthorn::shell {

namespace {

constexpr double kWaitAtATime = 0.2;  // seconds: a StopSignal is looked for as often
constexpr double kNewFrame = 0.1;     // that the newest frame counts for in the smoothed time
constexpr int kSmallest = 16;         // pixels a side
constexpr int kLargest = 16384;       // likewise

// Of the window's shape, with as many pixels as `wanted` has.
ivec2 in_shape_of(ivec2 window, ivec2 wanted) {
    const double share =
        std::sqrt(static_cast<double>(wanted.x) * wanted.y / (static_cast<double>(window.x) * window.y));
    return glm::clamp(ivec2(glm::round(share * glm::dvec2(window))), kSmallest, kLargest);
}

// As large as the window, with as many pixels as `most` has at most.
ivec2 fitted(ivec2 window, ivec2 most) {
    const bool fits = std::int64_t{window.x} * window.y <= std::int64_t{most.x} * most.y;
    return fits ? window : in_shape_of(window, most);
}

}  // namespace

struct Window::State {
    explicit State(const WindowOptions& options)
        : context(options.title, options.size, options.vsync),
          devices(context.handle(), options.actions),
          clock(context.info().software),
          windowed_size(options.size),
          loop(options.loop) {
        const bool software = context.info().software;
        budget.set(options.frame_ms.value_or(usual_frame_ms(software)),
                   options.preset.empty() ? usual_preset(software) : options.preset);
    }

    bool ended() const { return closed || context.should_close() || StopSignal::asked(); }
    void wait();
    void measure();

    gpu::WindowContext context;
    input::Devices devices;
    FrameClock clock;
    FrameBudget budget;
    std::function<void(const Spending&)> follow;
    std::optional<Spending> followed;
    ivec2 windowed_size;
    ivec2 picture{0};  // 0: the window's own
    Loop loop;
    std::atomic<bool> requested{true};
    double last = 0;  // GLFW's time at the frame before
    double seconds = 0, frame_ms = 0;
    int frames = 0;
    bool moved_on = false;  // a picture has been drawn since the frame began, and did not stand still
    bool playing = true;
    bool had_focus = false, lost_focus = false;
    bool closed = false;
};

// An event ends the wait before its time. A spurious one costs a frame.
void Window::State::wait() {
    while (!requested.exchange(false) && !ended()) {
        const double begun = glfwGetTime();
        glfwWaitEventsTimeout(kWaitAtATime);
        if (glfwGetTime() - begun < kWaitAtATime) {
            return;
        }
    }
    glfwPollEvents();
}

void Window::State::measure() {
    frame_ms += kNewFrame * (1000 * seconds - frame_ms);
    if (std::exchange(moved_on, false)) {
        budget.frame(1000 * seconds, clock.busy(1000 * seconds));
    } else {
        budget.disturb();  // a picture that stands still says nothing of one that moves
    }
}

Window::Window(const WindowOptions& options) : state_(std::make_unique<State>(options)) {
    if (options.full_screen) {
        set_full_screen(true);
    }
}

Window::~Window() = default;

bool Window::next_frame() {
    State& s = *state_;
    if (s.frames > 0) {
        s.clock.end();
        s.context.swap_buffers();
    }
    if (s.ended()) {
        return false;
    }
    if (s.loop == Loop::on_events) {
        s.wait();
    } else {
        glfwPollEvents();
    }
    const double now = glfwGetTime();
    s.seconds = s.frames > 0 ? now - s.last : 0;
    s.last = now;
    if (s.frames > 0) {
        s.measure();
    }
    ++s.frames;
    s.clock.begin();
    const bool focus = glfwGetWindowAttrib(s.context.handle(), GLFW_FOCUSED) == GLFW_TRUE;
    s.lost_focus = s.had_focus && !focus;
    s.had_focus = focus;
    s.devices.poll(s.seconds, s.playing);
    return !s.ended();
}

double Window::seconds() const {
    return state_->seconds;
}

double Window::frame_ms() const {
    return state_->frame_ms;
}

void Window::close() {
    state_->closed = true;
}

void Window::request_frame() {
    state_->requested = true;
    glfwPostEmptyEvent();
}

void Window::draw(App& app, double seconds, int most_steps) {
    State& s = *state_;
    const Spending& spending = s.budget.spending();
    if (s.follow && !(s.followed == spending)) {
        s.followed = spending;
        s.follow(spending);
    }
    app.view().size = picture_size();
    app.view().whole = whole_size();
    app.world().resource_mut<PresentTarget>().size = framebuffer_size();
    app.frame(seconds, most_steps);
    s.moved_on = seconds > 0;
}

void Window::draw_again(App& app) {
    const auto& renderer = app.world().resource<Renderer>();
    renderer.drawn(ViewId::first).frame->present(0, framebuffer_size());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, framebuffer_size().x, framebuffer_size().y);
}

void Window::rest(double seconds) {
    glfwWaitEventsTimeout(seconds);
}

void Window::clear(const vec3& colour) {
    const ivec2 size = framebuffer_size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.x, size.y);
    glClearColor(colour.r, colour.g, colour.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

void Window::flush() {
    state_->context.swap_buffers();
    glfwPollEvents();
}

void Window::on_spending(std::function<void(const Spending&)> follow) {
    state_->follow = std::move(follow);
    state_->followed.reset();
}

const Spending& Window::spending() const {
    return state_->budget.spending();
}

FrameBudget& Window::budget() {
    return state_->budget;
}

void Window::set_picture_size(ivec2 size) {
    state_->picture = size;
}

ivec2 Window::picture_size() const {
    const double scale = state_->budget.spending().scale;
    return glm::max(ivec2(glm::round(scale * glm::dvec2(whole_size()))), kSmallest);
}

ivec2 Window::whole_size() const {
    const State& s = *state_;
    ivec2 whole = glm::max(framebuffer_size(), kSmallest);
    if (s.picture != ivec2(0)) {
        // Minimised, a window has no shape.
        whole = framebuffer_size() == ivec2(0) ? s.picture : in_shape_of(whole, s.picture);
    } else if (s.context.info().software) {
        whole = fitted(whole, usual_picture_size(true));
    }
    return glm::max(whole, kSmallest);
}

void Window::set_playing(bool playing) {
    state_->playing = playing;
}

input::Devices& Window::devices() {
    return state_->devices;
}

bool Window::lost_focus() const {
    return state_->lost_focus;
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(state_->context.handle(), title.c_str());
}

void Window::set_icons(std::span<const ImageF> icons) {
    std::vector<std::vector<unsigned char>> bytes;
    std::vector<GLFWimage> images;
    for (const ImageF& icon : icons) {
        std::vector<unsigned char>& of_icon = bytes.emplace_back();
        for (int i = 0; i < icon.width * icon.height; ++i) {
            for (int c = 0; c < 4; ++c) {
                const float value = c < icon.channels ? icon.at(i % icon.width, i / icon.width, c) : 1.0f;
                const auto byte = std::lround(255 * std::clamp(value, 0.0f, 1.0f));
                of_icon.push_back(static_cast<unsigned char>(byte));
            }
        }
        images.push_back({icon.width, icon.height, of_icon.data()});
    }
    glfwSetWindowIcon(state_->context.handle(), static_cast<int>(images.size()), images.data());
}

void Window::set_full_screen(bool whole) {
    fill_screen(state_->context.handle(), whole, state_->windowed_size);
}

gpu::WindowContext& Window::context() {
    return state_->context;
}

ivec2 Window::framebuffer_size() const {
    return state_->context.framebuffer_size();
}

void WindowPlugin::build(App& app) {
    if (!app.has("present")) {
        app.add<PresentPlugin>();
    }
    app.world().insert_resource(input::Step());
    Window& window = window_;
    app.fixed_schedule()
        .add("input", [&window](ecs::ResMut<input::Step> step) { *step = window.devices().take(); })
        .after("restore")
        .before("gameplay.begin");
}

}  // namespace lanthorn::shell
