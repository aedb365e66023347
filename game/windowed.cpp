#include "game/windowed.h"

#include <epoxy/gl.h>
// epoxy first: GLFW must not pull in another GL header
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

#include "game/components.h"
#include "game/devices.h"
#include "game/frame_budget.h"
#include "game/frame_clock.h"
#include "game/hints.h"
#include "game/level_files.h"
#include "game/notices.h"
#include "game/progress.h"
#include "game/quality.h"
#include "game/run_log.h"
#include "game/shown_level.h"
#include "game/sound/ear.h"
#include "game/sound/speaker.h"
#include "game/ui/interface.h"
#include "game/ui/level_pictures.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/printable.h"
#include "lanthorn/gpu/window_context.h"
#include "lanthorn/replay/content_hash.h"
#include "lanthorn/runtime/present_plugin.h"

namespace lanthorn::game {

namespace {

// A frame that took longer than this many steps slows the game down instead of making the next frame longer
// still.
constexpr int kMaxSteps = 6;

// The player sees what she has done before words come over it.
constexpr double kSecondsToLook = 3;

// What to press for an action on the device that the player uses; else on the other one.
std::string key_of(const Bindings& bindings, Action action, bool pad) {
    std::string name;
    for (const Trigger trigger : bindings.of(action)) {
        const bool fits = (trigger.device == Trigger::Device::pad) == pad;
        if (name.empty() || fits) {
            name = name_of(trigger);
        }
        if (fits) {
            break;
        }
    }
    return name.starts_with("Pad ") ? name.substr(4) : name == "Escape" ? "Esc" : name;
}

// The game in its window: levels come and go in it, with screens over them.
class Windowed {
  public:
    explicit Windowed(const Options& options);

    ExitCode run(const StopSignal& stop);

  private:
    void resume_progress();
    void tour_on(double seconds);
    void load(int level);
    void follow(const Event& event);
    void announce();
    void keep_progress();
    void play(double seconds);
    void show(double seconds, ivec2 framebuffer);
    void draw_screens(ivec2 framebuffer);
    void sound();
    void measure(double seconds);
    void draw_as(const Spending& spending);
    void apply(const Preferences& chosen);
    void apply(const Bindings& chosen);
    PlayerInput input();
    void fill_screen(bool whole);
    ui::Model model();
    ivec2 picture() const;
    ivec2 drawn() const;
    std::string preset() const;
    Say say() {
        return [this](const std::string& line) { notices_.add(line); };
    }

    const Options& options_;
    Notices notices_;
    gpu::WindowContext window_;
    ui::Interface interface_{window_.handle(), say()};
    Devices devices_{window_.handle()};  // listens before the interface: made after it, gone before it
    ui::LevelPictures pictures_;
    KeptFile preferences_file_;
    KeptFile bindings_file_;
    KeptFile progress_file_;
    Preferences preferences_;
    Progress progress_;
    // What the command line asks for holds until the player chooses otherwise, and is not kept.
    bool chose_picture_ = false, chose_preset_ = false;

    FrameBudget budget_;
    FrameClock clock_{window_.info().software};
    std::string drawn_preset_;  // that the level is drawn with
    RunLog log_{options_.log};

    Ear ear_;
    Speaker speaker_{options_.seed};
    std::vector<Sound> on_screen_;  // sounds of the screens, since the frame before

