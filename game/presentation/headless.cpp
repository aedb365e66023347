#include "game/presentation/headless.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "game/presentation/playthrough.h"
#include "game/presentation/quality.h"
#include "game/rules/components.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"

namespace lanthorn::game {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kPictures = 30;  // of a session, unless told otherwise

// Exposure and the choice of environment maps settle over frames: between two pictures as many are rendered
// as a game at 15 frames a second would have, at most kMostFrames.
constexpr std::uint64_t kStepsAPicture = 4;
constexpr std::uint64_t kMostFrames = 8;

// Shows the session and keeps the pictures.
class Photographer {
  public:
    // `context` must be current for as long as the session's App lives.
    Photographer(const Options& options, const Quality& quality, App& app, const gpu::Context& context)
        : out_(options.out), app_(app) {
        std::error_code error;
        fs::create_directories(out_, error);
        if (error) {
            throw InputError(options.out, "", "cannot be made: " + error.message());
        }
        quality.draw(app_);
        app_.view().size = picture_size(options, context.info().software);
    }

    // Of the moment `steps` steps after the start, `since` after the picture before. None where `stop` is
    // asked meanwhile.
    void take(double steps, double since, const StopSignal& stop) {
        const auto frames =
            std::clamp<std::uint64_t>(static_cast<std::uint64_t>(since) / kStepsAPicture, 1, kMostFrames);
        for (std::uint64_t i = 0; i < frames && !stop.asked(); ++i) {
            app_.show_at(steps / kStepsPerSecond);
        }
        if (!stop.asked()) {
            write_image(out_ / fmt::format("frame-{:04}.png", ++taken_),
                        app_.world().resource<Renderer>().frame->read(render::Aov::final));
        }
    }
    int taken() const { return taken_; }

  private:
    fs::path out_;
    App& app_;
    int taken_ = 0;
};

// When picture `i` of `pictures` is taken, in steps after the start: each shows the end of its share of the
// session. The ends of shares that are longer than a step are those of steps.
double moment_of(std::uint64_t i, std::uint64_t pictures, std::uint64_t steps) {
    const std::uint64_t end = (i + 1) * steps;
    if (pictures <= steps) {
        const std::uint64_t whole = end / pictures;
        return static_cast<double>(whole);
    }
    return static_cast<double>(end) / static_cast<double>(pictures);
}

// Steps up to `until`, unless `stop` is asked.
void play(session::Session& session, std::uint64_t until, lanthorn::Progress& progress,
          const StopSignal& stop) {
    while (session.steps() < until && !stop.asked()) {
        session.app().step();
        progress.update(session.steps());
    }
}

void say_done(const Options& options, const session::Session& session) {
    const auto steps = static_cast<unsigned long long>(session.steps());
    if (!options.replay.empty()) {
        std::printf("%s: %llu steps, every state as recorded\n", options.replay.c_str(), steps);
    }
    if (!options.record.empty() && !session.recording_failed()) {
        std::printf("%llu steps in %s\n", steps, options.record.c_str());
    }
    if (solved(session.app().world())) {
        std::puts("the level is solved");
    }
}

}  // namespace

ExitCode run_headless(const Options& options, const SceneData& scene, const StopSignal& stop) {
    const std::unique_ptr<gpu::Context> context =
        options.out.empty() ? nullptr : gpu::create_headless_context();
    Playthrough playthrough(options, scene);
    session::Session& session = playthrough.session();
    const std::uint64_t steps = session.length().value_or(0);
    const Quality quality(options, session.seed());  // also without pictures: a mistake is one
    std::optional<Photographer> photographer;
    if (context) {
        photographer.emplace(options, quality, session.app(), *context);
    }
    {
        lanthorn::Progress progress("playing", steps);
        if (photographer && steps > 0) {
            const std::uint64_t pictures =
                options.frames > 0 ? static_cast<std::uint64_t>(options.frames) : std::min(kPictures, steps);
            double before = 0;
            for (std::uint64_t i = 0; i < pictures && !stop.asked(); ++i) {
                const double moment = moment_of(i, pictures, steps);
                play(session, static_cast<std::uint64_t>(moment), progress, stop);
                photographer->take(moment, moment - std::exchange(before, moment), stop);
            }
        } else {
            play(session, steps, progress, stop);
        }
    }
    session.finish();

    if (const std::string divergence = session.divergence(); !divergence.empty()) {
        std::fprintf(stderr, "lamplighter: %s: %s\n", options.replay.c_str(), divergence.c_str());
        return ExitCode::check_failed;
    }
    if (photographer) {
        std::printf("%d pictures in %s\n", photographer->taken(), options.out.c_str());
    }
    if (stop.asked()) {
        playthrough.say_stopped(stop);
    } else {
        say_done(options, session);
    }
    return session.recording_failed() ? ExitCode::bad_input : ExitCode::ok;
}

}  // namespace lanthorn::game
