// Morph targets, skins and subdivision surfaces in an App.
#pragma once

#include "lanthorn/deformation/detail.h"
#include "lanthorn/runtime/plugin.h"

namespace lanthorn {

// How finely surfaces are refined: a resource that the frame's `detail` systems fill between transforms and
// skinning.
struct SurfaceDetail {
    bool adaptive = false;  // as finely as `hints` ask for; false: as finely as the file says
    DetailHints hints;

    // What Deformation is to be given: `hints`, or null for the detail of the file.
    const DetailHints* wanted() const { return adaptive ? &hints : nullptr; }
};

// Needs ScenePlugin. Resources: SurfaceDetail, Deformation.  frame: transforms -> morphs -> skinning ->
// subdivision -> bounds -> extract
class DeformationPlugin final : public Plugin {
  public:
    std::string_view name() const override { return "deformation"; }
    void build(App& app) override;
};

}  // namespace lanthorn
