// Where the light of the photons goes.
#pragma once

#include <functional>
#include <vector>

#include "lanthorn/workbench/photon_flights.h"

namespace lanthorn::workbench {

// All in lumen, by colour. What comes in (the light's flux, then what the step before reflected) is stored or
// lost; what is stored is absorbed or reflected.
struct EnergyStep {
    dvec3 incoming{0};
    dvec3 stored{0};     // of photons that arrived at a surface
    dvec3 lost{0};       // of photons that arrived at none
    dvec3 lost_true{0};  // of lost: no surface is there by exact ray either (an opening, a solid's inside)
    dvec3 absorbed{0};
    dvec3 reflected{0};
    dvec3 stored_exact{0};  // what the same flights store by exact rays; 0 for the first surfaces
};

// Where flux goes, bounce by bounce.
struct EnergyBalance {
    EnergyStep first;  // from the lights to the first surfaces; its losses are not split
    std::vector<EnergyStep> bounces;
};

// `done` is told how many flights have been looked at. One exact ray a flight.
EnergyBalance measure_energy(const PhotonFlights& flights, const std::function<void(std::uint64_t)>& done);

// Rec. 709 luminance, lumen.
double luminous(const dvec3& flux);

}  // namespace lanthorn::workbench
