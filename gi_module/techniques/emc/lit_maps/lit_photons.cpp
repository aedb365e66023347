#include "gi_module/techniques/emc/lit_maps/lit_photons.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

// Photons under a kernel: fewer are noise, more are blur.
constexpr float kEnough = 16;
// Under the widest: what fewer are likely to land under is told by what lies around, more the fewer they are.
constexpr float kFew = 0.5f;
// A surface that has moved by less than so much of a coarse texel's width is the one that was there.
constexpr float kReach = 0.3f;
constexpr int kMostPhotons = 4'000'000;
// Of endless bounces, what keeps light from growing for ever; as LitMaps has it.
constexpr float kMostKept = 0.95f;
// Sums are counted in so many units of all there is.
constexpr double kUnits = 17'592'186'044'416.0;  // 2^44
// A change of the lamps' flux, of what it was, after which nothing that is remembered is worth anything.
constexpr double kFluxStep = 0.1;
constexpr dvec3 kLuminance(0.2126, 0.7152, 0.0722);

double square(double x) {
    return std::max(x * x, 1e-30);
}

double known(double x) {
    return std::isfinite(x) && x > 0 ? x : 0;
}

// Middle of what shines, by flux.
vec3 middle_of(std::span<const render::EmissiveTriangleData> triangles) {
    vec3 sum(0);
    float flux = 0;
    for (const render::EmissiveTriangleData& t : triangles) {
        sum += (vec3(t.p0) + vec3(t.p1) + vec3(t.p2)) * (t.p2.w / 3);
        flux += t.p2.w;
    }
    return flux > 0 ? sum / flux : vec3(0);
}

// Units of a number of which `all` is the whole.
double units(double all) {
    return all > 0 ? kUnits / all : 0;
}

}  // namespace

void LitPhotons::build_programs() {
    if (homes_program_) {
        return;
    }
    const auto load = [](const char* name, const char* beside = "BESIDE 0") {
        return gpu::Program({std::string("gi_module/techniques/emc/lit_maps/lit_photon_") + name + ".comp"},
                            {"MAX_MAPS " + std::to_string(kMaxMaps), beside});
    };
    homes_program_ = load("homes");
    beside_ = load("homes", "BESIDE 1");
    areas_program_ = load("areas");
    support_ = load("support");
    splat_ = load("splat");
    rest_program_ = load("rest");
    mean_ = load("mean");
    links_program_ = load("links");
    widen_ = load("widen");
    light_ = load("light");
    rest_ = gpu::Buffer::from(std::vector<vec4>{vec4(1)});
}

void LitPhotons::resize(const Texels& at) {
    const int places = at.texels.faces() * at.lists.resolution() * at.lists.resolution();
    if (places == places_ && at.texels.places() == lit_places_) {
        return;
    }
    places_ = places;
    lit_places_ = at.texels.places();
    const auto n = static_cast<std::size_t>(places);
    const auto lit_places = static_cast<std::size_t>(lit_places_);
    homes_ = gpu::Buffer(lit_places * sizeof(std::uint32_t));
    beside_list_.resize(lit_places);
    parts_ = gpu::Buffer(lit_places * sizeof(vec4));
    areas_ = gpu::Buffer(n * 2 * sizeof(std::uint32_t));
    powers_ = gpu::Buffer(n * 6 * sizeof(std::uint32_t));
    seen_ = gpu::Buffer(n * sizeof(vec4));
    age_ = gpu::Buffer(n * sizeof(float));
    links_ = gpu::Buffer(n * sizeof(std::uint32_t));
    for (gpu::Buffer& kernel : kernels_) {
        kernel = gpu::Buffer(n * sizeof(vec4));
    }
    irradiance_ = gpu::Buffer(n * sizeof(vec4));
    forget();
}

void LitPhotons::look(const Texels& at, const GiSettings& settings, const FrameScene& scene, bool all) {
    build_programs();
    resize(at);
    if (all) {
        homes_.clear();
        areas_.clear();
    }
    local_length_ = std::max(at.maps.extent(scene), 1e-30f);
    const double counted_in = std::exchange(area_, square(static_cast<double>(local_length_)));
    find_homes(at, settings, scene, all);
    link(at, settings, scene, all);
    measure(at, settings, scene);
    if (!all && area_ != counted_in) {
        areas_.clear();
        support_.use();
        homes_view_.bind(0, homes_, GL_R32UI);
        parts_view_.bind(1, parts_, GL_RGBA32F);
        support_.set("homes", 0);
        support_.set("parts", 1);
        support_.set("units", static_cast<float>(units(area_)));
        areas_.bind_storage(5);
        at.lists.lit().bind_storage(6);
        at.lists.lit().dispatch();
        wait_for_shaders();
    }
}

