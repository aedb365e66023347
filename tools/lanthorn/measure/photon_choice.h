// How many photons `vertex-map` keeps and shoots in a frame of so many milliseconds, by the rule of thumb of
// Jozwowski 2002, sec. 5.3 with Table 1: those at which shooting takes as long as balancing.
#pragma once

#include <span>

namespace lanthorn::tools {

// What the three stages of a frame have taken, milliseconds, the tree being rebuilt.
struct PhotonFrame {
    int total = 0, per_frame = 0;
    double shoot = 0, balance = 0, estimate = 0;
    double whole() const { return shoot + balance + estimate; }
};

// Costs as the thesis finds them (sec. 5.1): shooting is linear in the photons of a frame, balancing goes as
// n log2 n of all that are kept, estimates as log2 n.
class PhotonCosts {
  public:
    // Fits them to measured frames of two totals and two numbers of photons a frame at least, by least
    // squares; what comes out below 0 is 0.
    explicit PhotonCosts(std::span<const PhotonFrame> measured);

    PhotonFrame at(int total, int per_frame) const;

  private:
    double shoot_ = 0, per_photon_ = 0;      // ms, of a frame and of each of its photons
    double balance_ = 0;                     // ms, by n log2 n
    double estimate_ = 0, by_doubling_ = 0;  // ms, of a frame and of each doubling of n
};

inline constexpr int kMostPhotons = 4'000'000;  // gi.vertex-map.total's own end

// The most photons whose frame takes at most `frame_ms`, shot so many at a time that shooting takes no longer
// than balancing, and one more would; at least one and at most all of them. Of two totals of such a frame
// the smaller is "too small" in Table 1, the larger "too large". Throws InputError where not even one photon
// fits. O(log kMostPhotons).
PhotonFrame choose_photons(const PhotonCosts& costs, double frame_ms);

}  // namespace lanthorn::tools
