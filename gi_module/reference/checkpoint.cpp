#include "gi_module/reference/checkpoint.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <memory>
#include <vector>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"

namespace lanthorn::reference {

namespace {

constexpr std::array<char, 8> kMagic{'L', 'N', 'T', 'P', 'A', 'T', 'H', '3'};
static_assert(sizeof(CheckpointHeader) == 48, "no padding");
static_assert(sizeof(Film::Pixel) == 112, "no padding");

// xxHash, 64 bits, of all that follows the magic.
class Checksum {
  public:
    void add(const void* data, std::size_t size) { XXH3_64bits_update(state_.get(), data, size); }
    std::uint64_t value() const { return XXH3_64bits_digest(state_.get()); }

  private:
    struct Free {
        void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
    };
    static XXH3_state_t* begun() {
        XXH3_state_t* state = XXH3_createState();
        XXH3_64bits_reset(state);
        return state;
    }
    std::unique_ptr<XXH3_state_t, Free> state_{begun()};
};

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const CheckpointHeader& header,
                      std::span<const Film> films) {
    AtomicFile file(path);
    file.write({kMagic.data(), kMagic.size()});
    Checksum sum;
    const auto write = [&](const void* data, std::size_t size) {
        sum.add(data, size);
        file.write({static_cast<const char*>(data), size});
    };
    write(&header, sizeof header);
    for (const Film& film : films) {
        if (!film.empty()) {
            write(&film.pixels()[header.begin()], header.pixels() * sizeof(Film::Pixel));
        }
    }
    const std::uint64_t value = sum.value();
    file.write({reinterpret_cast<const char*>(&value), sizeof value});
    file.commit();
}

CheckpointHeader read_checkpoint(const std::filesystem::path& path, const CheckpointHeader& expected,
                                 std::span<Film> films) {
    const std::string name = path.string();
    std::ifstream stream(path, std::ios::binary);
    std::array<char, 8> magic{};
    CheckpointHeader header;
    stream.read(magic.data(), magic.size());
    stream.read(reinterpret_cast<char*>(&header), sizeof header);
    if (!stream || magic != kMagic) {
        throw InputError(name, "", "found something else, expected a checkpoint of `path`");
    }
    if (header.sample_hash != expected.sample_hash || header.width != expected.width ||
        header.height != expected.height || header.films != expected.films ||
        header.first != expected.first || header.top != expected.top || header.rows != expected.rows) {
        throw InputError(name, "",
                         "found another scene, camera, size, AOV or setting, expected the ones given "
                         "(remove the file to start anew)");
    }
    Checksum sum;
    sum.add(&header, sizeof header);
    std::vector<std::vector<Film::Pixel>> read;
    for (const Film& film : films) {
        read.emplace_back(film.empty() ? 0 : header.pixels());
        stream.read(reinterpret_cast<char*>(read.back().data()),
                    static_cast<std::streamsize>(read.back().size() * sizeof(Film::Pixel)));
        sum.add(read.back().data(), read.back().size() * sizeof(Film::Pixel));
    }
    std::uint64_t stated = 0;
    stream.read(reinterpret_cast<char*>(&stated), sizeof stated);
    if (!stream || stated != sum.value() || stream.peek() != std::ifstream::traits_type::eof()) {
        throw InputError(name, "",
                         "found a damaged checkpoint, expected one as it was written (remove the file)");
    }
    for (std::size_t i = 0; i < films.size(); ++i) {
        std::ranges::copy(read[i], films[i].pixels().begin() + static_cast<std::ptrdiff_t>(header.begin()));
    }
    return header;
}

}  // namespace lanthorn::reference
