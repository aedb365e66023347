// What one sample of one pixel sees: unidirectional path tracing (Kajiya 1986) with next-event estimation and
// multiple importance sampling (Veach 1997, ch. 9). Boundaries of volumes are no vertices of a path but bends
// of its rays, sampled alone: no light is drawn there, nor from behind them, and they count as no reflection.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "gi_module/reference/bsdf.h"
#include "gi_module/reference/camera_rays.h"
#include "gi_module/reference/dielectric.h"
#include "gi_module/reference/emitters.h"
#include "gi_module/reference/lights.h"
#include "gi_module/reference/material_table.h"
#include "gi_module/reference/path_lanes.h"
#include "gi_module/reference/path_listener.h"
#include "gi_module/reference/random.h"
#include "gi_module/reference/sky_light.h"
#include "gi_module/reference/trace_scene.h"
#include "lanthorn/reference/path_settings.h"

namespace lanthorn::reference {

// Which of a sample's parts are wanted; the others are not computed.
struct SampleParts {
    bool indirect = false;
    bool direct = false;
    bool radiance = false;
};

struct PathSample {
    vec3 indirect{
        0};  // lux: irradiance at the first visible surface by light reflected before it and by the sky
    vec3 direct{0};    // nits: what it reflects of light that comes straight from the lights
    vec3 radiance{0};  // nits; unlit surfaces: their colour
};

// The first visible surface of a pixel, blended ones passed over.
struct FirstSurface {
    SurfaceHit hit;
    vec3 towards{0};  // unit, to the camera
};

// A point that somebody else has found on a surface, and one sample of the light that it gets.
struct IrradianceStart {
    vec3 position{0};
    vec3 normal{0};    // unit, on the side that is lit
    float offset = 0;  // metres a ray must start off it so as not to meet its surface
    RandomNumbers random;
};

// Where a sample begins.
struct SampleStart {
    CameraRay ray;
    const FirstSurface* first = nullptr;  // that its pixel sees; null: nothing but blended ones
    RandomNumbers random;
};

class Integrator {
  public:
    // Everything must outlive this. Thread-safe from here on.
    Integrator(const TraceScene& scene, const MaterialTable& materials, const Emitters& emitters,
               const PunctualLights& lights, const SkyLight& sky, const PathSettings& settings);

    // As if these instances were not there, for what follows; camera rays still see them. Slower: rays go one
    // by one.
    void leave_out(std::vector<std::uint32_t> instances);

    // The nearest surface on a camera ray: backs of single-sided ones are not seen.
    std::optional<FirstSurface> first_surface(const CameraRay& ray) const;

    // A sample of each start. What comes out of one does not depend on the others; together they are faster.
    void sample(std::span<const SampleStart> starts, const SampleParts& parts,
                std::span<PathSample> results) const;
    // The irradiance of each point, in lux, by the sky and by light reflected 1 to `bounces` times before,
    // one sample each: PathSample::indirect for points without a pixel. How many rays it took, shadow rays
    // included. A listener is told where the light comes from, and changes none of it.
    std::uint64_t irradiance(std::span<const IrradianceStart> starts, std::span<vec3> results,
                             PathListener* listener = nullptr) const;

  private:
    // Light that comes along a ray.
    struct Incoming {
        vec3 emitted{0};          // nits, by the first surface met
        float light_density = 0;  // per solid angle with which that point is drawn as a light
        vec3 reflected{0};        // nits, after 1 to `bounces` reflections
        vec3 sky{0};              // nits, straight from the sky, weighed against drawing it
    };
    struct Ray {
        vec3 origin, direction;
    };
    // A ray on its way to the surface that scatters its light.
    struct Flight {
        Ray ray;
        vec3 throughput{1};
        std::uint32_t medium = kAir;
        // It met the boundary of a volume: what it finds cannot be drawn from where it began.
        bool bent = false;
        bool straight = false;  // it went through a thin wall, straight on
        int boundaries = 0;
    };

    // What comes along the lanes' rays; `path` is the number of their random numbers' path. The number of
    // rays.
    std::uint64_t incoming(PathLanes& paths, std::uint32_t path, std::span<Incoming> results,
                           PathListener* listener = nullptr) const;
    // Moves each path along its ray to the surface it meets, and adds what that emits. Paths that end are
    // taken out.
    void follow(PathLanes& paths, MaterialLanes& materials, std::uint32_t path, int reflections,
                std::span<Incoming> results, PathListener* listener) const;
    // Takes out paths that go nowhere, and those that Russian roulette ends.
    void end_paths(PathLanes& paths, std::uint32_t dimension, int reflections) const;
    // Direct light at the paths' surfaces, times throughput, to the results. The number of shadow rays.
    std::size_t gather_lights(const PathLanes& paths, const MaterialLanes& materials, LightLanes& lights,
                              std::uint32_t path, int reflections, std::span<Incoming> results,
                              PathListener* listener) const;

