// Which levels' programs are known to lie in the OpenGL driver's cache, from one run to the next.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "game/presentation/options.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/shell/kept_file.h"

namespace lanthorn::game {

class PreparedPrograms {
  public:
    // Of this build on this driver: what others have prepared counts for nothing. An empty `path` keeps
    // nothing.
    PreparedPrograms(const gpu::GlInfo& gl, const std::filesystem::path& path);

    // Whether pictures of the level (a file's name) have been drawn so: `preset`, and what `--set` says.
    bool has(std::string_view level, std::string_view preset, const Options& options) const;
    // That they have. Nothing is said where it cannot be written: they are prepared once more next time.
    void add(std::string_view level, std::string_view preset, const Options& options);

    // Where a user's is.
    static std::filesystem::path usual_path() { return shell::cache_file(kProgram, "programs"); }

  private:
    std::filesystem::path path_;
    std::string driver_;           // the first line
    std::set<std::string> lines_;  // the others: preset, settings, level
};

}  // namespace lanthorn::game
