#include "gi_module/techniques/emc/photons/photon_tracing.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "gi_module/techniques/emc/splat/accumulation.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

constexpr vec2 kPdfRange(0.5f, 2.0f);  // clamp of p = cos / d^2 over its mean (sec. 6): h varies 1 : 2

// Radius of the average photon's splat, metres: C0 sqrt(A / N) of sec. 6. With a constant C0 every splat
// holds as many photons however many there are, and noise never falls: from `kPhotons` on, C0 ~ N^(1/5). That
// lies between the powers with which squared error falls fastest: 1/3 where light is smooth (h ~ N^(-1/6);
// Silverman 1986, Density Estimation, sec. 4.3), 1/6 across its edges, where squared bias grows as h. `c0` is
// C0 of fewer photons.
double splat_radius(double c0, double area, int photons) {
    constexpr double kPhotons = 20'000;
    return c0 * std::pow(std::max(photons / kPhotons, 1.0), 0.2) * std::sqrt(area / photons);
}

constexpr std::size_t kEmissivePlace = 0x10000;  // of all emissive triangles, after any light
constexpr std::size_t kSkyPlace = 0x20000;

// Where the photons of the scene's light number `place` begin in the sequences of random numbers. Lights that
// do not shine count, too: whatever becomes of the others, a light's photons fly as before.
std::int32_t key_of(std::size_t place) {
    auto x = static_cast<std::uint32_t>(place) * 0x9e3779b9u;  // PCG-RXS-M-XS without increment, O'Neill 2014
    x = ((x >> ((x >> 28) + 4)) ^ x) * 277803737u;
    return static_cast<std::int32_t>((x >> 22) ^ x);
}

}  // namespace

dvec3 emitted_flux(const Light& light, double extent) {
    using std::numbers::pi;
    const dvec3 intensity = dvec3(light.colour) * static_cast<double>(light.intensity);
    switch (light.type) {
        case LightType::point:
            return intensity * (4 * pi);
        case LightType::directional:
            return intensity * (pi * extent * extent);
        case LightType::spot: {
            // Simpson's rule over the cosine; attenuation as KHR_lights_punctual words it.
            const double outer = std::cos(light.outer_cone);
            const double inner = std::cos(light.inner_cone);
            const double scale = 1.0 / std::max(0.001, inner - outer);
            constexpr int kSteps = 512;
            double sum = 0;
            for (int i = 0; i <= kSteps; ++i) {
                const double z = outer + (1 - outer) * i / kSteps;
                const double a = std::clamp((z - outer) * scale, 0.0, 1.0);
                sum += a * a * (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2);
            }
            return intensity * (2 * pi * sum * (1 - outer) / (3.0 * kSteps));
        }
    }
    return dvec3(0);
}

dvec3 flux_about(const render::EmissiveTriangles& emissive, const Aabb& surroundings) {
    const dvec3 all(emissive.flux());
    if (surroundings.empty()) {
        return all;
    }
    const vec3 middle = surroundings.centre();
    const float radius = 0.5f * surroundings.diagonal();
    double sent = 0, about = 0;
    for (const render::EmissiveTriangleData& t : emissive.triangles()) {
        const float d = glm::distance(middle, (vec3(t.p0) + vec3(t.p1) + vec3(t.p2)) / 3.0f);
        const double share = d > 2 * radius ? static_cast<double>(radius / d) : 1.0;
        sent += static_cast<double>(t.p2.w);
        about += share * share * static_cast<double>(t.p2.w);
    }
    return sent > 0 ? all * (about / sent) : all;
}

PhotonTracing::PhotonTracing() : bad_values_(gpu::Buffer::from(std::vector<std::uint32_t>{0})) {}

std::uint32_t PhotonTracing::bad_value_count() const {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    return bad_values_.read<std::uint32_t>(1).front();
}

void PhotonTracing::build_programs(Search search, bool directions) {
    const std::string kept = std::string("DIRECTIONS ") + (directions ? "1" : "0");
    const std::string secant = std::string("SEARCH_SECANT ") + (search == Search::secant ? "1" : "0");
    const auto emission = [&](const char* emissive, const char* sky, const char* first) {
        return gpu::Program({"gi_module/techniques/emc/photons/emission.comp"},
                            {secant, kept, emissive, sky, first});
    };
    emission_ = emission("EMISSIVE 1", "SKY 0", "FIRST 0");
    emission_punctual_ = emission("EMISSIVE 0", "SKY 0", "FIRST 0");
    emission_sky_ = emission("EMISSIVE 1", "SKY 1", "FIRST 0");
    emission_first_ = emission("EMISSIVE 1", "SKY 0", "FIRST 1");
    bounce_ = gpu::Program({"gi_module/techniques/emc/photons/bounce.comp"}, {secant, kept, "ONE_MAP 0"});
    bounce_one_map_ = gpu::Program({"gi_module/techniques/emc/photons/bounce.comp"}, {kept, "ONE_MAP 1"});
    search_ = search;
    directions_kept_ = directions;
}

