// Triangles that glow by a texture or as far as alpha covers them, cut into pieces that each glow evenly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {

// Nits that leave it, textures and vertex colours apart: a blended one shines as much as it covers.
vec3 emitted(const Material& material);
bool gives_light(const Material& material);  // any, by emitted()

// A part of a triangle, and how much of emitted() leaves from it.
struct EmissivePiece {
    std::array<vec3, 3> corners;  // barycentric coordinates in the triangle, in its winding
    vec3 share{1};                // rgb 0..1: the mean over the piece of texture and alpha

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

// Whether it takes pieces to say where light leaves a surface of `material`.
bool glows_in_pieces(const Material& material);

// Each triangle is halved across its longest edge until what it shows is even over a piece (within a tenth of
// the brightest there is) or a piece is a texel wide. A mesh has at most 16 384 of them, or one a triangle:
// then a piece has its mean. Pieces that touch share corners bit for bit. `mesh` has the textures'
// coordinates; alpha counts as AlphaMode says. O(texels that the mesh shows, 64 a piece at most).
EmissivePieces emissive_pieces(const SceneAssets& assets, const Mesh& mesh, const Material& material);

// What of emitted() leaves the mesh where it stands so: the mean of its pieces' shares over its area, rgb
// 0..1; 0 without area. O(triangles + pieces).
vec3 mean_share(const Mesh& mesh, const mat4& transform, const EmissivePieces& pieces);

}  // namespace lanthorn
