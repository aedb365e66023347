#include "gi_module/techniques/emc/lit_maps/lit_maps.h"

#include <algorithm>
#include <utility>

#include "gi_module/techniques/emc/faster.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr int kTexelRays = 2;  // a texel of E1 and frame
// Of a light's map, that a shadow may reach beyond what throws it (shadow.glsl): filter, and lifted points.
constexpr float kShadowTexels = 6;
// Of endless bounces: those that the first frame begins with, and what keeps light from growing for ever.
constexpr int kFirstSweeps = 3;
constexpr float kMostAlbedo = 0.95f;

}  // namespace

void LitMaps::build_programs() {
    if (!filter_program_) {
        filter_program_ = gpu::Program({"gi_module/techniques/emc/lit_maps/lit_coarse_filter.comp"});
        reflect_program_ =
            gpu::Program({"gi_module/techniques/emc/lit_maps/lit_reflect.comp"}, {"AT_RIMS 0"});
        rims_program_ = gpu::Program({"gi_module/techniques/emc/lit_maps/lit_reflect.comp"}, {"AT_RIMS 1"});
        add_sky_ = gpu::Program({"gi_module/techniques/emc/lit_maps/lit_add_sky.comp"});
    }
}

void LitMaps::update(const render::LightInputs& inputs, const EnvironmentMaps& maps, const SweptBoxes& movers,
                     ExactRays* exact, const GiSettings& settings, int bounces, const LitWork& work,
                     const Found& found, const gpu::Buffer& bad_values) {
    build_programs();
    RayScene rays{maps, texels_, movers, exact, settings, inputs.scene, inputs.timer};
    inputs.gpu_scene.bind_materials();
    const bool look_all = work.look_all || (found.other_maps && found.exchanged.x < 0);
    bool all_are_new = false;
    const bool with_photons = work.photon_bounces > 0 || work.sky_apart;  // lamps may come
    if (work.look || (with_photons && !photons_follow_)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_texels");
        all_are_new = look(maps, settings, inputs.scene, movers,
                           look_all || (with_photons && !photons_follow_), found.exchanged);
        lists_.follow(texels_, maps, settings, inputs.scene, all_are_new, kTexelRays);
        if (with_photons) {
            photons_.look({maps, texels_, lists_}, settings, inputs.scene, all_are_new);
        }
        photons_follow_ = with_photons;
    }
    if (work.recolour && !all_are_new) {
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_texels");
        texels_.recolour(maps, settings, inputs.scene, lists_.lit());
    }
    const bool endless = settings.of<EmcSettings>().gather_endless, sky = inputs.scene.sky.has_value();
    const bool had_indirect = std::exchange(has_indirect_, bounces > 1 || sky);
    if (had_indirect != has_indirect_) {
        carry_close();
    }
    const bool other_sky = follow_sky(inputs.scene, work.sky_apart);
    if (work.forget) {
        hits_.forget();
        photons_.forget();
    }
    if (work.from_dark || work.new_photons || work.photon_bounces == 0) {
        photons_.forget();
    }
    radiosity_holds_ = radiosity_holds_ && !work.forget && !work.from_dark;
    if (found.compare && exact != nullptr) {
        rays.exact = nullptr;
        times_.maps = time_of(rays);
        rays.exact = exact;
        times_.exact = time_of(rays);
        rays.exact = times_.prefer_maps() ? nullptr : exact;
    }
    const bool by_photons = work.photon_bounces > 0;
    const bool other_lights =
        (work.light || work.look) && (by_photons ? wide_.follow(inputs, maps) : wide_.clear());
    if (work.light || other_lights) {
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_direct");
        light(inputs, maps, settings, movers, work.light_all || all_are_new || other_lights, work.look,
              bad_values);
    }
    if (!has_indirect_) {
        return;
    }
    if (by_photons) {
        if (work.trace) {
            const gpu::PassTimer::Scope scope(inputs.timer, "lit_photons");
            photons_.trace({maps, texels_, lists_}, inputs, settings, work.photon_bounces, endless,
                           work.other_light, work.look, wide_.any() ? &wide_.triangles() : nullptr);
        }
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_indirect");
        reflect(inputs, maps, settings, photons_.irradiance(), endless ? kMostAlbedo : 1, direct_,
                radiosity_);
    }
    if (by_photons && !work.sky_apart) {
        radiosity_holds_ = false;
        return;
    }
    const int keys = 6 * lists_.resolution() * lists_.resolution();
    for (const Returned& returned : found.returned) {
        hits_.put_back(keys * returned.slot, keys, *returned.rays);
    }
    if ((work.verify && !work.forget) || !found.returned.empty()) {
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_verify");
        hits_.verify(lists_.coarse(), rays, &lists_.index());
    }
    if (work.shoot) {
        const gpu::PassTimer::Scope scope(inputs.timer, "lit_rays");
        hits_.shoot(lists_.coarse(), rays);
        frames_ = std::min(frames_ + 1, RememberedHits::kFrames);
    }
    const gpu::PassTimer::Scope scope(inputs.timer, "lit_indirect");
    const bool goes_on = endless && radiosity_holds_;
    // Light of the sky has been reflected once less than that of lamps when it comes back to the texels.
    const bool from_sky = sky && (!endless || work.sky_apart);
    // Texels of another map begin with direct light alone.
    const bool exchanged = all_are_new || look_all || found.other_maps || work.recolour;
    const bool as_before = work.sky_apart && radiosity_holds_ && !endless && !exchanged && !other_sky &&
                           !work.look && !work.shoot;
    const int sweeps = as_before               ? 0
                       : goes_on && !exchanged ? 1
                       : endless               ? kFirstSweeps
                                               : bounces - (from_sky ? 0 : 1);
    const gpu::Buffer& reflected = work.sky_apart ? from_sky_ : radiosity_;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        const gpu::Buffer& before = sweep > 0 || goes_on ? reflected : from_sky ? sky_alone_ : first_;
        const gpu::Buffer& e1 = smooth(inputs, maps, settings, hits_.shade(lists_.coarse(), before));
        reflect(inputs, maps, settings, e1, endless ? kMostAlbedo : 1, work.sky_apart ? dark_ : direct_,
                reflected);
    }
    if (work.sky_apart) {
        add_sky(by_photons);
    }
    radiosity_holds_ = true;
}

