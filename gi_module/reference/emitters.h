// The emissive triangles of a scene, cut into pieces where texture or alpha vary what they emit: drawn by
// flux, evenly over each.
#pragma once

#include <memory>
#include <vector>

#include "engine/scene/kept_emissive_pieces.h"
#include "gi_module/reference/material_table.h"
#include "gi_module/reference/trace_scene.h"

namespace lanthorn::reference {

struct EmitterSample {
    vec3 position{0};
    vec3 normal{0};     // out of the front, unit
    vec3 radiance{0};   // nits, towards its lit side or sides
    float density = 0;  // per square metre
    float offset = 0;   // metres off the surface that a shadow ray must end
    bool two_sided = false;
};

// A triangle or, of one that glows by a texture, a piece.
struct EmitterTriangle {
    vec3 corner{0}, edge1{0}, edge2{0};
    vec3 normal{0};    // out of the front, unit
    vec3 radiance{0};  // nits, if it is the same everywhere
    std::uint32_t instance = 0, primitive = 0;
    float density = 0;  // per square metre: probability of the triangle over its area
    float offset = 0;   // TraceTriangle::offset
    bool two_sided = false;
    bool uniform = true;
    std::uint32_t piece = 0;  // of its triangle, if that was cut
};

// What the instance's triangles are cut into; null: they glow evenly. Those that subdivision made, or that
// are fewer than the mesh's, are cut each time.
std::shared_ptr<const EmissivePieces> pieces_of(const TraceScene& scene, std::uint32_t instance,
                                                KeptEmissivePieces& kept);

class Emitters {
  public:
    // Writes TraceTriangle::emitter of every triangle. What is blended emits what it shows: its emission
    // times alpha. `kept`: pieces of the frames before; null: all are cut.
    Emitters(TraceScene& scene, const MaterialTable& materials, KeptEmissivePieces* kept = nullptr);

    bool empty() const { return triangles_.empty(); }
    // Whether there are so many that choosing one needs a number of its own; else draw() splits it off `u`.
    bool many() const { return triangles_.size() > kSplit; }
    // `choice` and `u` in [0, 1). O(1).
    EmitterSample draw(float choice, vec2 u) const;
    // The triangle alone, `u` then ready for triangle_point().
    const EmitterTriangle& draw_triangle(float choice, vec2& u) const;
    // `barycentric`: weights of its second and third corner.
    vec3 radiance(const EmitterTriangle& triangle, const vec2& barycentric) const;
    // The density, per solid angle as seen over `distance`, with which draw() finds the point of `hit`.
    float density(const SurfaceHit& hit, float distance, float cosine) const;

  private:
    static constexpr std::size_t kSplit = 64;  // 24 bits less 6: enough for a place on a triangle
    struct Slot {
        float threshold;  // below: this one; above: `alias`
        std::uint32_t alias;
    };
    void add(const TraceScene& scene, std::uint32_t instance, std::uint32_t primitive,
             const MaterialConstants& material, std::vector<double>& flux);
    void make_alias_table(const std::vector<double>& flux, double total);

    const TraceScene& scene_;
    const MaterialTable& materials_;
    std::vector<std::shared_ptr<const EmissivePieces>> pieces_;  // by instance; null: not cut
    std::vector<EmitterTriangle> triangles_;
    std::vector<Slot> slots_;
};

}  // namespace lanthorn::reference
