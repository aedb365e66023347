#include "game/presentation/album/tour_album.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "game/level/level_files.h"
#include "game/level/reveal.h"
#include "game/level/title_camera.h"
#include "game/presentation/album/animated_picture.h"
#include "game/presentation/album/page.h"
#include "game/presentation/playthrough.h"
#include "game/presentation/quality.h"
#include "game/rules/components.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/time_step.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"

namespace lanthorn::game {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kStepsAFrame = 4;  // 15 frames a second of play
constexpr std::uint64_t kAfterwards = 96;  // steps: what was woken comes to its full light
constexpr int kSettling = 20;       // frames until exposure, maps and gathered light are those of a new view
constexpr int kFramesAPicture = 6;  // of the animated picture
constexpr int kPictureMs = 100;     // six frames are 0.4 s of play
constexpr int kStillMs = 900;       // the first and the last picture of a level stay
constexpr int kMovingWidth = 480;   // pixels
constexpr float kMovingQuality = 70;

ivec2 moving_size(ivec2 size) {
    const int width = std::min(kMovingWidth, size.x);
    return {width, std::max(1, width * size.y / size.x)};
}

// What comes of the tour: files, and what the page says of them. Without a folder nothing does.
class Pictures {
  public:
    Pictures(const fs::path& folder, ivec2 size)
        : folder_(folder), moving_(moving_size(size), kMovingQuality) {}

    void begin(const LevelFile& level) {
        name_ = level.name();
        album_.levels.push_back({level.title, "", {}});
    }
    void still(const ImageF& picture, const char* words) {
        std::vector<AlbumPicture>& pictures = album_.levels.back().pictures;
        const std::string file = fmt::format("{}-{}.png", name_, pictures.size() + 1);
        write_image(folder_ / file, picture);
        pictures.push_back({file, words});
        ++stills_;
    }
    void move(const ImageF& picture, int milliseconds) { moving_.add(picture, milliseconds); }
    void end(const std::string& words) { album_.levels.back().words = words; }

    void write_page(const std::string& words) {
        album_.moving = "tour.webp";
        album_.words = words;
        moving_.write(folder_ / album_.moving);
        write_file(folder_ / "index.html", page(album_));
    }
    int stills() const { return stills_; }

  private:
    fs::path folder_;
    std::string name_;
    AnimatedPicture moving_;
    Album album_;
    int stills_ = 0;
};

// How a level is drawn while it is played, for the picture that moves, and for its stills.
struct Drawn {
    std::string preset;
    ivec2 size;
};
struct Drawing {
    Drawn playing, stills;
};

// One level, from its beginning to the end of its tour and a little on.
class Played {
  public:
    Played(const Options& options, const SceneData& scene, const Drawing& drawing, Pictures* pictures,
           const StopSignal& stop)
        : level_(options, scene),
          quality_(options, level_.session().seed()),
          drawing_(drawing),
          pictures_(pictures),
          stop_(stop) {
        draw_as(drawing.playing);
    }

    std::uint64_t steps() { return toured() + kAfterwards; }
    double seconds() { return static_cast<double>(toured()) / kStepsPerSecond; }
    bool solved() const { return game::solved(level_.world()); }

    void play(Progress& progress) {
        level_.app().show();  // its space is known from the first frame on
        reveal_.begin(level_.world());
        keep_still(Seen::whole, "as it is found");
        int frame = 0;
        for (std::uint64_t step = kStepsAFrame; step <= steps() && !stop_.asked(); step += kStepsAFrame) {
            level_.app().show_at(static_cast<double>(step) / kStepsPerSecond);
            reveal_.watch(level_.world());
            progress.update(step);
            if (pictures_ != nullptr && frame++ % kFramesAPicture == 0) {
                pictures_->move(picture(), kPictureMs);
            }
            if (step / kStepsAFrame == toured() / kStepsAFrame / 2) {
                keep_still(Seen::by_player, "on the way");
            }
        }
        reveal_.pass(Reveal::kEase, true);
        keep_still(reveal_.showing() ? Seen::woken : Seen::whole, solved() ? "solved" : "as it was left");
    }

  private:
    std::uint64_t toured() { return *level_.session().length(); }

    void draw_as(const Drawn& drawn) {
        quality_.draw(level_.app(), {drawn.preset});
        level_.app().view().size = drawn.size;
    }

