// What a look at the candidates has found: how much each sees, and how much of that no member of C sees. It
// comes in shares over several frames (MapCentres::look). No GL.
#pragma once

#include <cstddef>
#include <vector>

namespace lanthorn::gi {

class CandidateLook {
  public:
    // A look at so many begins: nothing is known.
    void begin(std::size_t candidates);
    // Nothing is known of whether candidates are closed, and of what they would add.
    void forget();

    // A candidate sees `area` m^2, which count `usable` in the choice; `closed`: it lies in a solid.
    void found(int candidate, double area, double usable, bool closed);
    // Of it no member of C sees `area` m^2, which count `usable`: A(v | C).
    void found_new(int candidate, double area, double usable);
    // It is in C now.
    void joined(int candidate);

    // A(v | C) as it counts for the choice; below 0: not known.
    double gain(int candidate) const { return gain_[static_cast<std::size_t>(candidate)]; }
    std::size_t size() const { return gain_.size(); }
    int best() const;  // the candidate of the largest gain, known or not; -1: there is none
    std::vector<std::size_t> closed() const;  // those in solids

    double coverage() const;  // the share of what candidates see that some member of C sees
    double largest() const;   // m^2 that count, of the candidate that sees most

  private:
    std::vector<double> area_, missed_, usable_, gain_;  // by candidate
    std::vector<bool> closed_;
};

}  // namespace lanthorn::gi
