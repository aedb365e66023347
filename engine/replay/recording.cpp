#include "lanthorn/replay/recording.h"

#include <fstream>
#include <iterator>
#include <span>

#include "engine/replay/recording_format.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/content_hash.h"

namespace lanthorn::replay {

std::uint64_t root_of(std::span<const std::uint64_t> hashes) {
    return hash_bytes(std::as_bytes(hashes));
}

void mark_state(std::span<const std::uint64_t> hashes, std::vector<std::uint64_t>& before,
                RecordedStep& step) {
    step.root = root_of(hashes);
    step.changed.clear();
    for (std::size_t i = 0; i < hashes.size(); ++i) {
        if (before.empty() || before[i] != hashes[i]) {
            step.changed.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(hashes[i])});
        }
    }
    before.assign(hashes.begin(), hashes.end());
}

void write_recording(const std::string& path, const Recording& recording) {
    write_file(path, encoded_recording(recording));
}

Recording read_recording(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        throw InputError(path, "", "cannot be opened");
    }
    const std::vector<char> file{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (in.bad()) {
        throw InputError(path, "", "cannot be read to its end");
    }
    return decoded_recording(path, std::as_bytes(std::span(file)));
}

}  // namespace lanthorn::replay
