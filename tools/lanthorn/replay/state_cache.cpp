#include "tools/lanthorn/replay/state_cache.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

#include "engine/replay/annotations.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/time_step.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;

std::string cache_folder() {
    const auto named = [](const char* variable) {
        const char* value = std::getenv(variable);
        return std::string(value != nullptr ? value : "");
    };
    if (const std::string cache = named("XDG_CACHE_HOME"); !cache.empty()) {
        return cache;
    }
    const std::string home = named("HOME");
    return home.empty() ? "" : home + "/.cache";
}

std::string name_of(std::uint64_t step) {
    return fmt::format("{:010}.state", step);
}

// A state as a chunk of a recording has it: packed, with its checksums.
std::optional<std::string> read_state(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const std::string name = file.string();
    try {
        replay::Reader reader(name, std::as_bytes(std::span(bytes)));
        return replay::read_chunk(reader).body;
    } catch (const replay::EndsHere&) {
    } catch (const InputError&) {
    }
    return std::nullopt;
}

}  // namespace

StateCache::StateCache(const std::string& key) {
    if (const std::string cache = cache_folder(); !cache.empty()) {
        folder_ = (fs::path(cache) / "lanthorn" / "replay" / key).string();
    }
}

std::optional<StateCache::Found> StateCache::before(std::uint64_t step) const {
    for (std::uint64_t key = step / kKeySteps * kKeySteps; !folder_.empty() && key > 0; key -= kKeySteps) {
        const fs::path file = fs::path(folder_) / name_of(key);
        std::error_code ignored;
        if (fs::exists(file, ignored)) {
            if (std::optional<std::string> state = read_state(file)) {
                return Found{key, std::move(*state)};
            }
        }
    }
    return std::nullopt;
}

void StateCache::keep(std::uint64_t step, const std::string& bytes) const {
    if (folder_.empty() || bytes.size() > replay::kMostBody) {
        return;
    }
    std::error_code ignored;  // writing tells
    fs::create_directories(folder_, ignored);
    try {
        write_file(fs::path(folder_) / name_of(step),
                   replay::encoded_chunk(replay::kStateChunk, bytes, replay::Packing::zstd, true));
    } catch (const InputError&) {
    }
}

}  // namespace lanthorn::tools
