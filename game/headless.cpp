#include "game/headless.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "game/presentation.h"
#include "game/quality.h"
#include "game/session.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/gpu/context.h"

namespace lanthorn::game {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kPictures = 30;  // of a session, unless told otherwise

// Exposure and the choice of environment maps settle over frames: between two pictures as many are rendered
// as a game at 15 frames a second would have, at most kMostFrames.
constexpr std::uint64_t kStepsAFrame = 4;
constexpr std::uint64_t kMostFrames = 8;

// Renders the session's views and keeps the pictures.
class Photographer {
  public:
    Photographer(const Options& options, const SceneData& scene, const Level& level)
        : out_(options.out),
          quality_(options),
          context_(gpu::create_headless_context()),
          size_(picture_size(options, context_->info().software)),
          presentation_(scene, level, context_->info()) {
        std::error_code error;
        fs::create_directories(out_, error);
        if (error) {
            throw InputError(options.out, "", "cannot be made: " + error.message());
        }
    }

    // `steps`: since the picture before.
    void take(const View& view, std::uint64_t steps) {
        const auto frames = std::clamp<std::uint64_t>(steps / kStepsAFrame, 1, kMostFrames);
        for (std::uint64_t i = 0; i < frames; ++i) {
            presentation_.draw(view, size_, quality_.settings());
        }
        write_image(out_ / fmt::format("frame-{:04}.png", ++taken_), presentation_.picture());
    }
    int taken() const { return taken_; }

  private:
    fs::path out_;
    Quality quality_;
    std::unique_ptr<gpu::Context> context_;
    ivec2 size_;
    Presentation presentation_;
    int taken_ = 0;
};

}  // namespace

ExitCode run_headless(const Options& options, const SceneData& scene, const Level& level) {
    Session session(options, level);
    const std::uint64_t steps = session.length().value_or(0);
    std::unique_ptr<Photographer> photographer;
    if (!options.out.empty()) {
        photographer = std::make_unique<Photographer>(options, scene, level);
    }
    const std::uint64_t wanted = options.frames > 0 ? static_cast<std::uint64_t>(options.frames) : kPictures;
    const std::uint64_t pictures = std::clamp<std::uint64_t>(wanted, 1, std::max<std::uint64_t>(steps, 1));
    {
        Progress progress("playing", steps);
        for (std::uint64_t picture = 0; !session.done(); progress.update(session.steps())) {
            session.step();
            // Picture i shows the end of the i-th of equal shares of the session.
            if (photographer && session.steps() == (picture + 1) * steps / pictures) {
                photographer->take(session.view(), steps / pictures);
                ++picture;
            }
        }
    }
    session.finish();

    if (const auto& divergence = session.divergence()) {
        std::fprintf(stderr, "lamplighter: %s: %s\n", options.replay.c_str(), divergence->describe().c_str());
        return ExitCode::check_failed;
    }
    if (session.driver() == Driver::recording) {
        std::printf("%s: %llu steps, every state as recorded\n", options.replay.c_str(),
                    static_cast<unsigned long long>(steps));
    }
    if (photographer) {
        std::printf("%d pictures in %s\n", photographer->taken(), options.out.c_str());
    }
    if (session.recording_failed()) {
        return ExitCode::bad_input;
    }
    if (!options.record.empty()) {
        std::printf("%llu steps in %s\n", static_cast<unsigned long long>(steps), options.record.c_str());
    }
    return ExitCode::ok;
}

}  // namespace lanthorn::game
