#include "lanthorn/workbench/reference_pairs.h"

#include <fmt/format.h>

#include <optional>
#include <system_error>
#include <utility>

#include "gi_module/reference/scene_hash.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/reference/path_tracer.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::workbench {

namespace {

constexpr std::uint32_t kSeed = 7001;  // of no technique's photons or paths
constexpr std::uint32_t kOther = 0x5bd1e995u;

ImageF traced(const FrameScene& frame, ivec2 size, const reference::PathSettings& settings) {
    reference::PathTracer tracer(frame, size, settings, {.indirect = true});
    tracer.render({.progress = [](const reference::PathProgress&) { return !StopSignal::asked(); }});
    stop_if_asked("measure", "a part of a reference tells nothing");
    return {size.x, size.y, 3, tracer.image(reference::PathAov::indirect), {}};
}

// A file that another run left; nothing if there is none, or one that is damaged or of another size.
std::optional<ImageF> kept(const std::filesystem::path& file, ivec2 size) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        return std::nullopt;
    }
    try {
        ImageF image = read_image(file);
        if (image.width == size.x && image.height == size.y && image.channels == 3) {
            return image;
        }
    } catch (const InputError&) {
    }
    return std::nullopt;
}

}  // namespace

ReferencePair trace_pair(const FrameScene& frame, ivec2 size, reference::PathSettings settings, int spp) {
    settings.spp = (spp + 1) / 2;
    settings.time_limit = 0;
    settings.target_noise = 0;
    ReferencePair pair;
    pair.a = traced(frame, size, settings);
    settings.seed += kOther;
    pair.b = traced(frame, size, settings);
    return pair;
}

Settings comparable(Settings settings) {
    settings.set("gi.caustics.photons", 0);
    return settings;
}

ReferencePairs::ReferencePairs(std::filesystem::path folder, int spp)
    : folder_(std::move(folder)), spp_(spp) {
    if (!folder_.empty()) {
        std::error_code error;
        std::filesystem::create_directories(folder_, error);
        if (error) {
            throw InputError(folder_.string(), "", "cannot be made: " + error.message());
        }
        check_writable(folder_ / "probe");
    }
}

const ReferencePair& ReferencePairs::of(const FrameScene& frame, ivec2 size, int bounces,
                                        const std::string& name) {
    reference::PathSettings settings;
    settings.bounces = bounces;
    settings.seed = kSeed;
    const std::string key =
        fmt::format("{}-{:016x}-{}", name, reference::sample_hash(frame, size, settings), spp_);
    const auto known = pairs_.find(key);
    if (known != pairs_.end()) {
        return known->second;
    }
    const auto file = [&](const char* half) { return folder_ / (key + half + ".exr"); };
    if (!folder_.empty()) {
        std::optional<ImageF> a = kept(file("-a"), size), b = kept(file("-b"), size);
        if (a && b) {
            return pairs_[key] = {std::move(*a), std::move(*b)};
        }
    }
    ReferencePair pair = trace_pair(frame, size, settings, spp_);
    ++traced_;
    if (!folder_.empty()) {
        write_image(file("-a"), pair.a);
        write_image(file("-b"), pair.b);
    }
    return pairs_[key] = std::move(pair);
}

}  // namespace lanthorn::workbench
