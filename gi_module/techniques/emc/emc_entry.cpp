#include "gi_module/techniques/emc/emc_ladder.h"
#include "gi_module/techniques/emc/emc_technique.h"
#include "gi_module/techniques/emc/emc_views.h"
#include "lanthorn/emc/emc.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

TechniqueKind add_emc() {
    TechniqueEntry emc;
    emc.name = "emc";
    emc.docs =
        "multi-image photon tracing (Yao et al. 2010): photons bounce through environment maps and are "
        "counted "
        "on what these show, and rays gather that light; --preset paper splats them instead, as published";
    emc.has_presets = true;
    emc.reads = {"gi.bounces",   "gi.photons", "gi.seed",    "gi.accumulate", "gi.target_error",
                 "gi.caustics.", "gi.emc.",    "gi.gather.", "gi.specular."};
    emc.turns = {{"gi.photons", {"5000", "10000", "40000", "80000", "160000"}},
                 {"gi.emc.count", {"4", "6", "12"}},
                 {"gi.emc.resolution", {"64", "192", "256"}},
                 {"gi.emc.steps", {"16", "64", "128"}},
                 {"gi.bounces", {"1", "3"}},
                 {"gi.gather.grid", {"2", "3", "6"}},
                 {"gi.gather.rays", {"2", "8", "16"}},
                 {"gi.gather.texels", {"32", "96", "128"}},
                 {"gi.emc.rays", {"maps", "bvh"}},
                 {"gi.emc.splat.bandwidth", {"fixed"}},
                 {"gi.emc.splat.c0", {"4", "5.6", "11", "16"}},
                 {"gi.emc.splat.base", {"1", "2", "4", "8"}}};
    emc.debug_views = emc_views();
    emc.declare = declare_emc_settings;
    emc.make = []() -> std::unique_ptr<Technique> { return std::make_unique<EmcTechnique>(); };
    emc.first_plan = first_emc_plan;
    emc.ladder = emc_ladder;
    return add_technique(std::move(emc));
}

}  // namespace lanthorn::gi
