// Photons that have arrived, on the GPU: what lies between those that trace photons and those that use them.
// Whoever fills one, through maps or by exact rays, can be splatted or counted by sensors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gi_module/techniques/emc/photons/photon.h"
#include "lanthorn/gpu/buffer.h"

namespace lanthorn::gi {

struct PhotonSet {
    gpu::Buffer hits;   // PhotonHit[capacity]; those with radius 0 are none
    gpu::Buffer count;  // one uint32: the first so many of `hits` are there, at most `capacity`
    int capacity = 0;
    float h_max = 0;    // metres: no photon's radius is larger
    float h_fixed = 0;  // metres: the average photon's
    // In which each has come, uint32[capacity], octahedral, 2 x snorm16; none where nobody shows them on
    // glossy surfaces.
    gpu::Buffer directions;

    // Room for so many, all of which are there until `count` says otherwise.
    void allocate(int places) {
        capacity = places;
        hits = gpu::Buffer(sizeof(PhotonHit) * static_cast<std::size_t>(places));
        directions = gpu::Buffer();
        count = gpu::Buffer::from(std::vector<std::uint32_t>{static_cast<std::uint32_t>(places)});
    }
    // The first so many are there.
    void hold(int places) {
        const auto held = static_cast<std::uint32_t>(places);
        count.write_bytes(0, &held, sizeof(held));
    }
    // Waits for the GPU.
    std::vector<PhotonHit> read() const {
        return capacity > 0 ? hits.read<PhotonHit>(count.read<std::uint32_t>(1).front())
                            : std::vector<PhotonHit>();
    }
};

}  // namespace lanthorn::gi