    std::vector<LevelFile> levels_;
    Screens screens_;
    std::unique_ptr<ShownLevel> level_;  // null: it could not be loaded
    std::uint64_t level_hash_ = 0;       // of its file, as it was loaded
    double solved_seconds_ = 0;          // since the level in play is solved
    double title_seconds_ = 0;
    Hints hints_;
    std::uint16_t held_ = 0;  // buttons of the last step
    bool wants_reset_ = false;
    bool uses_pad_ = false;        // last
    std::optional<Action> asked_;  // of the screen on which keys are chosen
    double frame_ms_ = 0;
    bool had_focus_ = false;
    double toured_seconds_ = 0;  // since the tour of the level in play has ended
    bool quit_ = false;
    bool unsolved_ = false;  // a level that its tour left so
};

void clear(ivec2 framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, framebuffer.x, framebuffer.y);
    glClearColor(0.03f, 0.02f, 0.015f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

// Of the file `name`, if there is a place for it.
std::filesystem::path within(const std::filesystem::path& folder, const char* name) {
    return folder.empty() ? folder : folder / name;
}

Windowed::Windowed(const Options& options)
    : options_(options),
      window_("lamplighter", options.size.value_or(ivec2(1280, 720)), true),
      preferences_file_(within(options_folder(), "options.json"), "options", say()),
      bindings_file_(within(options_folder(), "controls.json"), "keys and buttons", say()),
      progress_file_(
          options.straight || options.tour ? std::filesystem::path() : within(progress_folder(), "progress"),
          "progress", say()),
      preferences_(read_preferences(preferences_file_)),
      levels_(level_files(options)) {
    screens_.levels = static_cast<int>(levels_.size());
    budget_.set(preferences_.frame_budget, preset());
    devices_.set_look(preferences_.mouse, preferences_.invert_look);
    speaker_.set_volumes(preferences_.effects, preferences_.music);
    devices_.controls().set_bindings(bindings_file_.read_as(read_bindings));
    if (preferences_.fullscreen && !options.size) {
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

ivec2 Windowed::picture() const {
    const bool chosen = preferences_.picture != ivec2(0) && (chose_picture_ || !options_.size);
    return chosen ? preferences_.picture : picture_size(options_, window_.info().software);
}

// As the time for a frame allows.
ivec2 Windowed::drawn() const {
    const glm::dvec2 size = glm::round(budget_.spending().scale * glm::dvec2(picture()));
    return glm::max(ivec2(size), 16);
}

// Where OpenGL runs on the CPU only the lowest preset leaves time to play.
std::string Windowed::preset() const {
    if (!options_.preset.empty() && !chose_preset_) {
        return options_.preset;
    }
    return !preferences_.preset.empty() ? preferences_.preset : window_.info().software ? "low" : "medium";
}

// Behind the title is the level that the player goes on with.
void Windowed::resume_progress() {
    progress_ = read_progress(progress_file_);
    const auto found = std::ranges::find(levels_, progress_.level, &LevelFile::name);
    screens_.begun = found != levels_.end();
    screens_.level = screens_.begun ? static_cast<int>(found - levels_.begin()) : 0;
    load(screens_.level);
    if (!level_ || !screens_.begun || progress_.state.empty()) {
        return;
    }
    try {
        if (progress_.level_hash != level_hash_) {
            throw InputError(progress_file_.path().string(), progress_.level, "the level is another now");
        }
        level_->restore(progress_.state, progress_file_.path().string());
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
    ui::Choices choices{preferences_, devices_.controls().bindings(), {}};
    interface_.draw(coming, choices, framebuffer);
    window_.swap_buffers();
}

void Windowed::load(int level) {
    const LevelFile& file = levels_[static_cast<std::size_t>(level)];
    solved_seconds_ = 0;
    hints_.forget();
    ear_.forget();
    announce();
    Options options = options_;
    options.level = file.path.string();
    try {
        level_hash_ = replay::hash_file(options.level);
        const SceneData scene = import_gltf(options.level);
        for (const std::string& warning : scene.warnings) {
            std::fprintf(stderr, "lamplighter: warning: %s: %s\n", printable(options.level).c_str(),
                         warning.c_str());
        }
        level_.reset();  // two at once would need twice the memory
        drawn_preset_ = budget_.spending().preset;
        level_ = std::make_unique<ShownLevel>(options, scene, drawn_preset_);
        budget_.disturb();
        level_->session().set_devices([this] { return input(); });
    } catch (const InputError& e) {
        if (options_.straight || options_.tour) {
            throw;
        }
        level_.reset();
        notices_.add(e.what());
        screens_.at = Screen::title;
        screens_.begun = false;
    }
}

void Windowed::keep_progress() {
    if (progress_file_.path().empty() || !screens_.begun || !level_) {
        return;
    }
    const LevelFile& file = levels_[static_cast<std::size_t>(screens_.level)];
    if (solved(level_->world())) {
        progress_.solved.insert(file.name());
    }
    progress_.level = file.name();
    progress_.level_hash = level_hash_;
    progress_.state = level_->state();
    progress_file_.write(to_bytes(progress_));
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
    const PlayerInput input = is_played(screens_.at) ? devices_.take() : PlayerInput();
    const std::uint16_t fresh = static_cast<std::uint16_t>(input.held & ~held_);
    held_ = input.held;
    if ((fresh & kHint) != 0) {
        hints_.ask(level_info(level_->world()).hints);
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
    for (const Trigger trigger : devices_.controls().pressed()) {
        uses_pad_ = trigger.device == Trigger::Device::pad;
    }
    hints_.pass(seconds);
    if (!is_played(screens_.at) || !level_) {
        return;
    }
    const bool plays_itself = options_.tour || !options_.replay.empty();
    if (devices_.menu_pressed() || (left && !plays_itself)) {
        follow({Happening::pause});
        return;
    }
    if (std::exchange(wants_reset_, false)) {
        follow({Happening::reset});
        return;
    }
    if (options_.tour) {
        tour_on(seconds);
        return;
    }
    solved_seconds_ = solved(level_->world()) ? solved_seconds_ + seconds : 0;
    if (solved_seconds_ > kSecondsToLook && !options_.straight) {
        follow({Happening::solved});
    }
}

// Through the levels, one after another.
void Windowed::tour_on(double seconds) {
    toured_seconds_ = level_->session().done() ? toured_seconds_ + seconds : 0;
    if (toured_seconds_ <= kSecondsToLook) {
        return;
    }
    toured_seconds_ = 0;
    if (!solved(level_->world())) {
        const std::string& level = levels_[static_cast<std::size_t>(screens_.level)].path.string();
        std::fprintf(stderr, "lamplighter: %s: its tour does not solve it\n", level.c_str());
        unsolved_ = true;
    }
    if (screens_.level + 1 == screens_.levels) {
        quit_ = true;
        return;
    }
    ++screens_.level;
    load(screens_.level);
}

void Windowed::show(double seconds, ivec2 framebuffer) {
    if (!level_) {
        clear(framebuffer);
        return;
    }
    App& app = level_->app();
    app.view().size = drawn();
    app.world().resource_mut<PresentTarget>().size = framebuffer;
    const bool aside =
        screens_.at == Screen::levels || screens_.at == Screen::options || screens_.at == Screen::controls;
    const bool on_title = screens_.at == Screen::title || (aside && screens_.back == Screen::title);
    title_seconds_ = on_title ? title_seconds_ + seconds : 0;
    if (title_seconds_ > 0 && !preferences_.less_motion) {
        level_->look_about(title_seconds_);
    } else {
        level_->look_with_eyes();
    }
    app.frame(is_running(screens_.at) ? seconds : 0, kMaxSteps);
}

ui::Model Windowed::model() {
    ui::Model model;
    model.screens = screens_;
    for (const LevelFile& file : levels_) {
        const ImTextureID picture = screens_.at == Screen::levels ? pictures_.find(file.picture()) : nullptr;
        model.levels.push_back({file.title, picture, progress_.solved.contains(file.name())});
    }
    model.picture = picture();
    if (level_ && is_played(screens_.at)) {
        model.hud = look_about(level_->world(),
                               static_cast<float>(model.picture.x) / static_cast<float>(model.picture.y));
    }
    model.frame_ms = frame_ms_;
    model.drawn = drawn();
    model.drawn_preset = budget_.spending().preset;
    model.notices = notices_.lines();
    model.hint = hints_.shown();
    model.pressed = devices_.controls().pressed();
    model.pad = devices_.controls().pad();
    for (const ActionInfo& info : actions()) {
        const auto place = static_cast<std::size_t>(info.action);
        model.keys[place] = key_of(devices_.controls().bindings(), info.action, uses_pad_);
    }
    model.symbols = preferences_.symbols;
    return model;
}

void Windowed::draw_screens(ivec2 framebuffer) {
    ui::Model shown = model();
    ui::Choices chosen{preferences_, devices_.controls().bindings(), asked_};
    chosen.preferences.preset = preset();
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
        on_screen_.push_back({.kind = event ? SoundKind::choose : SoundKind::change, .placed = false});
    }
}

void Windowed::sound() {
    Heard heard;
    if (level_) {
        heard = ear_.listen(level_->world());
        if (!is_running(screens_.at)) {
            heard.going.clear();
        }
    }
    heard.begun.insert(heard.begun.end(), on_screen_.begin(), on_screen_.end());
    on_screen_.clear();
    speaker_.play(heard);
}

void Windowed::apply(const Preferences& chosen) {
    chose_picture_ = chose_picture_ || chosen.picture != preferences_.picture;
    const bool another_preset = chosen.preset != preset();
    const bool another_window = chosen.fullscreen != preferences_.fullscreen;
    const std::string kept_preset = preferences_.preset;
    preferences_ = chosen;
    if (another_preset) {
        chose_preset_ = true;
    } else {
        preferences_.preset = kept_preset;
    }
    budget_.set(preferences_.frame_budget, preset());
    draw_as(budget_.spending());
    if (another_window) {
        fill_screen(chosen.fullscreen);
    }
    devices_.set_look(chosen.mouse, chosen.invert_look);
    speaker_.set_volumes(chosen.effects, chosen.music);
    preferences_file_.write(to_json(preferences_));
}

void Windowed::draw_as(const Spending& spending) {
    if (level_ && spending.preset != drawn_preset_) {
        level_->choose_preset(spending.preset);
        drawn_preset_ = spending.preset;
    }
}

// Of the frame that has ended, `seconds` after the one before.
void Windowed::measure(double seconds) {
    frame_ms_ += 0.1 * (1000 * seconds - frame_ms_);
    if (level_ && is_running(screens_.at)) {
        budget_.frame(1000 * seconds, clock_.busy(1000 * seconds));
        draw_as(budget_.spending());
    } else {
        budget_.disturb();  // a picture that stands still says nothing of one that moves
    }
    constexpr const char* kScreens[] = {"loading", "title",   "levels",   "play",
                                        "paused",  "options", "controls", "finished"};  // by Screen
    log_.frame(1000 * seconds, {levels_[static_cast<std::size_t>(screens_.level)].name(),
                                kScreens[static_cast<std::size_t>(screens_.at)], drawn_preset_, drawn()});
}

void Windowed::apply(const Bindings& chosen) {
    devices_.controls().set_bindings(chosen);
    bindings_file_.write(chosen.to_json());
}

void Windowed::fill_screen(bool whole) {
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    if (mode == nullptr) {
        return;
    }
    if (whole) {
        glfwSetWindowMonitor(window_.handle(), monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    } else {
        const ivec2 size =
            glm::min(options_.size.value_or(ivec2(1280, 720)), ivec2(mode->width, mode->height));
        glfwSetWindowMonitor(window_.handle(), nullptr, (mode->width - size.x) / 2,
                             (mode->height - size.y) / 2, size.x, size.y, GLFW_DONT_CARE);
    }
}

ExitCode Windowed::run(const StopSignal& stop) {
    double last = glfwGetTime();
    const auto ended = [&] { return options_.straight && !options_.tour && level_->session().done(); };
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
    if (!quit_) {
        keep_progress();  // the window was closed
    }
    if (unsolved_) {
        return ExitCode::check_failed;
    }
    if (!level_) {
        return ExitCode::ok;
    }
    Session& session = level_->session();
    session.finish();
    session.say_stopped(stop);
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
