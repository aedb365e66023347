// What a glTF primitive has so that it can be deformed. Vertices are those of its accessors here; remapped()
// follows what the import does to them.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/assets/gltf_context.h"
#include "engine/assets/vertex_frames.h"

namespace lanthorn {

// gltf_influences.cpp
// JOINTS_n and WEIGHTS_n of every vertex; empty, with a warning, if the primitive has none that go together.
// Of more than 8 influences the largest are kept. Weights are divided by their sum; a vertex without any is
// bound to joint 0 (warning). Refuses a joint beyond those of the skin and types that the format does not
// allow (glTF 2.0, 3.7.3.3).
std::vector<SkinInfluences> read_influences(const GltfContext& context, const tinygltf::Primitive& primitive,
                                            const std::string& place, std::size_t vertices,
                                            const JointLimit& limit);

// gltf_morph.cpp
// The primitive's `targets` (glTF 2.0, 3.7.2.2), each with the vertices that it moves alone. Refuses
// positions that are not finite; such normals and tangents are 0 (warning).
std::vector<MorphTarget> read_morphs(const GltfContext& context, const nlohmann::json& primitive,
                                     const std::string& place, std::size_t vertices);

// Makes the normals of targets follow their positions where the mesh has no normals of its own: the
// difference of each triangle's normal (glTF 2.0, 3.7.2.2: flat normals are computed). Exact for one target
// of weight 1. Every vertex must belong to one triangle alone.
void make_flat_morph_normals(const Mesh& mesh, std::vector<MorphTarget>& morphs);

// gltf_subdivision.cpp
// The cage that the extras of the primitive or else of its mesh ask for:
//   {"subdivision": {"scheme": "catmull-clark" | "loop", "level": 1..5,
//                    "creases": [[vertex, vertex, sharpness], ...], "faces": [corners of a face, ...]}}
// `level`, `creases` and `faces` (3 each) may be left out. What is wrong is told in a warning, and there is
// no cage. `indices` are the primitive's triangles.
std::optional<SubdivisionCage> read_cage(const GltfContext& context, std::size_t mesh, std::size_t primitive,
                                         const std::vector<std::uint32_t>& indices);

// The same for the vertices after the import.
std::vector<SkinInfluences> remapped(const std::vector<SkinInfluences>& influences,
                                     const VertexSources& sources);
MorphTarget remapped(const MorphTarget& target, const VertexSources& sources, std::size_t vertices_before);
// No vertex may have been split.
void remap(SubdivisionCage& cage, const VertexSources& sources, std::size_t vertices_before);

}  // namespace lanthorn
