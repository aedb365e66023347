#include "tools/lanthorn/render/turntable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "game/presentation/album/animated_picture.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/progress.h"

namespace lanthorn::tools {

namespace {

constexpr float kQuality = 90;
constexpr double kTurnMs = 4000;  // of one turn
constexpr int kShortestMs = 20;   // of a picture: browsers show shorter ones longer

}  // namespace

void check_turntable(const std::string& file, const TurntableJob& job) {
    std::string ending = std::filesystem::path(file).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (ending != ".webp") {
        throw InputError(file, "", fmt::format("found the ending '{}', expected .webp", ending));
    }
    if (job.pictures < kFewestTurntablePictures || job.pictures > kMostTurntablePictures) {
        throw InputError(fmt::format("--frames: found {}, expected from {} to {} pictures of a turntable",
                                     job.pictures, kFewestTurntablePictures, kMostTurntablePictures));
    }
    constexpr int kLargest = game::AnimatedPicture::kLargestSide;
    if (std::max(job.size.x, job.size.y) > kLargest) {
        throw InputError(fmt::format("--size: found {}x{}, expected at most {} pixels a side of a turntable",
                                     job.size.x, job.size.y, kLargest));
    }
    check_writable(file);
}

void write_turntable(const std::string& file, SceneData scene, const Settings& settings,
                     const TurntableJob& job) {
    game::AnimatedPicture moving(job.size, kQuality, game::AnimatedPicture::Coding::whole);
    const int ms = std::max(kShortestMs, static_cast<int>(std::lround(kTurnMs / job.pictures)));
    Progress progress("turning", static_cast<std::uint64_t>(job.pictures));
    render_turntable(std::move(scene), settings, job, [&](const ImageF& picture) {
        moving.add(picture, ms);
        progress.update(static_cast<std::uint64_t>(moving.frames()));
    });
    moving.write(file);
}

}  // namespace lanthorn::tools
