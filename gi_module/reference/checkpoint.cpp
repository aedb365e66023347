#include "lanthorn/reference/checkpoint.h"

#include <array>
#include <cstring>
#include <fstream>
#include <vector>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"

namespace lanthorn::reference {

namespace {

constexpr std::array<char, 8> kMagic{'L', 'N', 'T', 'P', 'A', 'T', 'H', '1'};
static_assert(sizeof(CheckpointHeader) == 32, "no padding");
static_assert(sizeof(Film::Pixel) == 64, "no padding");

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const CheckpointHeader& header,
                      std::span<const Film> films) {
    AtomicFile file(path);
    file.write({kMagic.data(), kMagic.size()});
    file.write({reinterpret_cast<const char*>(&header), sizeof header});
    for (const Film& film : films) {
        file.write({reinterpret_cast<const char*>(film.pixels().data()),
                    film.pixels().size() * sizeof(Film::Pixel)});
    }
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
        header.height != expected.height || header.films != expected.films) {
        throw InputError(name, "",
                         "found another scene, camera, size, AOV or setting, expected the ones given "
                         "(remove the file to start anew)");
    }
    std::vector<std::vector<Film::Pixel>> read;
    for (const Film& film : films) {
        read.emplace_back(film.pixels().size());
        stream.read(reinterpret_cast<char*>(read.back().data()),
                    static_cast<std::streamsize>(read.back().size() * sizeof(Film::Pixel)));
    }
    if (!stream || stream.peek() != std::ifstream::traits_type::eof()) {
        throw InputError(name, "",
                         "found a damaged checkpoint, expected one as it was written (remove the file)");
    }
    for (std::size_t i = 0; i < films.size(); ++i) {
        films[i].pixels() = std::move(read[i]);
    }
    return header;
}

}  // namespace lanthorn::reference