void LitMaps::add_sky(bool lamps) {
    add_sky_.use();
    add_sky_.set("lamps", lamps ? 1 : 0);
    add_sky_.set("places", texels_.places());
    radiosity_.bind_storage(4);
    from_sky_.bind_storage(5);
    first_.bind_storage(6);
    dispatch_items(texels_.places());
    wait_for_shaders();
}

KeptRays LitMaps::kept_rays(int slot) const {
    const int keys = 6 * lists_.resolution() * lists_.resolution();
    return keys > 0 ? hits_.kept(keys * slot, keys) : KeptRays();
}

bool LitMaps::follow_sky(const FrameScene& scene, bool apart) {
    const std::size_t bytes = static_cast<std::size_t>(texels_.all_places()) * sizeof(vec4);
    const bool alone = scene.sky && sky_alone_.bytes() != bytes;
    if (alone) {
        sky_alone_ = gpu::Buffer(bytes);
    }
    const bool beside = apart && from_sky_.bytes() != bytes;
    if (beside) {
        from_sky_ = gpu::Buffer(bytes);
        dark_ = gpu::Buffer(bytes);
        radiosity_holds_ = false;
    }
    if (!alone && !beside && sky_holds_ && of_sky_ == scene.sky) {
        return false;
    }
    of_sky_ = scene.sky;
    sky_holds_ = true;
    const std::vector<vec4> cells = sky_radiosity(scene.sky);
    const std::size_t first = static_cast<std::size_t>(texels_.places()) * sizeof(vec4);
    for (gpu::Buffer* buffer : {&first_, &radiosity_}) {
        buffer->write(first, std::span<const vec4>(cells));
    }
    if (scene.sky) {
        sky_alone_.write(first, std::span<const vec4>(cells));
    }
    if (apart) {
        from_sky_.write(first, std::span<const vec4>(cells));
    }
    return true;
}

bool LitMaps::look(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene,
                   const SweptBoxes& movers, bool all, const ivec2& exchanged) {
    if (texels_.resize(maps, settings)) {
        const auto places = static_cast<std::size_t>(texels_.places());
        direct_ = gpu::Buffer(places * sizeof(vec4));
        const auto all_places = static_cast<std::size_t>(texels_.shaded_places());
        first_ = gpu::Buffer(all_places * sizeof(vec4));
        radiosity_ = gpu::Buffer(all_places * sizeof(vec4));
        sky_holds_ = false;
        relit_.resize(places);
        near_.resize(places);
        rims_.resize(places);
        radiosity_holds_ = false;
        all = true;
    }
    texels_.look(maps, settings, scene, movers, all, exchanged, radiosity_, first_);
    frames_ = 0;
    return all;
}

