// The level behind the game's screens: one of the campaign's at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/level/level_files.h"
#include "game/presentation/options.h"
#include "game/presentation/playthrough.h"
#include "game/presentation/quality.h"
#include "lanthorn/shell/kept_session.h"

namespace lanthorn::game {

class LevelInWindow {
  public:
    explicit LevelInWindow(const Options& options);

    const std::vector<LevelFile>& files() const { return files_; }
    const LevelFile& file(int level) const { return files_[static_cast<std::size_t>(level)]; }

    // From its beginning, in the place of the one before; what its file lacks is said on stderr. The OpenGL
    // context must be current. Throws InputError; then drop() it.
    Playthrough& load(int level, const shell::Spending& spending);
    void drop() { played_.reset(); }
    // It was entered in the middle, so that what is kept of the session cannot be played.
    void keep_no_session();
    // Null: it could not be loaded.
    Playthrough* played() { return played_.get(); }
    const Playthrough* played() const { return played_.get(); }
    std::uint64_t hash() const { return hash_; }  // of its file, as it was loaded

    void draw_as(const shell::Spending& spending);
    // What the picture is drawn with; null before a level was loaded.
    const Settings* settings() const { return quality_ ? &quality_->settings() : nullptr; }
    const std::string& preset() const { return spending_.preset; }  // that it is drawn with

  private:
    const Options& options_;
    std::vector<LevelFile> files_;
    shell::KeptSession kept_;  // its files outlive the session that writes them
    std::unique_ptr<Playthrough> played_;
    std::optional<Quality> quality_;
    std::uint64_t hash_ = 0;
    shell::Spending spending_;
};

}  // namespace lanthorn::game