    // By the level's own camera; by the player's; from where the game shows what has woken.
    enum class Seen { whole, by_player, woken };

    // The simulation waits.
    void keep_still(Seen seen, const char* words) {
        if (pictures_ == nullptr) {
            return;
        }
        draw_as(drawing_.stills);
        for (int i = 0; i < kSettling && !stop_.asked(); ++i) {
            if (seen == Seen::whole) {
                look_from_title(level_.shown(), 0);
            } else if (seen == Seen::woken) {
                reveal_.look(level_.shown());
            }
            level_.app().show();
        }
        if (!stop_.asked()) {
            const ImageF still = picture();
            pictures_->still(still, words);
            if (seen != Seen::by_player) {
                pictures_->move(still, kStillMs);
            }
        }
        draw_as(drawing_.playing);
        look_with_eyes(level_.shown());
    }
    ImageF picture() { return level_.app().world().resource<Renderer>().frame->read(render::Aov::final); }

    Playthrough level_;
    Quality quality_;
    Drawing drawing_;
    Reveal reveal_;
    Pictures* pictures_;
    const StopSignal& stop_;
};

fs::path made_folder(const std::string& name) {
    std::error_code error;
    fs::create_directories(name, error);
    if (error) {
        throw InputError(name, "", "cannot be made: " + error.message());
    }
    return name;
}

// Plays `file`; false where its tour does not solve it, or `stop` is asked.
bool play(const LevelFile& file, Played& level, Pictures* pictures, Progress& progress,
          const StopSignal& stop) {
    if (pictures != nullptr) {
        pictures->begin(file);
    }
    level.play(progress);
    if (stop.asked()) {
        return false;
    }
    const std::string words = level.solved() ? fmt::format("Solved in {:.0f} s of play.", level.seconds())
                                             : "Its tour does not solve it.";
    if (pictures != nullptr) {
        pictures->end(words);
    }
    return level.solved();
}

void say_stopped(const StopSignal& stop, const Options& options, const Pictures* pictures) {
    std::string line = fmt::format("lamplighter: {}: stopped", stop.name());
    if (pictures != nullptr) {
        line += fmt::format("; {} pictures in {}, no page", pictures->stills(), options.out);
    }
    std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace

ExitCode run_tour(const Options& options, const StopSignal& stop) {
    const auto began = std::chrono::steady_clock::now();
    const std::vector<LevelFile> levels = level_files(options);
    const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
    const bool software = context->info().software;
    const ivec2 size = picture_size(options, software);
    const char* const usual = software ? "medium" : "high";
    const Drawing drawing = {{software ? "low" : "medium", moving_size(size)},
                             {options.preset.empty() ? usual : options.preset, size}};
    std::optional<Pictures> kept;
    if (!options.out.empty()) {
        kept.emplace(made_folder(options.out), size);
    }
    Pictures* pictures = kept ? &*kept : nullptr;
    ExitCode code = ExitCode::ok;
    for (std::size_t i = 0; i < levels.size() && !stop.asked(); ++i) {
        Options one = options;
        one.level = levels[i].path.string();
        Played level(one, import_gltf(one.level), drawing, pictures, stop);
        const bool solved = [&] {  // whose line is gone before another is written
            Progress progress(fmt::format("{} of {}: {}", i + 1, levels.size(), levels[i].title),
                              level.steps());
            return play(levels[i], level, pictures, progress, stop);
        }();
        if (solved) {
            std::printf("%s: solved in %.0f s of play\n", levels[i].title.c_str(), level.seconds());
            std::fflush(stdout);
        } else if (!stop.asked()) {
            std::fprintf(stderr, "lamplighter: %s: its tour does not solve it\n", one.level.c_str());
            code = ExitCode::check_failed;
        }
    }
    if (stop.asked()) {
        say_stopped(stop, options, pictures);
        return ExitCode::ok;
    }
    if (pictures != nullptr) {
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
        pictures->write_page(fmt::format(
            "The game plays itself: {} x {}, preset {}, drawn by {} in {:.0f} s. The moving picture is four "
            "times as fast as the play.",
            size.x, size.y, drawing.stills.preset, context->info().renderer, took.count()));
        std::printf("%d pictures, tour.webp and index.html in %s\n", pictures->stills(), options.out.c_str());
    }
    return code;
}

}  // namespace lanthorn::game