// Splits the photons over the lights by flux, every light that shines at least one. Returns the number of
// sources.
int PhotonTracing::describe_sources(const render::LightInputs& inputs, const Aabb& surroundings, int photons,
                                    bool sky) {
    struct Source {
        int light;
        std::int32_t key;
        dvec3 flux;
    };
    std::vector<Source> sources;
    for (std::size_t i = 0; i < inputs.scene.lights.size(); ++i) {
        const dvec3 flux =
            emitted_flux(inputs.scene.lights[i].light, inputs.light_maps.light_data()[i].extent);
        if (luminance(flux) > 0) {
            sources.push_back({static_cast<int>(i), key_of(i), flux});
        }
    }
    if (inputs.emissive.count() > 0) {
        sources.push_back({-1, key_of(inputs.scene.lights.empty() ? 0 : kEmissivePlace),
                           flux_about(inputs.emissive, surroundings)});
    }
    sky_.follow(inputs.scene);
    if (sky && luminance(sky_.flux()) > 0) {
        sources.push_back({-2, key_of(kSkyPlace), sky_.flux()});
    }
    double total = 0;
    flux_emitted_ = dvec3(0);
    if (sources.empty()) {
        return 0;
    }
    for (const Source& s : sources) {
        total += luminance(s.flux);
        flux_emitted_ += s.light == -1 ? dvec3(inputs.emissive.flux()) : s.flux;
    }
    std::vector<glm::ivec4> described;
    double cumulative = 0;
    int first = 0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        cumulative += luminance(sources[i].flux) / total;
        const int left = static_cast<int>(sources.size() - 1 - i);  // each of the rest gets one at least
        const int end = i + 1 == sources.size()
                            ? photons
                            : std::clamp(static_cast<int>(std::lround(cumulative * photons)), first + 1,
                                         std::max(photons - left, first + 1));
        described.emplace_back(first, end - first, sources[i].light, sources[i].key);
        first = end;
        if (first >= photons) {
            break;
        }
    }
    sources_.hold(std::span<const glm::ivec4>(described));
    return static_cast<int>(described.size());
}

