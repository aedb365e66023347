#include "lanthorn/photon_splat/photon_splat_technique.h"

#include <nlohmann/json.hpp>

namespace lanthorn::gi {

namespace {

std::string statistics_in_json(const GiStatistics& gi) {
    const auto& splat = gi.of<PhotonSplatStatistics>();
    nlohmann::ordered_json json{
        {"walks", splat.walks},   {"photons", splat.photons},   {"caustic_photons", splat.caustic_photons},
        {"rays", splat.rays},     {"surfaces", splat.surfaces}, {"splatted", splat.splatted},
        {"rounds", splat.rounds}, {"memory", splat.memory},     {"on_disk", splat.on_disk},
        {"builds", splat.builds}};
    if (!splat.error.empty()) {
        json["error"] = splat.error;
    }
    return json.dump();
}

}  // namespace

void PhotonSplatTechnique::plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) {
    const auto& before = settings_.of<PhotonSplatSettings>();
    const auto& now = settings.of<PhotonSplatSettings>();
    if (!workers_ || now.threads != before.threads) {
        workers_ = std::make_unique<reference::TileWorkers>(now.threads);
    }
    const bool same_traced = same_photons(before, now) && !renewed(settings_, settings).samples &&
                             settings_.photons == settings.photons;
    SplatHistory history;
    history.walks = photons_.walks();
    history.splatted = splatted_walks_;
    history.has_photons = has_photons_ && same_traced;
    history.has_picture = irradiance_ != nullptr && size == size_ && same_picture(before, now);
    history.has_view = has_view_ && size == size_;
    history.full = full_;
    settings_ = settings;
    size_ = size;
    plan_ = make_photon_splat_plan(scene, settings, history);
    if (plan_.unlit != Unlit::no) {
        photons_.clear();
        scene_.clear();
        has_photons_ = has_view_ = full_ = false;
        splatted_walks_ = 0;
        irradiance_ = nullptr;
        error_.clear();
    }
}

void PhotonSplatTechnique::update(const render::LightInputs& inputs) {
    if (plan_.unlit != Unlit::no) {
        return;
    }
    const auto& own = settings_.of<PhotonSplatSettings>();
    {
        const gpu::PassTimer::Scope scope(inputs.timer, "surfaces");
        scene_.follow(inputs.scene,
                      own.scattering);  // the frame's own lights and instances, even if they hold
        if (plan_.on(SplatPass::surfaces)) {
            surfaces_.follow(inputs.scene, *workers_);
        }
    }
    if (plan_.anew) {
        photons_.clear();
        const std::size_t all = static_cast<std::size_t>(own.memory) << 20;
        photons_.store().limit(all - std::min(all / 2, PhotonCollection::kTracing));
        splatted_walks_ = 0;
        full_ = false;
        error_.clear();
    }
    if (plan_.on(SplatPass::photons)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "photons");
        const PhotonSettings traced{plan_.bounces, settings_.seed, own.scattering};
        full_ = !photons_.grow(scene_, surfaces_, traced, plan_.grow, *workers_);
        if (full_) {
            error_ = photons_.store().error();
        }
    }
    has_photons_ = true;
}

render::IndirectLight PhotonSplatTechnique::indirect(const render::FrameInputs& inputs) {
    if (plan_.unlit != Unlit::no) {
        return {};
    }
    if (plan_.on(SplatPass::item_buffer)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "item_buffer");
        picture_.find(inputs, scene_, surfaces_, *workers_);
        has_view_ = true;
    }
    if (plan_.on(SplatPass::splats)) {
        const gpu::PassTimer::Scope scope(inputs.timer, "splats");
        irradiance_ = splats_.draw(picture_, surfaces_, photons_, photons_.powers(scene_.sources()),
                                   settings_.of<PhotonSplatSettings>(), *workers_);
        splatted_walks_ = photons_.walks();
        if (irradiance_ == nullptr) {  // what was on disk is lost: traced anew in the next frame
            error_ = photons_.store().error();
            has_photons_ = false;
        }
    }
    return {irradiance_, nullptr};
}

GiStatistics PhotonSplatTechnique::statistics(bool) {
    GiStatistics result;
    result.plan = in_words(plan_, settings_);
    PhotonSplatStatistics counted;
    counted.walks = photons_.walks();
    counted.photons = photons_.all(false) + photons_.all(true);
    counted.caustic_photons = photons_.all(true);
    counted.rays = photons_.rays();
    counted.surfaces = surfaces_.count();
    counted.splatted = plan_.on(SplatPass::splats) ? splats_.counts().splatted : 0;
    counted.rounds = splats_.counts().rounds;
    counted.memory = photons_.store().most_memory();
    counted.on_disk = photons_.store().on_disk();
    counted.builds = scene_.builds();
    counted.error = error_;
    result.nan_count = photons_.bad() + splats_.counts().bad;
    result.add(counted);
    return result;
}

TechniqueKind add_photon_splat() {
    TechniqueEntry entry;
    entry.name = "splat";
    entry.docs = "photons traced exactly and splatted onto the picture (Lavignotte and Paulin 2003)";
    entry.has_presets = true;
    entry.reads = {"gi.photon_splat.", "gi.bounces", "gi.photons", "gi.seed"};
    entry.turns = {{"gi.photons", {"5000", "100000", "400000"}},
                   {"gi.photon_splat.bandwidth", {"8", "12", "30"}},
                   {"gi.photon_splat.kernel", {"epanechnikov"}},
                   {"gi.photon_splat.boundaries", {"false"}}};
    entry.declare = declare_photon_splat_settings;
    entry.make = []() -> std::unique_ptr<Technique> { return std::make_unique<PhotonSplatTechnique>(); };
    entry.first_plan = first_photon_splat_plan;
    entry.statistics_json = statistics_in_json;
    return add_technique(std::move(entry));
}

}  // namespace lanthorn::gi
