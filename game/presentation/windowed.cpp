#include "game/presentation/windowed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "game/level/asset_path.h"
#include "game/level/reveal.h"
#include "game/level/title_camera.h"
#include "game/presentation/campaign_flow.h"
#include "game/presentation/first_light.h"
#include "game/presentation/languages.h"
#include "game/presentation/player_hands.h"
#include "game/presentation/player_settings.h"
#include "game/presentation/quality.h"
#include "game/presentation/sound/game_sound.h"
#include "game/rules/actions.h"
#include "game/rules/flames.h"
#include "game/screens/interface.h"
#include "game/screens/screen_model.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/shell/run_log.h"
#include "lanthorn/shell/window.h"

namespace lanthorn::game {

namespace {

constexpr vec3 kDark(0.03f, 0.02f, 0.015f);  // where no level is

// By Screen, for the log.
constexpr std::array kScreens = {"loading", "title",   "levels",   "play",     "paused",
                                 "restart", "options", "controls", "finished", "credits"};
static_assert(kScreens.size() == static_cast<std::size_t>(Screen::credits) + 1);
// A quarter of a second: twice the frame budget that the game begins with where OpenGL runs on the CPU.
constexpr int kMostStepsAFrame = 15;
constexpr int kSettles = 32;            // frames of a level that stands still until its picture is done
constexpr double kStillSeconds = 0.03;  // that a frame of a page takes on which nothing moves
// The same while another process needs the cores.
constexpr int kSettlesEasily = 8;
constexpr double kSparedSeconds = 0.1;

// Without the files the window has the system's own.
void show_icons(shell::Window& window) {
    std::vector<ImageF> icons;
    for (const int side : {48, 128}) {
        try {
            icons.push_back(read_image(icon_path(side)));
        } catch (const InputError&) {
            return;
        }
    }
    window.set_icons(icons);
}

// The window, with what it shows over the level: screens, sound, keys.
class GameWindow {
  public:
    explicit GameWindow(const Options& options);

    ExitCode run(const StopSignal& stop);

  private:
    void announce();
    void play();
    void reveal();
    void show();
    void light();
    bool behind_title();
    shell::Spending spending();
    void show_level(Playthrough& level);
    void follow_time(Playthrough& level);
    void name_window();
    void draw_screens();
    void keep_picture();
    void log();
    ui::Model model();
    shell::Say say() {
        return [this](const std::string& line) { notices_.add(line); };
    }