void LitPhotons::find_homes(const Texels& at, const GiSettings& settings, const FrameScene& scene, bool all) {
    beside_list_.clear();
    for (const bool beside : {false, true}) {
        const gpu::Program& program = beside ? beside_ : homes_program_;
        program.use();
        at.maps.bind(program, 0, 1, settings, scene);
        at.texels.bind(program, lit_points_view_, 2);
        index_view_.bind(3, at.lists.index(), GL_R32UI);
        points_view_.bind(4, at.lists.coarse().points(), GL_RGBA32F);
        parts_view_.bind(5, parts_, GL_RGBA32F);
        program.set("coarse_index", 3);
        program.set("coarse_points", 4);
        program.set("parts", 5);
        program.set("coarse_resolution", at.lists.resolution());
        program.set("units", static_cast<float>(units(area_)));
        homes_.bind_storage(4);
        areas_.bind_storage(5);
        const EntryList& list = beside ? beside_list_ : at.lists.around();
        list.bind_storage(6);
        beside_list_.bind_storage(7);
        if (!beside) {
            program.set("blocks", all ? static_cast<unsigned>(at.texels.blocks()) : 0u);
        }
        if (all && !beside) {
            dispatch_items(at.texels.places());
        } else {
            list.dispatch();
        }
        wait_for_shaders();
    }
}

void LitPhotons::link(const Texels& at, const GiSettings& settings, const FrameScene& scene, bool all) {
    links_program_.use();
    at.maps.bind(links_program_, 0, 1, settings, scene);
    index_view_.bind(3, at.lists.index(), GL_R32UI);
    points_view_.bind(4, at.lists.coarse().points(), GL_RGBA32F);
    links_program_.set("coarse_index", 3);
    links_program_.set("coarse_points", 4);
    links_program_.set("coarse_resolution", at.lists.resolution());
    links_program_.set("places", all ? static_cast<unsigned>(places_) : 0u);
    seen_.bind_storage(1);
    links_.bind_storage(4);
    at.lists.reached().bind_storage(6);
    if (all) {
        dispatch_items(places_);
    } else {
        at.lists.reached().dispatch();
    }
    wait_for_shaders();
}

void LitPhotons::measure(const Texels& at, const GiSettings& settings, const FrameScene& scene) {
    areas_program_.use();
    at.maps.bind(areas_program_, 0, 1, settings, scene);
    at.texels.bind(areas_program_, lit_points_view_, 2);
    homes_view_.bind(3, homes_, GL_R32UI);
    areas_program_.set("homes", 3);
    areas_program_.set("units", static_cast<float>(units(area_)));
    parts_.bind_storage(4);
    areas_.bind_storage(5);
    at.texels.looked_at().bind_storage(6);
    at.texels.looked_at().dispatch();
    wait_for_shaders();
}

void LitPhotons::trace(const Texels& at, const render::LightInputs& inputs, const GiSettings& settings,
                       int bounces, bool endless, bool changed, bool looked, const gpu::Buffer* first_of) {
    follow_lamps(inputs, at.maps);
    if (looked && !changed) {
        in_mean_.make_room();
    }
    const auto frame = in_mean_.next({changed, changed && inputs.scene.changes.geometry, drift_});
    if (!frame) {
        return;
    }
    GiSettings of_photons = settings;
    const int a_frame = settings.of<EmcSettings>().gather_photons;
    of_photons.photons = std::min(frame->times * a_frame, kMostPhotons);
    tracing_.trace(
        inputs, at.maps, of_photons, bounces, area_, frame->pass,  // no bandwidth counts
        {.sky = false, .room = std::min(PhotonMean::kFirst * a_frame, kMostPhotons), .first_of = first_of});
    count(at, inputs, of_photons, bounces, endless, first_of != nullptr);
    add_to_mean(at, settings, inputs.scene, *frame);
    widen(at, a_frame);
}

// Where light of the frame before is still worth something, it is as much brighter as the lamps are now.
void LitPhotons::follow_lamps(const render::LightInputs& inputs, const EnvironmentMaps& maps) {
    const auto lamps = inputs.light_maps.light_data().first(inputs.scene.lights.size());
    const vec3 middle = middle_of(inputs.emissive.triangles());
    dvec3 flux = flux_about(inputs.emissive, maps.surroundings());
    drift_ = glm::distance(middle, middle_) / local_length_;
    middle_ = middle;
    bool others = lamps.size() != lamps_.size();
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        const dvec3 sent = emitted_flux(inputs.scene.lights[i].light, lamps[i].extent);
        flux += sent;
        if (!others) {
            const render::LightData& before = lamps_[i];
            others = before.type != lamps[i].type || before.id != lamps[i].id;
            drift_ = std::max({drift_, glm::distance(before.position, lamps[i].position) / local_length_,
                               glm::distance(before.direction, lamps[i].direction)});
        }
    }
    flux = dvec3(known(flux.r), known(flux.g), known(flux.b));
    const double now = glm::dot(flux, kLuminance), before = glm::dot(flux_, kLuminance);
    others = others || std::abs(now - before) > kFluxStep * before;
    if (others) {
        in_mean_.begin();
    }
    for (int c = 0; c < 3; ++c) {
        scale_[c] = flux_[c] > 0 ? static_cast<float>(flux[c] / flux_[c]) : 1.0f;
    }
    flux_ = flux;
    lamps_.assign(lamps.begin(), lamps.end());
}

