#include "tests/fuzz/sealed.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>

#include "lanthorn/replay/content_hash.h"

namespace lanthorn::fuzz {

namespace {

constexpr std::size_t kRecordingMark = 12;  // LANTHREC and the version
constexpr std::size_t kChunkHead = 24;      // kind, stored, unpacked, flags, hash of these
constexpr std::size_t kHashed = 16;         // of it
constexpr std::size_t kHash = 8;
constexpr std::size_t kCheckpointMark = 8;

std::uint64_t hash_of(std::string_view bytes) {
    return replay::hash_bytes(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
    std::memcpy(&bytes[at], &value, sizeof value);
}

}  // namespace

std::string sealed_recording(std::string_view input) {
    std::string bytes(input);
    std::size_t at = kRecordingMark;
    while (bytes.size() >= at + kChunkHead + kHash) {
        std::uint32_t length = 0;
        std::memcpy(&length, &bytes[at + 4], sizeof length);
        const std::size_t room = bytes.size() - at - kChunkHead - kHash;
        length = static_cast<std::uint32_t>(std::min<std::size_t>(length, room));
        put(bytes, at + 4, length);
        // What is not packed is as long as it is stored, else nothing would ever be read.
        if ((bytes[at + 12] & 1) == 0) {
            put(bytes, at + 8, length);
        }
        put(bytes, at + kHashed, hash_of(std::string_view(bytes).substr(at, kHashed)));
        const std::size_t end = at + kChunkHead + length;
        put(bytes, end, hash_of(std::string_view(bytes).substr(at, end - at)));
        at = end + kHash;
    }
    return bytes;
}

std::string sealed_checkpoint(std::string_view input) {
    std::string bytes(input);
    if (bytes.size() >= kCheckpointMark + kHash) {
        const std::size_t end = bytes.size() - kHash;
        put(bytes, end, hash_of(std::string_view(bytes).substr(kCheckpointMark, end - kCheckpointMark)));
    }
    return bytes;
}

}  // namespace lanthorn::fuzz
