#include "tools/lanthorn/render/path_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <thread>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/content_hash.h"
#include "tools/lanthorn/farm/farm_options.h"
#include "tools/replay_suite/files.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;
using reference::PathPiece;

constexpr int kPieces = 16;
// A start with its scene, and a sample of a pixel: rather too much.
constexpr double kStartSeconds = 1, kSampleSeconds = 4e-6;

std::string piece_text(const PathPiece& piece) {
    return fmt::format("{}:{}:{}:{}", piece.first, piece.samples, piece.top, piece.rows);
}

std::uint64_t hash_of(const std::string& text) {
    return replay::hash_bytes(std::as_bytes(std::span(text)));
}

// So many blocks of samples there are; bands of rows make up the rest.
int bands_for(int pieces, int spp, ivec2 size) {
    const int blocks = static_cast<int>(reference::path_pieces(size, spp, 1).size());
    return (pieces + blocks - 1) / std::max(blocks, 1);
}

// Processes of one machine share its threads; one that has a node for itself takes all.
std::string threads_of(const PieceChoice& choice) {
    const int threads = static_cast<int>(std::thread::hardware_concurrency());
    return fmt::format("path.threads={}",
                       choice.farm.executor == "slurm" ? 0 : std::max(1, threads / choice.farm.jobs));
}

}  // namespace

PathPiece parse_piece(const std::string& text, ivec2 size, int spp) {
    int numbers[4] = {};
    const char *at = text.data(), *const end = text.data() + text.size();
    bool good = true;
    for (int i = 0; i < 4 && good; ++i) {
        const auto [next, error] = std::from_chars(at, end, numbers[i]);
        good = error == std::errc() && (i == 3 ? next == end : next != end && *next == ':');
        at = next + (i < 3 ? 1 : 0);
    }
    const PathPiece piece{numbers[0], numbers[1], numbers[2], numbers[3]};
    const auto within = [](int first, int count, int all) {
        return first >= 0 && count > 0 && first < all && count <= all - first;
    };
    if (!good || !within(piece.first, piece.samples, spp) || !within(piece.top, piece.rows, size.y)) {
        throw InputError(
            fmt::format("--piece: found '{}', expected FIRST:SAMPLES:TOP:ROWS within {} samples and {} rows",
                        text, spp, size.y));
    }
    return piece;
}

void trace_in_pieces(reference::PathTracer& tracer, ivec2 size, int spp, const PieceCommand& command,
                     const PieceChoice& choice, const std::string& folder) {
    suite::make_folder(folder);
    const fs::path settings = fs::absolute(fs::path(folder) / "settings.json");
    write_file(settings, command.settings);
    // Of another program or another picture pieces are others.
    std::string key = command.settings + fmt::format("{:016x}", replay::hash_file(program_path()));
    for (const auto& [name, value] : tracer.description(reference::PathAov::depth)) {
        key += fmt::format("{}={}\n", name, value);
    }
    for (const std::string& argument : command.arguments) {
        key += argument + "\n";
    }
    const std::vector<PathPiece> pieces =
        reference::path_pieces(size, spp, bands_for(choice.pieces.value_or(kPieces), spp, size));
    std::vector<suite::FarmTask> tasks;
    std::vector<fs::path> files;
    for (const PathPiece& piece : pieces) {
        const std::string text = piece_text(piece);
        const fs::path file =
            fs::absolute(fs::path(folder) / fmt::format("{:016x}.sums", hash_of(key + text)));
        std::error_code ignored;
        if (!tracer.has_piece(piece, file)) {
            fs::remove(file, ignored);  // damaged
        }
        std::vector<std::string> arguments = {"render"};
        arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
        arguments.insert(arguments.end(), {"--settings", settings.string(), "--set", threads_of(choice),
                                           "--piece", text, "-o", file.string()});
        const double samples = static_cast<double>(size.x) * piece.rows * piece.samples;
        tasks.push_back({std::move(arguments), file.string(), kStartSeconds + kSampleSeconds * samples});
        files.push_back(file);
    }
    do_tasks(tasks, choice.farm, folder, "tracing pieces");
    tracer.add_up(pieces, files);
    std::error_code ignored;
    fs::remove_all(folder, ignored);
}

}  // namespace lanthorn::tools
