// Where photons come from: every light of a scene by its flux (Lavignotte and Paulin 2003, sec. 2.1 and 3.4).
//
// Lights of one chromaticity are a group. A group's walks begin with the same flux (their phi_G), lights of
// it are drawn by flux; the groups share all walks by flux, f of sec. 3.4 being the largest channel.
// Exceptions, whose photons vary about their group's flux: textured emitters and the sky.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/scene/kept_emissive_pieces.h"
#include "gi_module/reference/material_table.h"
#include "gi_module/reference/trace_scene.h"
#include "gi_module/shared/caustics/caustic_aim.h"
#include "gi_module/shared/caustics/caustic_sky.h"

namespace lanthorn::gi {

struct LightGroup {
    vec3 flux{0};    // lumen, rgb, that its lights send into the scene; of the sky an estimate
    double end = 1;  // share of all walks that this group and those before it have
    bool sky = false;
};

// The beginning of a walk.
struct PhotonStart {
    vec3 origin{0};
    vec3 direction{0};    // unit; 0 where light leaves a surface
    vec3 flux{0};         // as Photon::flux; 0: nothing goes that way
    float range = 1e30f;  // metres to where a punctual light's window ends
    // Not 0: light leaves a surface of this unit normal at `origin`, and who asks draws its direction, with
    // density cos / pi, from the second of the pairs, and starts it `offset` metres off the surface.
    vec3 normal{0};
    float offset = 0;
};

class PhotonSources {
  public:
    PhotonSources() = default;  // none: no light
    // `scene` and `materials` must outlive this. `kept`: pieces of the frames before; null: all are cut.
    // O(lights
    // + emissive triangles and pieces + pixels of the sky).
    PhotonSources(const reference::TraceScene& scene, const reference::MaterialTable& materials,
                  KeptEmissivePieces* kept = nullptr);

    bool empty() const { return groups_.empty(); }
    std::span<const LightGroup> groups() const { return groups_; }

    // Walk `number` belongs to a group, of which it is the so-many-th. Any first n walks are shared by flux,
    // to within one a group where n is a multiple of kBlock. O(groups).
    struct Place {
        std::size_t group = 0;
        std::uint64_t index = 0;
    };
    static constexpr std::uint64_t kBlock = 1024;
    Place place(std::uint64_t number) const;
    // How many of the first `count` walks belong to each group. O(groups * kBlock).
    std::vector<std::uint64_t> paths(std::uint64_t count) const;

    // `u`: independent pairs in [0, 1), of which kDirectionPair is left to who asks. O(log lights).
    static constexpr std::uint32_t kStartPairs = 4;
    static constexpr std::uint32_t kDirectionPair = 1;
    using Pairs = std::array<vec2, kStartPairs>;
    PhotonStart start(std::size_t group, const Pairs& u) const;

  private:
    struct Source {
        double end = 0;           // flux of this one and those before it in the group
        std::uint32_t light = 0;  // into FrameScene::lights, or triangles_
        bool triangle = false;
    };
    // A spot's attenuation is the square of a ramp that rises from 0 at the cosine of its outer cone by
    // `scale`, up to 1 (KHR_lights_punctual).
    class SpotCone {
      public:
        SpotCone() = default;
        explicit SpotCone(const Light& light);
        double solid_angle() const;     // weighed by attenuation
        double cosine(double u) const;  // drawn by attenuation, u in [0, 1)

      private:
        double outer_ = 0, scale_ = 1, whole_ = 1;
        double ramp_ = 0;  // its part of the solid angle over 2 pi
    };
    // Where a light sends photons.
    struct Aim {
        double size = 0;  // steradian, of a parallel beam square metres; 0: it reaches nothing
        CausticAim box;   // of parallel beams and point lights: all that there is
        dvec3 right{1, 0, 0}, up{0, 1, 0};  // square to box.axis
        SpotCone cone;                      // of spots
    };
    struct Triangle {
        vec3 corner{0}, edge1{0}, edge2{0};
        vec3 normal{0};
        float offset = 0;
        std::uint32_t instance = 0, primitive = 0;
        bool both = false, even = true;  // sides, emission
        vec3 mean{0};                    // nits, over the instance's area
    };
    struct Colour {
        std::uint64_t key = 0;  // chromaticity
        dvec3 flux{0};
        std::vector<Source> sources;
    };
    void add(const dvec3& flux, Source source, std::vector<Colour>& colours) const;
    std::uint64_t before(std::size_t groups, std::uint64_t block) const;
    Aim aim(const LightInstance& light) const;
    PhotonStart from_light(std::uint32_t light, const vec3& flux, const vec2& u) const;
    PhotonStart from_triangle(const Triangle& triangle, const vec3& flux, const Pairs& u) const;
    PhotonStart from_sky(const Pairs& u) const;

    const reference::TraceScene* scene_ = nullptr;
    const reference::MaterialTable* materials_ = nullptr;
    Aabb box_;        // about the scene
    double far_ = 0;  // metres that parallel beams start before it
    std::vector<LightGroup> groups_;
    std::vector<std::vector<Source>> sources_;  // by group; of the sky none
    std::vector<Aim> aims_;                     // by light
    std::vector<Triangle> triangles_;
    std::shared_ptr<const CausticSky> sky_;
};

}  // namespace lanthorn::gi