void PhotonTracing::trace(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                          const GiSettings& settings, int bounces, double total_area, int pass,
                          const Share& share) {
    if (!emission_ || settings.of<EmcSettings>().search != search_ ||
        directions_wanted_ != directions_kept_) {
        build_programs(settings.of<EmcSettings>().search, directions_wanted_);
    }
    const bool sky = share.sky && inputs.scene.sky.has_value();
    const bool first = share.first_of != nullptr;
    const int rows = bounces + (sky || first ? 1 : 0);
    const int room = std::max(share.room, settings.photons);
    int held = photons_ * rows_;
    if (room != room_ || rows != rows_) {
        room_ = room;
        rays_ = gpu::Buffer(sizeof(PhotonRay) * static_cast<std::size_t>(room));
        held = room * rows;
        arrived_.allocate(held);
        rounds_.resize(static_cast<std::size_t>(room));
    }
    if (!directions_kept_) {
        arrived_.directions = gpu::Buffer();
    } else if (!arrived_.directions) {
        arrived_.directions =
            gpu::Buffer(sizeof(std::uint32_t) * static_cast<std::size_t>(arrived_.capacity));
    }
    photons_ = settings.photons;
    bounces_ = bounces;
    rows_ = rows;
    first_are_skys_ = sky;
    if (held != photons_ * rows_) {
        arrived_.hold(photons_ * rows_);
    }
    const auto bandwidth =
        static_cast<float>(splat_radius(settings.of<EmcSettings>().splat_c0, total_area, photons_)) *
        pass_radius(pass);
    const bool fixed = settings.of<EmcSettings>().splat_bandwidth == Bandwidth::fixed;
    arrived_.h_fixed = bandwidth;
    arrived_.h_max = fixed ? bandwidth : bandwidth / std::sqrt(kPdfRange.x);
    inputs.gpu_scene.bind_materials();

    {
        const gpu::PassTimer::Scope scope(inputs.timer, "emission");
        const int sources = describe_sources(inputs, maps.surroundings(), photons_, sky);
        emitted_ = sources > 0 ? photons_ : 0;
        if (emitted_ == 0) {  // a black sky alone
            arrived_.hits.clear();
            return;
        }
        const bool by_sky = sky && luminance(sky_.flux()) > 0;
        if (rows_ > bounces_ && !by_sky && !first) {
            arrived_.hits.clear();  // the sky's row
        }
        const gpu::Program& emission = by_sky                        ? emission_sky_
                                       : first                       ? emission_first_
                                       : inputs.emissive.count() > 0 ? emission_
                                                                     : emission_punctual_;
        emission.use();
        maps.bind(emission, 0, 1, settings, inputs.scene);
        const bool punctual = static_cast<bool>(inputs.light_maps.distance());
        if (!punctual && !no_light_map_) {
            no_light_map_ = gpu::Texture::make_2d_array(GL_R32F, ivec2(1), 1);
        }
        (punctual ? inputs.light_maps.distance() : no_light_map_).bind(2);
        (punctual ? inputs.light_maps.normals() : no_light_map_).bind(3);
        (punctual ? inputs.light_maps.albedo() : no_light_map_).bind(4);
        emission.set("light_distance", 2);
        emission.set("light_normals", 3);
        emission.set("light_albedo", 4);
        emission.set("photon_count", photons_);
        emission.set("source_count", sources);
        emission.set("emissive_count", inputs.emissive.count());
        emission.set("emissive_flux", static_cast<float>(luminance(dvec3(inputs.emissive.flux()))));
        const Aabb& about = maps.surroundings();
        emission.set("surroundings", about.empty() ? vec4(0) : vec4(about.centre(), 0.5f * about.diagonal()));
        emission.set("seed", settings.seed);
        emission.set("pass_index", static_cast<std::uint32_t>(pass));
        rays_.bind_storage(0);
        inputs.light_maps.lights().bind_storage(render::kLightsBinding);
        inputs.emissive.buffer().bind_storage(render::kEmissiveBinding);
        sources_view_.bind(5, sources_.buffer(), GL_RGBA32I);
        emission.set("sources", 5);
        bad_values_.bind_storage(5);
        if (by_sky || first) {
            emission.set("first_arrival", photons_ * bounces_);
            emission.set("bandwidth", bandwidth);
            arrived_.hits.bind_storage(1);
            if (directions_kept_) {
                arrived_.directions.bind_storage(8);
            }
        }
        if (by_sky) {
            sky_.bind(emission, 6);
        } else if (first) {
            share.first_of->bind_storage(7);
        }
        emission.dispatch(photons_, 64);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "bounces");
    const auto prepare = [&](const gpu::Program& program, int bounce) {
        program.use();
        maps.bind(program, 0, 1, settings, inputs.scene);
        program.set("photon_count", photons_);
        program.set("seed", settings.seed);
        program.set("bandwidth", bandwidth);
        program.set("bandwidth_fixed", fixed ? 1 : 0);
        program.set("pdf_range", kPdfRange);
        program.set("total_area", static_cast<float>(total_area));
        program.set("bounce", bounce);
    };
    rays_.bind_storage(0);
    arrived_.hits.bind_storage(1);
    if (directions_kept_) {
        arrived_.directions.bind_storage(8);
    }
    bad_values_.bind_storage(5);
    for (int b = 1; b <= bounces; ++b) {
        rounds_.run(
            bounce_one_map_, bounce_, settings, [&](const gpu::Program& program) { prepare(program, b); },
            [&](const gpu::Program& program) { program.dispatch(photons_, 64); });
    }
}

PhotonStatistics PhotonTracing::statistics() const {
    PhotonStatistics result;
    if (emitted_ == 0) {
        return result;
    }
    result.emitted = static_cast<std::uint64_t>(emitted_);
    result.flux_emitted = flux_emitted_;
    result.flux_stored.assign(static_cast<std::size_t>(bounces_), dvec3(0));
    const std::vector<PhotonHit> hits = arrived_.read();
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].radius > 0) {
            ++result.stored;
            const std::size_t row = i / static_cast<std::size_t>(photons_);
            if (row < result.flux_stored.size()) {
                result.flux_stored[row] += dvec3(hits[i].power);
            } else if (first_are_skys_) {
                result.flux_from_sky += dvec3(hits[i].power);
            }
        }
    }
    const auto rays = rays_.read<PhotonRay>(static_cast<std::size_t>(photons_));
    result.lost = static_cast<std::uint64_t>(
        std::ranges::count_if(rays, [](const PhotonRay& r) { return r.direction.w <= 0; }));
    return result;
}

}  // namespace lanthorn::gi