// From no memory, which is forgotten again; the second time, since programs are compiled when they run first.
double LitMaps::time_of(const RayScene& rays) {
    double time = 0;
    for (int run = 0; run < 2; ++run) {
        hits_.forget();
        time = 1e3 * seconds_of([&] { hits_.shoot(lists_.coarse(), rays); });
    }
    hits_.forget();
    return time;
}

const EntryList& LitMaps::list_relit(const render::LightInputs& inputs, const SweptBoxes& movers, bool all) {
    const std::span<const render::LightData> lights = inputs.light_maps.light_data();
    all = all || !std::ranges::equal(lights, lights_);
    lights_.assign(lights.begin(), lights.end());
    if (all) {
        return lists_.lit();
    }
    const float diagonal = inputs.scene.diagonal();
    std::vector<vec4> origins;
    for (const render::LightData& light : lights) {
        if (light.layers == 0 || light.shares_map != 0) {
            continue;
        }
        origins.push_back(light.type == render::kLightDirectional
                              ? vec4(-light.direction * diagonal, -kShadowTexels * light.texel)
                              : vec4(light.position, kShadowTexels * light.texel));
    }
    if (!light_origins_ || light_origins_.bytes() < origins.size() * sizeof(vec4)) {
        light_origins_ = gpu::Buffer(origins.size() * sizeof(vec4));
    }
    light_origins_.write(0, std::span<const vec4>(origins));
    relit_.clear();
    const gpu::Program& program = relit_programs_.use(movers.boxes(), 0);
    texels_.bind(program, lit_points_view_, 0);
    changed_view_.bind(1, texels_.changed(), GL_R32UI);
    light_origins_view_.bind(2, light_origins_, GL_RGBA32F);
    program.set("changed", 1);
    program.set("changed_blocks", texels_.changed_places());
    program.set("lights", 2);
    program.set("light_count", static_cast<int>(origins.size()));
    program.set("blocks", texels_.blocks());
    relit_.bind_storage(7);
    dispatch_items(texels_.blocks());
    wait_for_shaders();
    return relit_;
}

void LitMaps::light(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                    const GiSettings& settings, const SweptBoxes& movers, bool all, bool looked,
                    const gpu::Buffer& bad_values) {
    const EntryList& relit = list_relit(inputs, movers, all);
    if (wide_.sampled()) {
        if (whole_direct_.bytes() != direct_.bytes()) {
            whole_direct_ = gpu::Buffer(direct_.bytes());
        }
        shade(inputs, maps, settings, relit, false, looked, whole_direct_, bad_values);
    }
    shade(inputs, maps, settings, relit, true, looked, direct_, bad_values);
}

void LitMaps::shade(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                    const GiSettings& settings, const EntryList& relit, bool without_wide, bool looked,
                    const gpu::Buffer& direct, const gpu::Buffer& bad_values) {
    near_.clear();
    struct Step {
        render::LightPrograms& programs;
        const EntryList& list;
    };
    for (const Step& step : {Step{direct_programs_, relit}, Step{near_programs_, near_}}) {
        const gpu::Program& program = step.programs.bind(inputs.light_maps, 0);
        if (without_wide) {
            wide_.bind_other_lights(inputs.light_maps);
        }
        program.use();
        constexpr GLuint kFirst = 4;  // after the light maps
        maps.bind(program, kFirst + 3, kFirst + 4, settings, inputs.scene);
        texels_.bind(program, lit_points_view_, kFirst);
        albedo_view_.bind(kFirst + 1, texels_.albedo(), GL_RGBA32F);
        program.set("lit_albedo", static_cast<int>(kFirst + 1));
        changed_view_.bind(kFirst + 2, texels_.changed(), GL_R32UI);
        program.set("changed", static_cast<int>(kFirst + 2));
        program.set("looked", looked ? 1 : 0);
        radiosity_.bind_storage(3);
        direct.bind_storage(4);
        first_.bind_storage(5);
        step.list.bind_storage(6);
        near_.bind_storage(7);
        bad_values.bind_storage(1);
        step.list.dispatch();
        wait_for_shaders();
    }
}

