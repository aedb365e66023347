// The files of one run of `lanthorn trade`, and what tells one measurement from another.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "tools/lanthorn/trade/trade_options.h"

namespace lanthorn::tools {

// Of the machine, as the system calls it.
std::string processor();

class TradeFolder {
  public:
    // Makes the folders and loads each scene once, so that what cannot be read or written shows before hours
    // of work: throws InputError. `options` must outlive it.
    explicit TradeFolder(const TradeOptions& options);

    std::filesystem::path file(const std::string& name) const { return folder_ / name; }

    // Where a point's figures are kept: another build's are not this one's.
    std::filesystem::path stem(const TradePoint& point, const SettingsSchema& schema) const;

    // Without ending and AOV. `bounces` 0: all there are.
    std::filesystem::path reference(const std::string& scene, TradeMotion motion, int bounces) const;
    // The three images that a point is compared with.
    TradeReferences references(const TradePoint& point, const SettingsSchema& schema) const;

  private:
    const TradeOptions& options_;
    std::filesystem::path folder_;
    std::map<std::string, std::uint64_t> hashes_;
};

}  // namespace lanthorn::tools
