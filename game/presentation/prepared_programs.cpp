#include "game/presentation/prepared_programs.h"

#include <fstream>
#include <system_error>

#include "engine/build_info/build_info.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"

namespace lanthorn::game {

namespace {

std::string line_of(std::string_view level, std::string_view preset, const Options& options) {
    std::string line(preset);
    for (const std::string& assignment : options.set) {
        line += ' ' + assignment;
    }
    return line.append(" ").append(level);
}

}  // namespace

PreparedPrograms::PreparedPrograms(const gpu::GlInfo& gl, const std::filesystem::path& path)
    : path_(path), driver_(build_words() + ", " + gl.renderer + ", " + gl.version) {
    std::ifstream kept(path_);
    std::string line;
    if (std::getline(kept, line) && line == driver_) {
        while (std::getline(kept, line)) {
            lines_.insert(line);
        }
    }
}

bool PreparedPrograms::has(std::string_view level, std::string_view preset, const Options& options) const {
    return lines_.contains(line_of(level, preset, options));
}

void PreparedPrograms::add(std::string_view level, std::string_view preset, const Options& options) {
    lines_.insert(line_of(level, preset, options));
    if (path_.empty()) {
        return;
    }
    std::string bytes = driver_ + '\n';
    for (const std::string& line : lines_) {
        bytes += line + '\n';
    }
    std::error_code ignored;
    std::filesystem::create_directories(path_.parent_path(), ignored);
    try {
        write_file(path_, bytes);
    } catch (const InputError&) {
        // Nobody has asked for this file.
    }
}

}  // namespace lanthorn::game
