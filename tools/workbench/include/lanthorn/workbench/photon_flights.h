// The photons of one frame of `emc`, flight by flight: what its passes did, read back from the GPU.
#pragma once

#include <vector>

#include "lanthorn/core/settings.h"
#include "lanthorn/gi/statistics.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::workbench {

// A photon that left a surface.
struct PhotonFlight {
    vec3 origin{0};  // render space, off its surface
    vec3 direction{0};
    dvec3 power{0};  // lumen
    bool arrived = false;
    vec3 position{0};  // where, as the environment maps have it
};

struct PhotonFlights {
    FrameScene frame;
    gi::GiStatistics statistics;
    std::vector<vec3> map_centres;                   // the selected environment maps', render space
    std::vector<vec3> candidates;                    // that those were chosen from
    std::vector<std::vector<PhotonFlight>> bounces;  // by bounce, of the photons that are still under way
    dvec3 flux_without_surface{0};      // lumen: of photons that left a light and met no first surface
    std::vector<dvec3> flux_reflected;  // lumen: by the first surfaces [0], then by those of each bounce
};

// Renders one frame of the scene at the choice's time (default: 0) and traces its photons. Throws InputError
// if the settings ask for another technique or the scene's light is never reflected, and what ShownScene()
// does; Error(ExitCode::no_gl) without OpenGL 4.5. Costs a trace for each bounce and a read of all photons.
PhotonFlights trace_photons(SceneData scene, const Settings& settings, const SceneChoice& choice);

}  // namespace lanthorn::workbench
