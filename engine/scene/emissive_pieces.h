// Triangles that glow by a texture, cut into pieces that each glow evenly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {

// A part of a triangle, and how much of the material's emission leaves from it.
struct EmissivePiece {
    std::array<vec3, 3> corners;  // barycentric coordinates in the triangle, in its winding
    vec3 share{1};                // rgb 0..1: the texture's mean over the piece

    // Where it lies in a triangle of these corners.
    std::array<vec3, 3> within(const std::array<vec3, 3>& triangle) const {
        std::array<vec3, 3> part;
        for (std::size_t k = 0; k < 3; ++k) {
            const vec3& at = corners[k];
            part[k] = triangle[0] * at.x + triangle[1] * at.y + triangle[2] * at.z;
        }
        return part;
    }
};

// The pieces of a mesh's triangles.
class EmissivePieces {
  public:
    // Of triangle `t`, black ones too.
    std::span<const EmissivePiece> of(std::size_t t) const {
        return std::span(pieces_).subspan(first_[t], first_[t + 1] - first_[t]);
    }
    // Which of them, in the order of of(), has the point of barycentric coordinates `at`. O(halvings).
    std::size_t piece_at(std::size_t t, vec3 at) const;

  private:
    friend class EmissiveCut;
    // A triangle that was halved across `edge`, or one that was not.
    struct Node {
        std::uint32_t left = kWhole, right = 0;  // nodes; of a piece `right` is its number in of()
        std::uint32_t edge = 0;
    };
    static constexpr std::uint32_t kWhole = 0xffffffffu;
    std::vector<EmissivePiece> pieces_;
    std::vector<std::uint32_t> first_{0};  // of pieces_, one a triangle and the end
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> roots_;  // one a triangle
};

// Each triangle is halved across its longest edge until the texture is even over a piece (within a tenth of
// its brightest texel) or a piece is a texel wide. A mesh has at most 16 384 of them, or one a triangle: then
// a piece has its mean. Pieces that touch share corners bit for bit. `mesh` has the texture's coordinates;
// `material` has an emissive texture. O(texels that the mesh shows, 64 a piece at most).
EmissivePieces emissive_pieces(const SceneAssets& assets, const Mesh& mesh, const Material& material);

}  // namespace lanthorn
