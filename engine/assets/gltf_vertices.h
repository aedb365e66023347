// The vertices of a glTF primitive: its attributes, but for those that deform it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include "engine/assets/gltf_context.h"
#include "engine/assets/gltf_integers.h"

namespace lanthorn {

class GltfVertices {
  public:
    // `place`: the primitive's, for what is said of it.
    GltfVertices(const GltfContext& context, const tinygltf::Primitive& primitive, std::string place);

    bool has(const std::string& name) const { return primitive_.attributes.contains(name); }
    std::string place_of(const std::string& name) const { return place_ + "/attributes/" + name; }
    std::size_t count() const { return count_; }  // as the positions' accessor has it; 0: there are none
    // No accessor of its attributes and indices is without data.
    bool data_present() const;

    // Into as many vertices of the mesh, first of all.
    void read_positions(Mesh& mesh);
    // Normals, tangents, texture coordinates and colours, as far as they are there.
    void read_others(Mesh& mesh) const;
    // Of shapes of `corners` vertices each, those that are somewhere.
    std::vector<std::uint32_t> without_nowhere(const std::vector<std::uint32_t>& list,
                                               std::size_t corners) const;

  private:
    // The attribute's values, `components` each; its accessor must have `min_components` to `components` of
    // them.
    std::vector<float> attribute(const std::string& name, std::size_t min_components, std::size_t components,
                                 float fill = 0, Integers integers = Integers::as_stated) const;
    Integers integers_of_texture_coordinates(const std::string& name) const;
    void read_frames(Mesh& mesh) const;
    void read_texture_coordinates(Mesh& mesh, std::uint32_t set, vec2 Vertex::*member) const;
    void read_colours(Mesh& mesh) const;

    const GltfContext& context_;
    const tinygltf::Primitive& primitive_;
    std::string place_;
    std::size_t count_ = 0;
    std::unordered_set<std::uint32_t> nowhere_;  // vertices whose position is no number
};

}  // namespace lanthorn
