#include "game/presentation/first_light.h"

#include <utility>
#include <vector>

#include "game/presentation/prepared_programs.h"

namespace lanthorn::game {

FirstLight::FirstLight(const Options& options, gpu::GlInfo gl)
    : options_(options),
      gl_(std::move(gl)),
      state_(gl_.software && !options.straight && !options.tour ? State::unknown : State::over) {}

bool FirstLight::holds(const LevelFile& level, const std::string& preset, bool behind_title) {
    if (state_ == State::unknown) {
        const PreparedPrograms prepared(gl_, PreparedPrograms::usual_path());
        level_ = level.path.string();
        preset_ = preset;
        state_ = prepared.has(level.name(), preset, options_) ? State::over : State::awaits_picture;
    }
    if (!behind_title || level.path != level_ || preset != preset_) {
        preparation_.stop();
        state_ = State::over;
    }
    return state_ != State::over;
}

void FirstLight::pass() {
    if (state_ == State::awaits_picture) {
        std::vector<std::string> arguments = {"--prepare", "--level", level_, "--preset", preset_};
        for (const std::string& assignment : options_.set) {
            arguments.insert(arguments.end(), {"--set", assignment});
        }
        preparation_.start(std::move(arguments));
        state_ = State::prepares;
    } else if (state_ == State::prepares && !preparation_.running()) {
        state_ = State::over;
    }
}

}  // namespace lanthorn::game
