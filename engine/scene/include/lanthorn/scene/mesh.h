// Triangle meshes as the renderer takes them: one material each, indexed, every attribute present.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/scene/deformation_data.h"

namespace lanthorn {

// One vertex; missing glTF attributes are generated or defaulted on import, so all fields always hold.
struct Vertex {
    vec3 position{0};          // metres, object space
    vec3 normal{0, 0, 1};      // unit length, object space
    vec4 tangent{1, 0, 0, 1};  // xyz unit length; w = +-1, the bitangent's sign (glTF 2.0, 3.7.2.1)
    vec2 uv0{0};               // TEXCOORD_0
    vec2 uv1{0};               // TEXCOORD_1
    vec4 colour{1};            // COLOR_0, linear RGBA
};

// A glTF primitive after import.
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;  // 3 per triangle, counter-clockwise front; all < vertices.size()
    std::uint32_t material = 0;          // index into SceneData's or SceneAssets::materials (always valid)
    Aabb bounds;                         // of the positions, object space

    std::vector<SkinInfluences> skin;     // one a vertex, or empty
    std::vector<MorphTarget> morphs;      // mesh.primitives[].targets
    std::vector<float> morph_weights;     // mesh.weights: one a target, the node's unless it says otherwise
    std::optional<SubdivisionCage> cage;  // `extras`: {"subdivision": ...}

    // The instance's vertices may differ from these.
    bool deforms() const { return !skin.empty() || !morphs.empty() || cage.has_value(); }
};

}  // namespace lanthorn
