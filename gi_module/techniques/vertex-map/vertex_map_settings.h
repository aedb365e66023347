// What can be set of `vertex-map`: gi.vertex-map.*, declared with unit, range and cost in
// vertex_map_settings.cpp.
#pragma once

#include "gi_module/techniques/vertex-map/radiance_estimate.h"

namespace lanthorn::gi {

class SettingList;

enum class PhotonDistribution { random, per_frame, total };
enum class TreeKind { kept, rebuilt };
enum class SkippedVertices { none, back_faces, hidden };

struct VertexMapSettings {
    int total = 20000;     // photons that are kept
    int per_frame = 1000;  // that are shot anew in a frame in which anything changes
    int max_level = 3;     // hits of a photon: the first is direct light
    bool direct = false;   // which counts, too, and stands for the engine's own
    PhotonDistribution distribution = PhotonDistribution::total;
    TreeKind tree = TreeKind::kept;

    int nearest = 200;       // m: photons of an estimate
    float distance = 0.15f;  // that they lie within, a share of the scene's size (vertex_scene.h)
    EstimateKernel kernel = EstimateKernel::epanechnikov;
    bool surface_area = true;  // what of the circle is surface; false: all of it, as in the thesis
    bool any_surface = false;  // photons of other surfaces count too, as in the thesis

    float edge = 0.06f;   // of a drawn triangle at most, likewise
    int density = 1;      // levels that triangles are subdivided more, where photons lie close
    bool corners = true;  // shared
    SkippedVertices skip = SkippedVertices::hidden;
    float simplify = 0;  // how far shapes that photons meet may lie off, a share of each one's own box
    int threads = 0;     // 0: all; never changes the image
};

void declare_vertex_map_settings(SettingList& list);

}  // namespace lanthorn::gi
