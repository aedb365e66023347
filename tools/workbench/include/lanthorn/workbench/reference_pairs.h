// Path-traced references in pairs, kept in memory and on disk.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "lanthorn/core/settings.h"
#include "lanthorn/reference/path_settings.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/workbench/image_error.h"

namespace lanthorn::workbench {

// Indirect irradiance of a frame, twice with (spp + 1) / 2 samples a pixel, by `settings` but for their
// number of samples and criteria to stop.
ReferencePair trace_pair(const FrameScene& frame, ivec2 size, reference::PathSettings settings, int spp);

// `settings` of a picture that is held against such a reference. Diffuse transport has no caustics: what they
// bring would count as error.
Settings comparable(Settings settings);

// Each pair is traced once: kept by what the scene shows in that moment, camera, size, bounces and samples.
class ReferencePairs {
  public:
    // `folder`: made if it is not there; two EXR files a pair. Empty: nothing is written. Throws InputError
    // if it cannot be written.
    ReferencePairs(std::filesystem::path folder, int spp);

    // `name` begins the files' names. Valid until forget().
    const ReferencePair& of(const FrameScene& frame, ivec2 size, int bounces, const std::string& name);
    void forget() { pairs_.clear(); }  // what is in memory

    int spp() const { return spp_; }        // samples a pixel of both together, as asked for
    int traced() const { return traced_; }  // so far; the others were there

  private:
    std::filesystem::path folder_;
    int spp_;
    int traced_ = 0;
    std::map<std::string, ReferencePair> pairs_;
};

}  // namespace lanthorn::workbench