void LitPhotons::count(const Texels& at, const render::LightInputs& inputs, const GiSettings& settings,
                       int bounces, bool endless, bool first) {
    const PhotonSet& photons = tracing_.arrived();
    const int last = (bounces - 1) * settings.photons;
    const int all = (bounces + (first ? 1 : 0)) * settings.photons;
    const bool goes_on = endless && bounces > 1;
    if (goes_on) {
        rest_program_.use();
        hits_view_.bind(2, photons.hits, GL_RGBA32F);
        rest_program_.set("photon_hits", 2);
        rest_program_.set("photons", settings.photons);
        rest_program_.set("last_bounce", last);
        rest_program_.set("most_kept", kMostKept);
        rest_.bind_storage(5);
        glDispatchCompute(1, 1, 1);
        wait_for_shaders();
    }
    splat_.use();
    at.maps.bind(splat_, 0, 1, settings, inputs.scene);
    at.texels.bind(splat_, lit_points_view_, 2);
    homes_view_.bind(3, homes_, GL_R32UI);
    hits_view_.bind(4, photons.hits, GL_RGBA32F);
    rest_view_.bind(5, rest_, GL_RGBA32F);
    splat_.set("homes", 3);
    splat_.set("photon_hits", 4);
    splat_.set("rest", 5);
    splat_.set("units", vec3(units(flux_.r), units(flux_.g), units(flux_.b)));
    splat_.set("photons", all);
    splat_.set("last_bounce", goes_on ? last : all);
    splat_.set("first_arrival", bounces * settings.photons);
    powers_.bind_storage(5);
    photons.count.bind_storage(6);
    dispatch_items(all);
    wait_for_shaders();
}

void LitPhotons::add_to_mean(const Texels& at, const GiSettings& settings, const FrameScene& scene,
                             const PhotonMean::Frame& frame) {
    mean_.use();
    at.maps.bind(mean_, 6, 7, settings, scene);
    mean_.set("coarse_resolution", at.lists.resolution());
    mean_.set("reach", kReach);
    points_view_.bind(0, at.lists.coarse().points(), GL_RGBA32F);
    areas_view_.bind(1, areas_, GL_R32UI);
    mean_.set("coarse_points", 0);
    mean_.set("areas", 1);
    mean_.set("power_unit", vec3(flux_ / kUnits));
    mean_.set("area_unit", static_cast<float>(area_ / kUnits));
    mean_.set("scale", scale_);
    mean_.set("most_units", static_cast<float>(frame.held));
    mean_.set("times", static_cast<float>(frame.times));
    at.lists.coarse().bind_storage();
    seen_.bind_storage(1);
    kernels_[0].bind_storage(2);
    age_.bind_storage(4);
    powers_.bind_storage(5);
    at.lists.coarse().dispatch();
    wait_for_shaders();
}

void LitPhotons::widen(const Texels& at, int photons) {
    widen_.use();
    at.lists.coarse().bind_storage();
    links_view_.bind(4, links_, GL_R32UI);
    widen_.set("links", 4);
    widen_.set("coarse_resolution", at.lists.resolution());
    for (int level = 1; level < 4; ++level) {
        kernel_views_[level - 1].bind(static_cast<GLuint>(level - 1), kernels_[level - 1], GL_RGBA32F);
        widen_.set("narrower", level - 1);
        widen_.set("level", level);
        kernels_[level].bind_storage(4);
        at.lists.coarse().dispatch();
        wait_for_shaders();
    }
    light_.use();
    const char* const names[] = {"kernel_0", "kernel_1", "kernel_2", "kernel_3"};
    for (int level = 0; level < 4; ++level) {
        kernel_views_[level].bind(static_cast<GLuint>(level), kernels_[level], GL_RGBA32F);
        light_.set(names[level], level);
    }
    const double flux = glm::dot(flux_, kLuminance);
    const double all = static_cast<double>(photons) * in_mean_.units();  // in the mean
    light_.set("photons", vec3(kLuminance * (flux > 0 ? all / flux : 0)));
    light_.set("enough", kEnough);
    light_.set("few", kFew);
    index_view_.bind(4, at.lists.index(), GL_R32UI);
    points_view_.bind(5, at.lists.coarse().points(), GL_RGBA32F);
    light_.set("coarse_index", 4);
    light_.set("coarse_points", 5);
    light_.set("coarse_resolution", at.lists.resolution());
    irradiance_.bind_storage(4);
    at.lists.coarse().dispatch();
    wait_for_shaders();
}

std::size_t LitPhotons::bytes() const {
    std::size_t sum = homes_.bytes() + beside_list_.bytes() + parts_.bytes() + areas_.bytes() +
                      powers_.bytes() + seen_.bytes() + age_.bytes() + links_.bytes() + irradiance_.bytes();
    for (const gpu::Buffer& kernel : kernels_) {
        sum += kernel.bytes();
    }
    return sum;
}

}  // namespace lanthorn::gi
