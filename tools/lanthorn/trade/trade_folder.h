// The files of one run of `lanthorn trade`, and what tells one measurement from another.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "tools/lanthorn/trade/trade_options.h"

namespace lanthorn::tools {

// Of the machine, as the system calls it.
std::string processor();

class TradeFolder {
  public:
    // Makes the folders, loads each scene and looks for its motions once, so that what cannot be read,
    // written or moved shows before hours of work: throws InputError. `options` must outlive it.
    explicit TradeFolder(const TradeOptions& options);

    std::filesystem::path file(const std::string& name) const { return folder_ / name; }

    // Whether the scene has that motion of the sweep; some scene has each.
    bool has(const std::string& scene, TradeMotion motion) const { return views_.contains({scene, motion}); }
    // What its last frame shows.
    const SceneView& shown_last(const std::string& scene, TradeMotion motion) const {
        return views_.at({scene, motion});
    }

    // Where a point's figures are kept: another build's are not this one's.
    std::filesystem::path stem(const TradePoint& point, const SettingsSchema& schema) const;

    // Without ending and AOV. `bounces` 0: all there are.
    std::filesystem::path reference(const std::string& scene, TradeMotion motion, int bounces) const;
    // The three images that a point is compared with.
    TradeReferences references(const TradePoint& point, const SettingsSchema& schema) const;

  private:
    void find_motions();

    const TradeOptions& options_;
    std::filesystem::path folder_;
    std::map<std::string, std::uint64_t> hashes_;
    std::map<std::pair<std::string, TradeMotion>, SceneView> views_;
};

}  // namespace lanthorn::tools
