// What can be set of `splat`: gi.splat.*, declared with unit, range and cost in
// splat_settings.cpp.
#pragma once

#include "gi_module/shared/photons/photon_tracer.h"

namespace lanthorn::gi {

class SettingList;

enum class PhotonKernel { constant, epanechnikov };
enum class SplatAdaptive { none, caustics, all };

struct SplatSettings {
    int photons = 1'000'000;      // walks that a still picture is made of, at most
    int batch = 131'072;          // walks a frame while it grows
    float bandwidth = 20;         // C of sec. 3.3
    float caustic_bandwidth = 2;  // the same of caustic photons
    PhotonKernel kernel = PhotonKernel::constant;
    bool boundaries = true;  // sec. 4.1
    SplatAdaptive adaptive = SplatAdaptive::caustics;
    int levels = 4;     // bandwidths, each 3/4 of the one before
    int least = 20;     // N_min of sec. 4.3
    int most = 500;     // N_max
    float bias = 0.3f;  // epsilon: second difference over N
    PhotonScattering scattering = PhotonScattering::even;
    int memory = 64;  // MiB of photons, before they go to disk
    int threads = 0;  // 0: all; never changes the image
};

void declare_splat_settings(SettingList& list);

}  // namespace lanthorn::gi
