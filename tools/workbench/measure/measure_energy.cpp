#include "lanthorn/workbench/measure_energy.h"
#include "lanthorn/emc/emc_statistics.h"

#include <algorithm>

#include "tools/workbench/measure/measured_scene.h"

namespace lanthorn::workbench {

double luminous(const dvec3& flux) {
    return glm::dot(flux, dvec3(0.2126, 0.7152, 0.0722));
}

EnergyBalance measure_energy(const PhotonFlights& flights, const std::function<void(std::uint64_t)>& done) {
    const ExactSurfaces surfaces(flights.frame);
    EnergyBalance balance;
    EnergyStep& first = balance.first;
    first.incoming = flights.statistics.of<gi::PhotonStatistics>().flux_emitted;
    first.lost = flights.flux_without_surface;
    first.stored = first.incoming - first.lost;
    first.reflected = flights.flux_reflected.front();
    first.absorbed = first.stored - first.reflected;
    std::uint64_t looked_at = 0;
    for (std::size_t b = 0; b < flights.bounces.size(); ++b) {
        EnergyStep& step = balance.bounces.emplace_back();
        for (const PhotonFlight& flight : flights.bounces[b]) {
            const auto exact = surfaces.arrival(flight.origin, flight.direction);
            const bool stored = exact && exact->receives;
            step.incoming += flight.power;
            step.stored += flight.arrived ? flight.power : dvec3(0);
            step.lost += flight.arrived ? dvec3(0) : flight.power;
            step.lost_true += flight.arrived || stored ? dvec3(0) : flight.power;
            step.stored_exact += stored ? flight.power : dvec3(0);
            done(++looked_at);
        }
        step.reflected = flights.flux_reflected[b + 1];
        step.absorbed = step.stored - step.reflected;
    }
    return balance;
}

}  // namespace lanthorn::workbench