    const Options& options_;
    Notices notices_;
    shell::Window window_;
    FirstLight first_light_{options_, window_.info()};
    bool lit_easily_ = false;  // by first_light_
    ui::Interface interface_{window_.context().handle(), say()};
    ui::LevelPictures pictures_;
    PlayerSettings settings_;
    PlayerHands hands_;
    Lessons lessons_;
    Reveal reveal_;
    Languages languages_{asset_path("languages"), say()};
    GameSound sound_;
    CampaignFlow flow_;
    shell::RunLog log_;
    double title_seconds_ = 0;
    int still_frames_ = 0;         // of a level that stands still
    ivec2 still_size_{0};          // of their picture
    std::string title_;            // the window's
    std::optional<Action> asked_;  // of the screen on which keys are chosen
};

GameWindow::GameWindow(const Options& options)
    : options_(options),
      window_({.title = kProgram, .size = options.size.value_or(ivec2(1280, 720)), .actions = actions()}),
      settings_(options, window_, say()),
      sound_(options.seed),
      flow_(options, notices_,
            {.announce = [this] { announce(); },
             .spending = [this] { return spending(); },
             .input =
                 [this] {
                     if (!is_played(flow_.screens().at)) {
                         return PlayerInput();
                     }
                     if (reveal_.showing()) {
                         hands_.look_on(window_.devices());
                         return PlayerInput();
                     }
                     return hands_.take(window_.devices(), flow_.level().played()->world());
                 }}),
      log_(kProgram, options.log) {
    sound_.set_volumes(settings_.preferences());
    show_icons(window_);
    window_.on_spending([this](const shell::Spending&) { flow_.level().draw_as(spending()); });
    flow_.begin();
    window_.set_playing(is_played(flow_.screens().at));
}

// A frame that says what is coming.
void GameWindow::announce() {
    hands_.forget();
    sound_.forget();
    window_.budget().disturb();
    const ivec2 framebuffer = window_.framebuffer_size();
    if (options_.straight || framebuffer.x <= 0 || framebuffer.y <= 0) {
        return;
    }
    window_.clear(kDark);
    ui::Model coming = model();
    coming.screens.begun = coming.screens.begun && coming.screens.at == Screen::play;
    coming.screens.at = Screen::loading;
    coming.pressed.clear();  // the screen before has taken them
    name_window();
    ui::Choices choices{settings_.preferences(), settings_.bindings(), {}};
    interface_.draw(coming, choices, framebuffer);
    window_.flush();
}

// What happens to the player, but not on a page.
void GameWindow::play() {
    hands_.set_hold_by_press(settings_.preferences().hold_by_press);
    hands_.pass(window_.devices().controls(), window_.seconds());
    reveal();
    if (!is_played(flow_.screens().at) || flow_.level().played() == nullptr) {
        return;
    }
    if (options_.escape_leaves && window_.devices().asked(Action::menu)) {
        window_.close();
    } else if (window_.devices().asked(Action::menu) || (window_.lost_focus() && !flow_.plays_itself())) {
        flow_.follow({Happening::pause});
    } else if (hands_.takes_reset()) {
        flow_.follow({Happening::reset});
    } else {
        lessons_.pass(hands_.done(), window_.seconds());
        flow_.pass(window_.seconds());
    }
}

// What wakes is looked at, unless the player wants to go on, or no camera that moves by itself.
void GameWindow::reveal() {
    Playthrough* const level = flow_.level().played();
    if (level == nullptr) {
        return;
    }
    if (flow_.takes_loaded()) {
        reveal_.begin(level->world());
        lessons_.begin_level();
        still_frames_ = 0;
    }
    const Screen screen = flow_.screens().at;
    if (screen == Screen::play) {
        const bool wants_on = reveal_.seconds() > 0.3 && !window_.devices().controls().pressed().empty();
        if (flow_.screens().stayed || (reveal_.showing() && wants_on)) {
            reveal_.release();
        }
        if (!settings_.preferences().less_motion) {
            reveal_.watch(level->world());
        }
        reveal_.pass(window_.seconds(), solved(level->world()));
    } else if (screen == Screen::title || screen == Screen::levels) {
        reveal_.release();
    }
}

// Whether the title is what is shown, or leads back from it.
bool GameWindow::behind_title() {
    const Screens& screens = flow_.screens();
    const bool aside = screens.at == Screen::levels || screens.at == Screen::options ||
                       screens.at == Screen::controls || screens.at == Screen::credits;
    return screens.at == Screen::title || (aside && screens.back == Screen::title);
}

shell::Spending GameWindow::spending() {
    shell::Spending spending = window_.spending();
    const LevelFile& level = flow_.level().file(flow_.screens().level);
    lit_easily_ = first_light_.holds(level, spending.preset, behind_title());
    if (lit_easily_) {
        spending.set.emplace_back(first_light_.setting());
    }
    return spending;
}

// As it is to be lit now.
void GameWindow::light() {
    if (!lit_easily_) {
        return;
    }
    const shell::Spending now = spending();
    if (!lit_easily_) {
        still_frames_ = 0;
        if (is_played(flow_.screens().at)) {
            announce();
        }
    }
    flow_.level().draw_as(now);
}

// What depends on how long a frame takes, and on what the player has chosen of the picture.
void GameWindow::follow_time(Playthrough& level) {
    constexpr double kAdapts = 0.4;      // seconds, in which an eye comes two thirds of the way
    constexpr double kNarrow = 4.0 / 3;  // windows narrower than that show as much from side to side
    const Preferences& preferences = settings_.preferences();
    auto& picture = level.app().world().resource_mut<render::RenderSettings>();
    picture.exposure_glide = static_cast<float>(1 - std::exp(-window_.seconds() / kAdapts));
    picture.exposure_compensation = flow_.level().settings()->get<float>("render.exposure.compensation") +
                                    static_cast<float>(preferences.brightness);
    picture.rim = preferences.rim ? flow_.level().settings()->get<float>("render.rim") : 0;
    const ivec2 size = glm::max(window_.framebuffer_size(), 1);
    const double narrower = std::max(kNarrow * size.y / size.x, 1.0);
    const double half = 0.5 * glm::radians(preferences.field_of_view);
    level.app().view().y_fov = static_cast<float>(2 * std::atan(narrower * std::tan(half)));
}

void GameWindow::name_window() {
    const Screens& screens = flow_.screens();
    std::string title = kProgram;
    if (screens.begun && screens.at != Screen::title) {
        title +=
            " - " +
            languages_.words(settings_.preferences().language).say(flow_.level().file(screens.level).title);
    }
    if (title != title_) {
        title_ = title;
        window_.set_title(title);
    }
}

void GameWindow::show() {
    Playthrough* const level = flow_.level().played();
    if (level == nullptr) {
        window_.clear(kDark);
        window_.rest(kStillSeconds);
        return;
    }
    show_level(*level);
}

void GameWindow::show_level(Playthrough& level) {
    light();
    const Screens& screens = flow_.screens();
    const bool on_title = behind_title();
    title_seconds_ = on_title ? title_seconds_ + (lit_easily_ ? 0 : window_.seconds()) : 0;
    if (on_title && !settings_.preferences().less_motion) {
        look_from_title(level.shown(), title_seconds_);
    } else if (reveal_.showing()) {
        reveal_.look(level.shown());
    } else {
        look_with_eyes(level.shown());
    }
    follow_time(level);
    level.app().world().resource_mut<Flicker>() = {settings_.preferences().flicker, title_seconds_};
    const bool moves = !lit_easily_ && (is_running(screens.at) || title_seconds_ > 0);
    still_frames_ = moves || window_.picture_size() != still_size_ ? 0 : still_frames_ + 1;
    still_size_ = window_.picture_size();
    // Where nothing is placed before the first picture, that is of the camera itself.
    const ecs::Entity eyes = level.shown().camera();
    if (on_title && level.shown().frame().instances.empty()) {
        level.app().view().camera = title_camera(level.shown());
    }
    if (still_frames_ > (lit_easily_ ? kSettlesEasily : kSettles)) {
        window_.draw_again(level.app());
        window_.rest(lit_easily_ ? kSparedSeconds : kStillSeconds);
    } else {
        window_.draw(level.app(), moves && is_running(screens.at) ? window_.seconds() : 0, kMostStepsAFrame);
    }
    level.app().view().camera = eyes;
}

ui::Model GameWindow::model() {
    return screen_model(
        {flow_.screens(), flow_.level(), flow_.progress(), settings_.picture(), notices_, hands_.hints(),
         lessons_, reveal_, languages_, languages_.words(settings_.preferences().language), sound_, window_,
         hands_.uses_pad(), flow_.plays_itself()},
        pictures_);
}

void GameWindow::draw_screens() {
    ui::Model shown = model();
    ui::Choices chosen{settings_.preferences(), settings_.bindings(), asked_};
    chosen.preferences.preset = settings_.picture().preset();
    chosen.preferences.frame_budget = settings_.picture().frame_budget();
    const ui::Choices before = chosen;
    const std::optional<Event> event = interface_.draw(shown, chosen, window_.framebuffer_size());
    asked_ = chosen.asked;
    if (!(chosen.preferences == before.preferences)) {
        settings_.choose(chosen.preferences);
        still_frames_ = 0;
        sound_.set_volumes(settings_.preferences());
    }
    if (!(chosen.bindings == before.bindings)) {
        settings_.choose(chosen.bindings);
    }
    if (event) {
        flow_.follow(*event);
    }
    if (event || !(chosen == before)) {
        sound_.add(event ? SoundKind::choose : SoundKind::change);
    }
}

void GameWindow::keep_picture() {
    try {
        notices_.add("picture kept: " + window_.keep_screenshot(kProgram).string());
    } catch (const InputError& e) {
        notices_.add(e.what());
    }
}

// Of the frame that has ended.
void GameWindow::log() {
    const Screens& screens = flow_.screens();
    log_.frame(1000 * window_.seconds(), {{{"level", flow_.level().file(screens.level).name()},
                                           {"screen", kScreens[static_cast<std::size_t>(screens.at)]},
                                           {"preset", flow_.level().preset()}},
                                          window_.picture_size()});
}

ExitCode GameWindow::run(const StopSignal& stop) {
    for (int frame = 0; !flow_.ended() && window_.next_frame(); ++frame) {
        if (options_.close_after > 0 && frame == options_.close_after) {
            break;
        }
        if (frame > 0) {
            log();
            first_light_.pass();
        }
        notices_.pass(window_.seconds());
        play();
        show();
        const ivec2 framebuffer = window_.framebuffer_size();
        if (framebuffer.x > 0 && framebuffer.y > 0) {
            draw_screens();
            if (window_.devices().asked(Action::picture)) {
                keep_picture();
            }
        }
        const Screen screen = flow_.screens().at;
        const Playthrough* const level = flow_.level().played();
        sound_.play(level != nullptr ? &level->world() : nullptr, is_running(screen), window_.seconds());
        name_window();
        window_.set_playing(is_played(screen));
    }
    return flow_.end(stop);
}

}  // namespace

ExitCode run_windowed(const Options& options, const StopSignal& stop) {
    const Quality checked(options, options.seed);  // no level can be shown with settings that there are not
    return GameWindow(options).run(stop);
}

}  // namespace lanthorn::game