void LitMaps::light_close(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                          const GiSettings& settings, const CloseHits& close, const gpu::Buffer& bad_values) {
    const gpu::Program& program = close_programs_.bind(inputs.light_maps, 0);
    wide_.bind_other_lights(inputs.light_maps);
    program.use();
    constexpr GLuint kFirst = 4;  // after the light maps
    maps.bind(program, kFirst + 4, kFirst + 5, settings, inputs.scene);
    texels_.bind(program, lit_points_view_, kFirst);
    albedo_view_.bind(kFirst + 1, texels_.albedo(), GL_RGBA32F);
    program.set("lit_albedo", static_cast<int>(kFirst + 1));
    close_points_view_.bind(kFirst + 2, close.points(), GL_RGBA32F);
    program.set("close_points", static_cast<int>(kFirst + 2));
    close_owners_view_.bind(kFirst + 3, close.owners(), GL_RG32UI);
    program.set("close_owners", static_cast<int>(kFirst + 3));
    inputs.light_maps.albedo().bind(kFirst + 6);
    program.set("light_map_albedo", static_cast<int>(kFirst + 6));
    program.set("close_first", close.first());
    program.set("close_fresh", close.of() == CloseHits::Of::every_hit ? 1 : 0);
    radiosity().bind_storage(3);
    first_.bind_storage(5);
    close.listed().bind_storage(6);
    bad_values.bind_storage(1);
    close.listed().dispatch();
    wait_for_shaders();
}

// To the other buffer: rays are guided by what close hits reflected in the frame before, which holds for the
// light that it was lit for and is nowhere else.
void LitMaps::carry_close() {
    const gpu::Buffer& before = has_indirect_ ? first_ : radiosity_;
    const auto first = static_cast<GLintptr>(static_cast<std::size_t>(texels_.all_places()) * sizeof(vec4));
    glCopyNamedBufferSubData(before.id(), radiosity().id(), first, first,
                             static_cast<GLsizeiptr>(CloseHits::kAllSlots * sizeof(vec4)));
}

void LitMaps::bind_coarse(const gpu::Program& program, const gpu::Buffer& irradiance) {
    index_view_.bind(2, lists_.index(), GL_R32UI);
    points_view_.bind(3, lists_.coarse().points(), GL_RGBA32F);
    irradiance_view_.bind(4, irradiance, GL_RGBA32F);
    program.set("coarse_index", 2);
    program.set("coarse_points", 3);
    program.set("coarse_irradiance", 4);
    program.set("coarse_resolution", lists_.resolution());
}

// Blur takes light from where there is much to where there is little, and more so with each bounce: it serves
// as long as rays are few, and less with each frame, so that the light takes no step.
const gpu::Buffer& LitMaps::smooth(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                                   const GiSettings& settings, const gpu::Buffer& irradiance) {
    if (frames_ >= RememberedHits::kFrames) {
        return irradiance;
    }
    filter_program_.use();
    maps.bind(filter_program_, 0, 1, settings, inputs.scene);
    bind_coarse(filter_program_, irradiance);
    filter_program_.set("share", static_cast<float>(RememberedHits::kFrames - std::max(frames_, 1)) /
                                     static_cast<float>(RememberedHits::kFrames - 1));
    if (filtered_.bytes() != irradiance.bytes()) {
        filtered_ = gpu::Buffer(irradiance.bytes());
    }
    lists_.coarse().bind_storage();
    filtered_.bind_storage(4);
    lists_.coarse().dispatch();
    wait_for_shaders();
    return filtered_;
}

void LitMaps::reflect(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                      const GiSettings& settings, const gpu::Buffer& irradiance, float most_albedo,
                      const gpu::Buffer& direct, const gpu::Buffer& reflected) {
    rims_.clear();
    const auto run = [&](const gpu::Program& program, const EntryList& list) {
        program.use();
        maps.bind(program, 0, 1, settings, inputs.scene);
        bind_coarse(program, irradiance);
        texels_.bind(program, lit_points_view_, 5);
        albedo_view_.bind(6, texels_.albedo(), GL_RGBA32F);
        direct_view_.bind(7, direct, GL_RGBA32F);
        program.set("lit_albedo", 6);
        program.set("lit_direct", 7);
        fits_view_.bind(8, lists_.fits(), GL_R32UI);
        program.set("lit_fits", 8);
        program.set("most_albedo", most_albedo);
        reflected.bind_storage(5);
        list.bind_storage(6);
        rims_.bind_storage(7);
        list.dispatch();
        wait_for_shaders();
    };
    run(reflect_program_, lists_.lit());
    run(rims_program_, rims_);
}

std::size_t LitMaps::bytes() const {
    return direct_.bytes() + whole_direct_.bytes() + first_.bytes() + radiosity_.bytes() +
           sky_alone_.bytes() + from_sky_.bytes() + dark_.bytes() + texels_.albedo().bytes() +
           texels_.points().bytes() + lists_.bytes() + relit_.bytes() + near_.bytes() + rims_.bytes() +
           hits_.bytes() + photons_.bytes();
}

}  // namespace lanthorn::gi
