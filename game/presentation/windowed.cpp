#include "game/presentation/windowed.h"

#include <epoxy/gl.h>
// epoxy first: GLFW must not pull in another GL header
#include <GLFW/glfw3.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <utility>

#include "game/presentation/quality.h"
#include "game/presentation/sound/ear.h"
#include "game/presentation/sound/music.h"
#include "game/presentation/tour_in_window.h"
#include "game/rules/actions.h"
#include "game/rules/components.h"
#include "game/rules/lingering.h"
#include "game/screens/interface.h"
#include "game/screens/screen_model.h"
#include "lanthorn/audio/speaker.h"
#include "lanthorn/gpu/window_context.h"
#include "lanthorn/input/devices.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/shell/frame_clock.h"
#include "lanthorn/shell/full_screen.h"
#include "lanthorn/shell/run_log.h"

namespace lanthorn::game {

namespace {

// A frame that took longer than this many steps slows the game down instead of making the next frame longer
// still.
constexpr int kMaxSteps = 6;

constexpr const char* kProgram = "lamplighter";

audio::Repertoire repertoire(std::uint64_t seed) {
    const auto music = std::make_shared<Music>(seed);
    return {effects, [music](std::span<float> stereo) { music->next(stereo); }};
}

// The game in its window: levels come and go in it, with screens over them.
class Windowed {
  public:
    explicit Windowed(const Options& options);

    ExitCode run(const StopSignal& stop);

  private:
    void resume_progress();
    void load(int level);
    void follow(const Event& event);
    void announce();
    void keep_progress();
    void play(double seconds);
    void go_on(double seconds);
    void show(double seconds, ivec2 framebuffer);
    void draw_screens(ivec2 framebuffer);
    void sound();
    void measure(double seconds);
    void apply(const Preferences& chosen);
    void apply(const input::Bindings& chosen);
    PlayerInput input();
    void fill_screen(bool whole);
    ui::Model model();
    ExitCode end(const StopSignal& stop);
    shell::Say say() {
        return [this](const std::string& line) { notices_.add(line); };
    }

    const Options& options_;
    Notices notices_;
    gpu::WindowContext window_;
    ui::Interface interface_{window_.handle(), say()};
    input::Devices devices_{window_.handle(),
                            actions()};  // listens before the interface: made after it, gone before it
    ui::LevelPictures pictures_;
    shell::KeptFile preferences_file_;
    shell::KeptFile bindings_file_;
    ProgressFile progress_;
    PictureChoice picture_;

    shell::FrameClock clock_{window_.info().software};
    shell::RunLog log_{kProgram, options_.log};

    Ear ear_;
    audio::Speaker speaker_{repertoire(options_.seed)};
    std::vector<Sound> on_screen_;  // sounds of the screens, since the frame before

