#include "game/presentation/progress.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/content_hash.h"

namespace lanthorn::game {

namespace {

using nlohmann::json;

constexpr std::array<char, 8> kMark = {'L', 'A', 'M', 'P', 'S', 'A', 'V', 'E'};

// Little-endian, as every processor that this runs on has it.
struct Head {
    std::array<char, 8> mark = kMark;
    std::uint32_t version = kProgressVersion;
    std::uint32_t words = 0;  // bytes of JSON; the world's state follows
    std::uint64_t bytes = 0;  // of JSON and state
    std::uint64_t hash = 0;   // of these, XXH3
};
static_assert(sizeof(Head) == 32);

std::uint64_t hash_of(std::string_view bytes) {
    return replay::hash_bytes(std::as_bytes(std::span(bytes)));
}

Progress from_words(std::string_view text) {
    const json words = parse_json(text, "progress");
    Progress progress;
    progress.solved = words.value("solved", progress.solved);
    progress.level = words.value("level", progress.level);
    progress.level_hash = words.value("level_hash", progress.level_hash);
    return progress;
}

}  // namespace

std::string to_bytes(const Progress& progress) {
    const json words = {
        {"solved", progress.solved}, {"level", progress.level}, {"level_hash", progress.level_hash}};
    const std::string text = words.dump();
    const std::string rest = text + progress.state;
    Head head;
    head.words = static_cast<std::uint32_t>(text.size());
    head.bytes = rest.size();
    head.hash = hash_of(rest);
    std::string bytes(sizeof head, '\0');
    std::memcpy(bytes.data(), &head, sizeof head);
    return bytes + rest;
}

Progress progress_from_bytes(std::string_view bytes, std::string_view source) {
    Head head;
    if (bytes.size() < sizeof head || std::memcmp(bytes.data(), kMark.data(), kMark.size()) != 0) {
        throw InputError(source, "", "found no progress of lamplighter");
    }
    std::memcpy(&head, bytes.data(), sizeof head);
    if (head.version != kProgressVersion) {
        throw InputError(
            source, "version",
            "found " + std::to_string(head.version) + ", expected " + std::to_string(kProgressVersion));
    }
    const std::string_view rest = bytes.substr(sizeof head);
    if (head.bytes != rest.size() || head.words > rest.size() || hash_of(rest) != head.hash) {
        throw InputError(source, "", "found damaged progress");
    }
    try {
        Progress progress = from_words(rest.substr(0, head.words));
        progress.state = rest.substr(head.words);
        return progress;
    } catch (const std::exception&) {
        throw InputError(source, "", "found progress that cannot be read");
    }
}

std::string left_out_line(std::string_view source, const std::vector<std::string>& left_out) {
    constexpr std::size_t kMost = 6;
    std::string line = std::string(source) + ": kept by another build; left out: ";
    for (std::size_t i = 0; i < std::min(left_out.size(), kMost); ++i) {
        line += (i == 0 ? "" : ", ") + left_out[i];
    }
    return left_out.size() > kMost ? line + " and " + std::to_string(left_out.size() - kMost) + " more"
                                   : line;
}

Progress read_progress(shell::KeptFile& file) {
    return file.read_as(progress_from_bytes);
}

}  // namespace lanthorn::game
