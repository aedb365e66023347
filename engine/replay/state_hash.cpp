#include "lanthorn/replay/state_hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <fstream>
#include <iterator>

#include "lanthorn/core/error.h"

namespace lanthorn::replay {

std::uint64_t hash_bytes(std::span<const std::byte> bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

std::uint64_t hash_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        throw InputError(path, "", "cannot be opened");
    }
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    return hash_bytes(std::as_bytes(std::span(bytes)));
}

void WorldHasher::part(std::string name, std::function<void(StateHash&, const ecs::World&)> add) {
    names_.push_back(std::move(name));
    parts_.push_back(std::move(add));
}

std::vector<std::uint64_t> WorldHasher::hash(const ecs::World& world) const {
    std::vector<std::uint64_t> hashes;
    hashes.reserve(parts_.size());
    for (const auto& add : parts_) {
        StateHash hash;
        add(hash, world);
        hashes.push_back(hash.value());
    }
    return hashes;
}

}  // namespace lanthorn::replay
