#include "game/headless.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "game/quality.h"
#include "game/session.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"

namespace lanthorn::game {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kPictures = 30;  // of a session, unless told otherwise

// Exposure and the choice of environment maps settle over frames: between two pictures as many are rendered
// as a game at 15 frames a second would have, at most kMostFrames.
constexpr std::uint64_t kStepsAFrame = 4;
constexpr std::uint64_t kMostFrames = 8;

// Shows the session and keeps the pictures.
class Photographer {
  public:
    // `context` must be current for as long as the session's App lives.
    Photographer(const Options& options, Session& session, const gpu::Context& context)
        : out_(options.out), app_(session.app()) {
        std::error_code error;
        fs::create_directories(out_, error);
        if (error) {
            throw InputError(options.out, "", "cannot be made: " + error.message());
        }
        gi::add_picture_plugins(app_, Quality(options, session.seed()).settings());
        app_.view().size = picture_size(options, context.info().software);
    }

    // `steps`: since the picture before.
    void take(std::uint64_t steps) {
        const auto frames = std::clamp<std::uint64_t>(steps / kStepsAFrame, 1, kMostFrames);
        for (std::uint64_t i = 0; i < frames; ++i) {
            app_.show();
        }
        write_image(out_ / fmt::format("frame-{:04}.png", ++taken_),
                    app_.world().resource<Renderer>().frame->read(render::Aov::final));
    }
    int taken() const { return taken_; }

  private:
    fs::path out_;
    App& app_;
    int taken_ = 0;
};

}  // namespace

ExitCode run_headless(const Options& options, const SceneData& scene) {
    const std::unique_ptr<gpu::Context> context =
        options.out.empty() ? nullptr : gpu::create_headless_context();
    Session session(options, scene);
    const std::uint64_t steps = session.length().value_or(0);
    std::optional<Photographer> photographer;
    if (context) {
        photographer.emplace(options, session, *context);
    }
    const std::uint64_t wanted = options.frames > 0 ? static_cast<std::uint64_t>(options.frames) : kPictures;
    const std::uint64_t pictures = std::clamp<std::uint64_t>(wanted, 1, std::max<std::uint64_t>(steps, 1));
    {
        Progress progress("playing", steps);
        for (std::uint64_t picture = 0; !session.done(); progress.update(session.steps())) {
            session.app().step();
            // Picture i shows the end of the i-th of equal shares of the session.
            if (photographer && session.steps() == (picture + 1) * steps / pictures) {
                photographer->take(steps / pictures);
                ++picture;
            }
        }
    }
    session.finish();

    if (const std::string divergence = session.divergence(); !divergence.empty()) {
        std::fprintf(stderr, "lamplighter: %s: %s\n", options.replay.c_str(), divergence.c_str());
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