    // A place of the sky for each path.
    void draw_sky(const PathLanes& paths, std::uint32_t dimension, EmitterLanes& drawn) const;

    // The parts of no more than kLanes samples.
    void add_indirect(std::span<const SampleStart> starts, std::span<PathSample> results) const;
    void add_full_radiance(std::span<const SampleStart> starts, std::span<PathSample> results) const;

    // Direct light that `scattering` reflects at a surface, by drawing lights. MIS weights against
    // scattering.density() where that finds lights too.
    vec3 draw_lights(const SurfaceHit& hit, const Bsdf& scattering, const RandomNumbers& random,
                     std::uint32_t dimension, std::uint32_t medium) const;

    // Light that a surface reflects to where it is seen from: by drawing lights, and along one ray what comes
    // in times `weight`.
    struct Shaded {
        vec3 drawn{0};
        Ray ray{};
        vec3 weight{0};  // 0: no ray
        float density = 0;
    };
    Shaded shade(const SurfaceHit& hit, const vec3& towards, const SurfaceMaterial& material,
                 std::uint32_t medium, const RandomNumbers& random) const;
    vec3 direct(const SurfaceHit& hit, const vec3& towards, const SurfaceMaterial& material,
                const RandomNumbers& random) const;
    // Light of the sky that reaches a start, by drawing it: over pi, as what comes along a ray. The number of
    // shadow rays.
    std::uint64_t add_sky(const IrradianceStart& start, int sample, vec3& result,
                          PathListener* listener) const;
    // The surface that a camera ray shows, by chance one of the see-through ones before the first; if none of
    // those, and `first` is to be seen, nothing is changed.
    struct Shown {
        bool missed = false;
        bool layer = false;  // else the solid one behind all layers
        SurfaceHit hit;
        Flight flight;
    };
    Shown shown(const CameraRay& ray, const RandomNumbers& random) const;
    Bsdf bsdf_at(const SurfaceHit& hit, const SurfaceMaterial& material, const vec3& towards) const;
    SurfaceMaterial material_at(const SurfaceHit& hit) const;
    vec3 emission(const SurfaceHit& hit) const;
    vec3 composed_radiance(const SampleStart& start, const PathSample& so_far) const;

    // The next surface that neither lets the light go straight on nor sends it on as the boundary of a
    // volume; throughput takes in those that did, and the chance of it. `distance`: of the flight's last ray.
    bool next_surface(Flight& flight, const RandomNumbers& random, std::uint32_t dimension, SurfaceHit& hit,
                      float& distance) const;
    bool bounds_volume(const SurfaceHit& hit) const;
    // At the boundary of a volume: on, through it or reflected; false: ends at the opaque part of the
    // surface. `vertex`: the random numbers' dimension where the flight began.
    bool pass_boundary(Flight& flight, const SurfaceHit& hit, const RandomNumbers& random,
                       std::uint32_t vertex) const;
    // What is left of light after that way in a medium (Beer 1852).
    vec3 attenuation(std::uint32_t medium, float metres) const;
    // The volume that a point lies in, by what is above it.
    std::uint32_t medium_at(const vec3& point) const;
    // Share of light that gets from the start of a shadow ray to its end.
    vec3 transmittance(const vec3& from, const vec3& span, bool to_infinity) const;
    // Russian roulette: true with the chance that `throughput` is then divided by.
    bool survives(const RandomNumbers& random, std::uint32_t dimension, vec3& throughput,
                  int reflections) const;
    bool reflects(const SurfaceHit& hit) const;
    // Whether light that `flight` brings makes caustics: by its way, or by the surface that sends it (null:
    // none).
    bool makes_caustics(const Flight& flight, const SurfaceHit* hit) const;
    // The nearest surface beyond `nearest`; of two sheets in one place the one that faces the ray.
    bool meets(const Ray& ray, float nearest, SurfaceHit& hit) const;
    int bounce_limit() const;
    bool is_left_out(const SurfaceHit& hit) const { return !left_out_.empty() && left_out_[hit.instance]; }
    // Shadow rays need more than whether they meet anything.
    bool looks_through() const { return sees_through_ || !left_out_.empty(); }

    const TraceScene& scene_;
    const MaterialTable& materials_;
    const Emitters& emitters_;
    const PunctualLights& lights_;
    const SkyLight& sky_;
    PathSettings settings_;
    Blended blended_;
    bool sees_through_ = false;   // some surface lets light go straight on
    bool volumes_ = false;        // some surface bounds a volume
    std::vector<bool> left_out_;  // by instance; empty: none is
    std::uint32_t camera_medium_ = kAir;
};

}  // namespace lanthorn::reference
