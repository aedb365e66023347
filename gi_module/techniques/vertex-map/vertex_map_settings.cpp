#include "gi_module/techniques/vertex-map/vertex_map_settings.h"

#include "lanthorn/gi/setting_list.h"

namespace lanthorn::gi {

namespace {

void declare_photon_settings(SettingList& list) {
    list.declare<&VertexMapSettings::total>("gi.vertex-map.total")
        .unit("photons")
        .range(1, 4'000'000)
        .presets({5'000, 20'000, 60'000, 200'000})
        .as_published(2'000)
        .cost("linear in MB; logarithmic in ms of estimates")
        .docs(
            "vertex-map: photons that are kept. A still scene is done once so many have been shot in it. "
            "Many: "
            "light lags behind what changes.");
    list.declare<&VertexMapSettings::per_frame>("gi.vertex-map.per_frame")
        .unit("photons")
        .range(1, 4'000'000)
        .presets({500, 1'000, 3'000, 10'000})
        .as_published(100)
        .cost("linear in ms of photons, in frames in which light or geometry changes and after")
        .docs(
            "vertex-map: photons that take the places of the oldest in a frame. Few: light lags behind; "
            "many: it "
            "fluctuates, unless gi.vertex-map.distribution is total.");
    list.declare<&VertexMapSettings::max_level>("gi.vertex-map.max_level")
        .unit("hits")
        .range(1, 9)
        .presets({3, 3, 4, 5})
        .as_published(3)
        .cost("linear in ms of photons")
        .docs(
            "vertex-map: hits of a photon, the first being direct light; at most gi.bounces + 1 are traced. "
            "1: direct light alone.");
    list.declare<&VertexMapSettings::direct>("gi.vertex-map.direct")
        .as_published(true)
        .cost("ms of estimates by half; the engine's direct pass is left out")
        .docs(
            "vertex-map: what lamps send to surfaces is told by photons as well, as in the thesis: soft "
            "shadows "
            "without shadow maps, and no highlights of lamps.");
    list.declare<&VertexMapSettings::distribution>("gi.vertex-map.distribution")
        .choices({"random", "per_frame", "total"})
        .as_published(PhotonDistribution::total)
        .cost("none")
        .docs(
            "vertex-map: the ways that photons set out. random: other ones always, which flickers; "
            "per_frame: "
            "the same in every frame, which covers little; total: the same again once all have been shot.");
    list.declare<&VertexMapSettings::tree>("gi.vertex-map.tree")
        .choices({"kept", "rebuilt"})
        .as_published(TreeKind::rebuilt)
        .cost("kept: by photons that come; rebuilt: by all that are kept")
        .docs(
            "vertex-map: the k-d tree is updated where photons come and go, or rebuilt in every frame "
            "(nanoflann). Never changes the picture.");
}

void declare_estimate_settings(SettingList& list) {
    list.declare<&VertexMapSettings::nearest>("gi.vertex-map.nearest")
        .unit("photons")
        .range(2, 10'000)
        .presets({120, 200, 300, 500})
        .as_published(100)
        .cost("linear in ms of estimates")
        .docs("vertex-map: m, the nearest photons that tell the light at a vertex. Few: noise; many: blur.");
    list.declare<&VertexMapSettings::distance>("gi.vertex-map.distance")
        .unit("of the scene's size")
        .range(0.001f, 1.0f)
        .cost("none but where photons are few")
        .docs("vertex-map: photons further away never count. Small: dark places go darker in steps.");
    list.declare<&VertexMapSettings::kernel>("gi.vertex-map.kernel")
        .choices({"constant", "epanechnikov"})
        .as_published(EstimateKernel::constant)
        .cost("none")
        .docs(
            "vertex-map: whether all of the nearest photons count alike, or those nearer more, so that none "
            "comes or "
            "goes at once: less flicker from twice as many.");
    list.declare<&VertexMapSettings::surface_area>("gi.vertex-map.surface_area")
        .as_published(false)
        .cost("once, when a vertex is first seen")
        .docs(
            "vertex-map: light is over what of the circle about the vertex is surface; false: over all of "
            "it, as "
            "in the thesis, which leaves edges dark.");
    list.declare<&VertexMapSettings::any_surface>("gi.vertex-map.any_surface")
        .as_published(true)
        .cost("none")
        .docs("vertex-map: photons of other surfaces near by count too, as in the thesis: light leaks.");
}

void declare_mesh_settings(SettingList& list) {
    list.declare<&VertexMapSettings::edge>("gi.vertex-map.edge")
        .unit("of the scene's size")
        .range(0.001f, 1.0f)
        .presets({0.08f, 0.06f, 0.04f, 0.03f})
        .as_published(0.14f)
        .cost("inverse square in ms of estimates")
        .docs("vertex-map: longer edges are halved until they are at most so long. 1: meshes as they are.");
    list.declare<&VertexMapSettings::density>("gi.vertex-map.density")
        .unit("levels")
        .range(0, 4)
        .presets({0, 1, 2, 2})
        .as_published(0)
        .cost("up to 4 times the ms of estimates a level, where photons lie close")
        .docs(
            "vertex-map: triangles are subdivided so many times more where an estimate's photons lie closer "
            "than "
            "the triangle's edges are long, once all photons have been shot.");
    list.declare<&VertexMapSettings::corners>("gi.vertex-map.corners")
        .as_published(true)
        .cost("false: up to 6 times the ms of estimates")
        .docs("vertex-map: vertices in one place that face one way share an estimate.");
    list.declare<&VertexMapSettings::skip>("gi.vertex-map.skip")
        .choices({"none", "back_faces", "hidden"})
        .as_published(SkippedVertices::back_faces)
        .cost("none: about twice the ms of estimates")
        .docs(
            "vertex-map: vertices that get no estimate: those of triangles that face away, or of all that "
            "the "
            "picture does not show.");
    list.declare<&VertexMapSettings::simplify>("gi.vertex-map.simplify")
        .unit("of each shape's diagonal")
        .range(0.0f, 0.2f)
        .as_published(0)
        .cost("less ms of photons in scenes of many triangles that move")
        .docs(
            "vertex-map: photons meet coarser shapes that lie off by so much at most. 0: the shapes drawn.");
    list.declare<&VertexMapSettings::threads>("gi.vertex-map.threads")
        .unit("threads")
        .range(0, 1024)
        .cost("inverse in ms; 0: as many as there are cores")
        .docs("vertex-map: threads that trace and estimate. Never changes the picture.");
}

}  // namespace

void declare_vertex_map_settings(SettingList& list) {
    declare_photon_settings(list);
    declare_estimate_settings(list);
    declare_mesh_settings(list);
}

}  // namespace lanthorn::gi
