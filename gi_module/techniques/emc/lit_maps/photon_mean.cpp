#include "gi_module/techniques/emc/lit_maps/photon_mean.h"

#include <algorithm>

namespace lanthorn::gi {

namespace {

// Frames in the mean while light or surfaces change: more are less noise, and more lag. As many as a lamp
// takes for kDrift of EnvironmentMaps::extent(), if that is fewer.
constexpr int kMoving = 8;
constexpr float kDrift = 0.02f;
// A door that opens lets more light through in each frame: what the frames before have brought is not enough.
constexpr int kMovingSurfaces = 1;
// Units that a frame traces while surfaces move, since its mean holds no other.
constexpr int kWhileSurfacesMove = 2;
// Frames after the last change in which the mean, of which frames before it are a part, begins again.
constexpr int kSettled = 3;
// Units after which random numbers come again.
constexpr int kPeriod = 64;

// Frames in the mean while lamps move by such a share of EnvironmentMaps::extent() in each.
int frames_while(float drift) {
    return drift > 0 ? std::clamp(static_cast<int>(kDrift / drift), 1, kMoving) : kMoving;
}

}  // namespace

void PhotonMean::make_room() {
    units_ = std::min(units_, kFrames / 2);
}

std::optional<PhotonMean::Frame> PhotonMean::next(const Change& change) {
    still_ = change.any ? 0 : still_ + 1;
    if (mixed_ && still_ == kSettled) {
        units_ = 0;
    }
    if (!change.any && units_ >= kFrames) {
        return std::nullopt;
    }
    const bool first = units_ == 0;
    Frame frame;
    frame.times = first && !was_first_ ? kFirst : change.surfaces ? kWhileSurfacesMove : 1;
    was_first_ = first;
    // What is left of the frames before a change weighs little in the end.
    const int most = std::min(frames_while(change.drift), change.surfaces ? kMovingSurfaces : kMoving);
    frame.held = change.any ? std::min(units_, (most - 1) * frame.times) : units_;
    mixed_ = !first && (mixed_ || change.any);
    const int traced = frame.held == 0 ? 0 : next_ % kPeriod;
    frame.pass = (traced + frame.times - 1) / frame.times;
    units_ = frame.held + frame.times;
    next_ = (frame.pass + 1) * frame.times;
    return frame;
}

}  // namespace lanthorn::gi