    LevelInWindow level_;
    Screens screens_;
    TourInWindow tour_;
    Lingering solved_;  // since the level in play is
    double title_seconds_ = 0;
    Hints hints_;
    std::uint16_t held_ = 0;  // buttons of the last step
    bool wants_reset_ = false;
    bool uses_pad_ = false;        // last
    std::optional<Action> asked_;  // of the screen on which keys are chosen
    double frame_ms_ = 0;
    bool had_focus_ = false;
    bool quit_ = false;
};

void clear(ivec2 framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, framebuffer.x, framebuffer.y);
    glClearColor(0.03f, 0.02f, 0.015f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

Windowed::Windowed(const Options& options)
    : options_(options),
      window_(kProgram, options.size.value_or(ivec2(1280, 720)), true),
      preferences_file_(shell::config_file(kProgram, "options.json"), "options", say()),
      bindings_file_(shell::config_file(kProgram, "controls.json"), "keys and buttons", say()),
      progress_(
          options.straight || options.tour ? std::filesystem::path() : shell::data_file(kProgram, "progress"),
          say()),
      picture_(options, read_preferences(preferences_file_), window_.info().software),
      level_(options) {
    const Preferences& preferences = picture_.preferences();
    screens_.levels = static_cast<int>(level_.files().size());
    devices_.set_look(preferences.mouse, preferences.invert_look);
    speaker_.set_volumes(preferences.effects, preferences.music);
    const auto kept_bindings = [](std::string_view json, std::string_view source) {
        return std::optional(read_bindings(json, source));
    };
    devices_.controls().set_bindings(bindings_file_.read_as(kept_bindings).value_or(usual_bindings()));
    if (preferences.fullscreen && !options.size) {
        fill_screen(true);
    }
    if (options.straight || options.tour) {
        screens_.at = Screen::play;
        screens_.begun = true;
        screens_.once = !options.record.empty() || !options.replay.empty();
        load(0);
    } else {
        resume_progress();
    }
}

// Behind the title is the level that the player goes on with.
void Windowed::resume_progress() {
    const std::optional<int> found = progress_.read(level_.files());
    screens_.begun = found.has_value();
    screens_.level = found.value_or(0);
    load(screens_.level);
    if (!screens_.begun) {
        return;
    }
    try {
        progress_.restore(level_);
    } catch (const InputError& e) {
        notices_.add(std::string(e.what()) + "; it begins anew");
    }
}

// A frame that says what is coming: loading and the first frame of a level take a second or two.
void Windowed::announce() {
    const ivec2 framebuffer = window_.framebuffer_size();
    if (options_.straight || framebuffer.x <= 0 || framebuffer.y <= 0) {
        return;
    }
    glfwPollEvents();
    clear(framebuffer);
    ui::Model coming = model();
    coming.screens.at = Screen::loading;
    coming.pressed.clear();  // the screen before has taken them
    coming.screens.begun = screens_.begun && screens_.at == Screen::play;
    ui::Choices choices{picture_.preferences(), devices_.controls().bindings(), {}};
    interface_.draw(coming, choices, framebuffer);
    window_.swap_buffers();
}

void Windowed::load(int level) {
    solved_.forget();
    hints_.forget();
    ear_.forget();
    announce();
    try {
        ShownLevel& shown = level_.load(level, picture_.drawn());
        picture_.budget().disturb();
        shown.playthrough().set_devices([this] { return input(); });
    } catch (const InputError& e) {
        if (options_.straight || options_.tour) {
            throw;
        }
        level_.drop();
        notices_.add(e.what());
        screens_.at = Screen::title;
        screens_.begun = false;
    }
}

void Windowed::keep_progress() {
    if (screens_.begun) {
        progress_.keep(level_, screens_.level);
    }
}

void Windowed::follow(const Event& event) {
    const Change change = game::follow(screens_, event);
    screens_ = change.to;
    switch (change.effect) {
        case Effect::none:
            break;
        case Effect::load:
            load(screens_.level);
            break;
        case Effect::refuse:
            notices_.add(options_.record.empty() ? "a replay cannot begin again"
                                                 : "a recording cannot begin again");
            break;
        case Effect::keep:
            keep_progress();
            break;
        case Effect::quit:
            keep_progress();
            quit_ = true;
            break;
    }
}

// Of a step. What the simulation knows nothing of is taken up here.
PlayerInput Windowed::input() {
    const PlayerInput input = is_played(screens_.at) ? player_input(devices_.take()) : PlayerInput();
    const std::uint16_t fresh = static_cast<std::uint16_t>(input.held & ~held_);
    held_ = input.held;
    if ((fresh & kHint) != 0) {
        hints_.ask(level_info(level_.shown()->world()).hints);
    }
    wants_reset_ = wants_reset_ || (fresh & kReset) != 0;
    return input;
}

// What happens to the player, but not on a page.
void Windowed::play(double seconds) {
    const bool focus = glfwGetWindowAttrib(window_.handle(), GLFW_FOCUSED) == GLFW_TRUE;
    const bool left = had_focus_ && !focus;
    had_focus_ = focus;
    devices_.poll(seconds, is_played(screens_.at));
    for (const input::Trigger trigger : devices_.controls().pressed()) {
        uses_pad_ = trigger.device == input::Trigger::Device::pad;
    }
    hints_.pass(seconds);
    if (!is_played(screens_.at) || level_.shown() == nullptr) {
        return;
    }
    const bool plays_itself = options_.tour || !options_.replay.empty();
    if (devices_.asked(Action::menu) || (left && !plays_itself)) {
        follow({Happening::pause});
    } else if (std::exchange(wants_reset_, false)) {
        follow({Happening::reset});
    } else {
        go_on(seconds);
    }
}

// To the next level, where this one is done.
void Windowed::go_on(double seconds) {
    if (!options_.tour) {
        if (solved_.pass(solved(level_.shown()->world()), seconds) && !options_.straight) {
            follow({Happening::solved});
        }
    } else if (tour_.pass(level_, screens_.level, seconds)) {
        if (screens_.level + 1 == screens_.levels) {
            quit_ = true;
        } else {
            load(++screens_.level);
        }
    }
}

void Windowed::show(double seconds, ivec2 framebuffer) {
    ShownLevel* const level = level_.shown();
    if (level == nullptr) {
        clear(framebuffer);
        return;
    }
    App& app = level->app();
    app.view().size = picture_.drawn_size();
    app.world().resource_mut<PresentTarget>().size = framebuffer;
    const bool aside =
        screens_.at == Screen::levels || screens_.at == Screen::options || screens_.at == Screen::controls;
    const bool on_title = screens_.at == Screen::title || (aside && screens_.back == Screen::title);
    title_seconds_ = on_title ? title_seconds_ + seconds : 0;
    if (title_seconds_ > 0 && !picture_.preferences().less_motion) {
        level->look_about(title_seconds_);
    } else {
        level->look_with_eyes();
    }
    app.frame(is_running(screens_.at) ? seconds : 0, kMaxSteps);
}

ui::Model Windowed::model() {
    return screen_model(
        {screens_, level_, progress_, picture_, notices_, hints_, devices_.controls(), uses_pad_, frame_ms_},
        pictures_);
}

void Windowed::draw_screens(ivec2 framebuffer) {
    ui::Model shown = model();
    ui::Choices chosen{picture_.preferences(), devices_.controls().bindings(), asked_};
    chosen.preferences.preset = picture_.preset();
    chosen.preferences.frame_budget = picture_.frame_budget();
    const ui::Choices before = chosen;
    const std::optional<Event> event = interface_.draw(shown, chosen, framebuffer);
    asked_ = chosen.asked;
    if (!(chosen.preferences == before.preferences)) {
        apply(chosen.preferences);
    }
    if (!(chosen.bindings == before.bindings)) {
        apply(chosen.bindings);
    }
    if (event) {
        follow(*event);
    }
    if (event || !(chosen == before)) {
        on_screen_.push_back({.kind = static_cast<audio::Kind>(event ? SoundKind::choose : SoundKind::change),
                              .placed = false});
    }
}

void Windowed::sound() {
    Heard heard;
    if (level_.shown() != nullptr) {
        heard = ear_.listen(level_.shown()->world());
        if (!is_running(screens_.at)) {
            heard.going.clear();
        }
    }
    heard.begun.insert(heard.begun.end(), on_screen_.begin(), on_screen_.end());
    on_screen_.clear();
    speaker_.play(heard);
}

void Windowed::apply(const Preferences& chosen) {
    const bool another_window = chosen.fullscreen != picture_.preferences().fullscreen;
    picture_.choose(chosen);
    level_.draw_as(picture_.drawn());
    if (another_window) {
        fill_screen(chosen.fullscreen);
    }
    devices_.set_look(chosen.mouse, chosen.invert_look);
    speaker_.set_volumes(chosen.effects, chosen.music);
    preferences_file_.write(to_json(picture_.preferences()));
}

void Windowed::apply(const input::Bindings& chosen) {
    devices_.controls().set_bindings(chosen);
    bindings_file_.write(chosen.to_json());
}

void Windowed::fill_screen(bool whole) {
    shell::fill_screen(window_.handle(), whole, options_.size.value_or(ivec2(1280, 720)));
}

// Of the frame that has ended, `seconds` after the one before.
void Windowed::measure(double seconds) {
    frame_ms_ += 0.1 * (1000 * seconds - frame_ms_);
    if (level_.shown() != nullptr && is_running(screens_.at)) {
        picture_.budget().frame(1000 * seconds, clock_.busy(1000 * seconds));
        level_.draw_as(picture_.drawn());
    } else {
        picture_.budget().disturb();  // a picture that stands still says nothing of one that moves
    }
    constexpr const char* kScreens[] = {"loading", "title",   "levels",   "play",
                                        "paused",  "options", "controls", "finished"};  // by Screen
    log_.frame(1000 * seconds, {{{"level", level_.file(screens_.level).name()},
                                 {"screen", kScreens[static_cast<std::size_t>(screens_.at)]},
                                 {"preset", level_.preset()}},
                                picture_.drawn_size()});
}

ExitCode Windowed::run(const StopSignal& stop) {
    double last = glfwGetTime();
    const auto ended = [&] {
        return options_.straight && !options_.tour && level_.shown()->session().done();
    };
    for (int frame = 0; !window_.should_close() && !quit_ && !ended() && !stop.asked(); ++frame) {
        if (options_.close_after > 0 && frame == options_.close_after) {
            break;
        }
        glfwPollEvents();
        const double now = glfwGetTime();
        const double seconds = now - last;
        last = now;
        if (frame > 0) {
            measure(seconds);
        }
        clock_.begin();
        notices_.pass(seconds);
        play(seconds);
        const ivec2 framebuffer = window_.framebuffer_size();
        show(seconds, framebuffer);
        if (framebuffer.x > 0 && framebuffer.y > 0) {
            draw_screens(framebuffer);
        }
        sound();
        clock_.end();
        window_.swap_buffers();
    }
    return end(stop);
}

ExitCode Windowed::end(const StopSignal& stop) {
    if (!quit_) {
        keep_progress();  // the window was closed
    }
    if (!tour_.solved_all()) {
        return ExitCode::check_failed;
    }
    if (level_.shown() == nullptr) {
        return ExitCode::ok;
    }
    Playthrough& playthrough = level_.shown()->playthrough();
    session::Session& session = playthrough.session();
    session.finish();
    playthrough.say_stopped(stop);
    if (const std::string divergence = session.divergence(); !divergence.empty()) {
        std::fprintf(stderr, "lamplighter: %s: %s\n", options_.replay.c_str(), divergence.c_str());
        return ExitCode::check_failed;
    }
    return session.recording_failed() ? ExitCode::bad_input : ExitCode::ok;
}

}  // namespace

ExitCode run_windowed(const Options& options, const StopSignal& stop) {
    const Quality checked(options, options.seed);  // no level can be shown with settings that there are not
    return Windowed(options).run(stop);
}

}  // namespace lanthorn::game
