// Paths side by side, one a lane: what is arithmetic alone is done for all of them at
// once, in the processor's widest registers. Each lane's numbers are its own: the same bits whatever stands
// beside it, on whichever registers.
#pragma once

#include <cstdint>
#include <span>

#include "gi_module/reference/bsdf.h"
#include "gi_module/reference/emitters.h"
#include "gi_module/reference/lights.h"
#include "gi_module/reference/random.h"

namespace lanthorn::reference {

inline constexpr int kLanes = 64;

template <class T>
struct alignas(64) Lanes {
    T values[kLanes];

    T& operator[](int lane) { return values[lane]; }
    T operator[](int lane) const { return values[lane]; }
};

struct VectorLanes {
    Lanes<float> x, y, z;

    vec3 at(int lane) const { return {x[lane], y[lane], z[lane]}; }
    void set(int lane, const vec3& v) {
        x[lane] = v.x;
        y[lane] = v.y;
        z[lane] = v.z;
    }
};

// Light drawn towards each lane's surface, to be added if nothing is in between.
struct ShadowLanes {
    VectorLanes start, span;
    VectorLanes light;  // nits, reflected; 0: no need to look
};

inline constexpr std::uint32_t kAir = 0xffffffffu;  // no medium

struct PathLanes {
    int count = 0;
    // Of the path.
    Lanes<std::uint32_t> key, index;  // its random numbers
    Lanes<int> sample;                // whose it is
    VectorLanes throughput;
    Lanes<std::uint32_t> medium;  // the material whose volume it is in, or kAir
    // Of the surface that it is at.
    VectorLanes position, normal, albedo;
    Lanes<float> offset;
    // Out of it.
    VectorLanes start, direction;
    Lanes<float> density;  // with which the direction was drawn

    // Another path, throughput 1. Its lane.
    int add(const RandomNumbers& random, int whose) {
        key[count] = random.key();
        index[count] = random.index();
        sample[count] = whose;
        throughput.set(count, vec3(1));
        medium[count] = kAir;
        return count++;
    }
    // Moves what is the path's own from one lane to another.
    void keep(int from, int to) {
        key[to] = key[from];
        index[to] = index[from];
        sample[to] = sample[from];
        throughput.set(to, throughput.at(from));
        medium[to] = medium[from];
    }
    // All lanes that are in use, and some more to fill the registers.
    int filled() const { return (count + 15) & ~15; }
};

// What full transport needs of the surfaces besides.
struct MaterialLanes {
    VectorLanes towards, shading, base_colour;
    Lanes<float> alpha, metallic, roughness, f0, transmission, straight;

    // As Bsdf's constructor.
    void set(int lane, const SurfaceMaterial& material, const vec3& n, const vec3& v, bool goes_straight);
};

// The lights that were drawn.
struct LightLanes {
    VectorLanes position, direction, intensity;
    Lanes<float> range, cone_scale, cone_offset, weight, infinite;

    void set(int i, const PunctualLight& light);
};

struct EmitterLanes {
    Lanes<float> choice, u, v;  // in: random numbers
    VectorLanes corner, edge1, edge2, normal, radiance;
    Lanes<float> density, offset, two_sided;

    void set(int i, const EmitterTriangle& triangle);
};

// One random pair a lane.
void draw_pairs(const PathLanes& paths, std::uint32_t dimension, Lanes<float>& x, Lanes<float>& y);
// Starts off the surfaces, and directions about their normals with density cos / pi.
void leave_surfaces(PathLanes& paths, std::uint32_t dimension);
// The same with the materials' own lobes; throughput then takes in what they scatter that way. Where there is
// no direction, density or throughput is 0.
void leave_surfaces(PathLanes& paths, const MaterialLanes& materials, std::uint32_t dimension);
// What light of each lane is reflected there, diffusely or as `materials` says.
void light_surfaces(const PathLanes& paths, const LightLanes& lights, ShadowLanes& shadows);
void light_surfaces(const PathLanes& paths, const MaterialLanes& materials, const LightLanes& lights,
                    ShadowLanes& shadows);
// The same of emitters, weighed against directions drawn by leave_surfaces().
void light_surfaces(const PathLanes& paths, const EmitterLanes& emitters, ShadowLanes& shadows);
void light_surfaces(const PathLanes& paths, const MaterialLanes& materials, const EmitterLanes& emitters,
                    ShadowLanes& shadows);
// Throughput times albedo.
void pass_surfaces(PathLanes& paths);

}  // namespace lanthorn::reference
