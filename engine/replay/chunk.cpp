#include "engine/replay/chunk.h"

#include <zstd.h>

#include <cassert>
#include <cctype>

#include "lanthorn/replay/content_hash.h"

namespace lanthorn::replay {

namespace {

constexpr std::uint32_t kPacked = 1, kOptional = 2;
constexpr int kLevel = 3;

struct Head {
    std::uint32_t kind, stored, unpacked, flags;
};

std::uint64_t hash_of(const Head& head) {
    return hash_bytes(std::as_bytes(std::span(&head, 1)));
}

// Empty where it would not be smaller, or would be taken for a bomb.
std::string packed(std::string_view body) {
    std::string to(ZSTD_compressBound(body.size()), '\0');
    const std::size_t size = ZSTD_compress(to.data(), to.size(), body.data(), body.size(), kLevel);
    if (ZSTD_isError(size) != 0 || size >= body.size() ||
        body.size() > size * kMostExpansion + kFreeExpansion) {
        return {};
    }
    to.resize(size);
    return to;
}

std::string unpacked(const Reader& reader, std::span<const std::byte> stored, std::uint32_t size) {
    std::string body(size, '\0');
    const std::size_t found = ZSTD_decompress(body.data(), body.size(), stored.data(), stored.size());
    if (ZSTD_isError(found) != 0 || found != size) {
        reader.fail(fmt::format("a packed chunk cannot be unpacked, expected {} bytes", size));
    }
    return body;
}

void check(const Reader& reader, const Head& head) {
    const bool is_packed = (head.flags & kPacked) != 0;
    if ((head.flags & ~(kPacked | kOptional)) != 0) {
        reader.fail(
            fmt::format("found flags {:#x} of a chunk, expected ones that this version knows", head.flags));
    }
    if (head.unpacked > kMostBody || (!is_packed && head.unpacked != head.stored) ||
        (is_packed && head.unpacked > head.stored * kMostExpansion + kFreeExpansion)) {
        reader.fail(
            fmt::format("a chunk of {} bytes claims {} unpacked, expected at most {} and {} times as many",
                        head.stored, head.unpacked, kMostBody, kMostExpansion));
    }
}

}  // namespace

std::string letters_of(ChunkKind kind) {
    std::string letters;
    for (int i = 0; i < 4; ++i) {
        const auto letter = static_cast<unsigned char>(static_cast<std::uint32_t>(kind) >> (8 * i));
        letters += std::isgraph(letter) != 0 ? static_cast<char>(letter) : '?';
    }
    return letters;
}

std::string encoded_chunk(ChunkKind kind, std::string_view body, Packing packing, bool optional) {
    assert(body.size() <= kMostBody);
    const std::string small = packing == Packing::zstd ? packed(body) : "";
    const std::string_view stored = small.empty() ? body : std::string_view(small);
    const Head head{static_cast<std::uint32_t>(kind), static_cast<std::uint32_t>(stored.size()),
                    static_cast<std::uint32_t>(body.size()),
                    (small.empty() ? 0 : kPacked) | (optional ? kOptional : 0)};
    Writer writer;
    writer.put(head);
    writer.put(hash_of(head));
    writer.put_bytes(stored);
    writer.put(hash_bytes(std::as_bytes(std::span(writer.text()))));
    return writer.text();
}

Chunk read_chunk(Reader& reader) {
    const std::size_t from = reader.at();
    const auto head = reader.get<Head>();
    if (reader.get<std::uint64_t>() != hash_of(head)) {
        reader.fail("damaged: the head of a chunk does not match its checksum");
    }
    check(reader, head);
    Chunk chunk{static_cast<ChunkKind>(head.kind), (head.flags & kOptional) != 0, reader.at(), {}};
    const auto stored = reader.take(head.stored);
    const std::uint64_t hash = hash_bytes(reader.taken_since(from));
    if (reader.get<std::uint64_t>() != hash) {
        reader.fail("damaged: a chunk does not match its checksum");
    }
    if ((head.flags & kPacked) != 0) {
        chunk.body = unpacked(reader, stored, head.unpacked);
    } else {
        chunk.body.assign(reinterpret_cast<const char*>(stored.data()), stored.size());
    }
    return chunk;
}

}  // namespace lanthorn::replay
