#include "lanthorn/gi/technique.h"

#include <fmt/format.h>

#include <algorithm>

#include "gi_module/techniques/emc/emc_technique.h"
#include "lanthorn/core/error.h"

namespace lanthorn::gi {

namespace {

GiPlan plan_without_passes(const char* why) {
    return {{{"indirect_light", false, "", why}}, 0};
}

GiPlan plan_of_none(const FrameScene&, const GiSettings&) {
    return plan_without_passes("the technique is 'none': direct light alone");
}

GiPlan plan_of_path(const FrameScene&, const GiSettings&) {
    return plan_without_passes("the technique is 'path': paths need no passes");
}

// Direct light alone.
class NoIndirectLight final : public Technique {
  public:
    void plan(const FrameScene&, ivec2, const GiSettings&) override {}
    void update(const render::LightInputs&) override {}
    render::IndirectLight indirect(const render::FrameInputs&) override { return {}; }
    GiStatistics statistics(bool) override {
        GiStatistics result;
        result.plan = plan_of_none({}, {});
        return result;
    }
};

template <typename T>
std::unique_ptr<Technique> make() {
    return std::make_unique<T>();
}

std::unique_ptr<Technique> make_path() {
    std::vector<std::string> others = technique_names();
    std::erase(others, "path");
    throw InputError(fmt::format(
        "gi.technique: found 'path', expected one of {} for frames (lanthorn render alone traces paths)",
        fmt::join(others, ", ")));
}

TechniqueEntry emc_entry() {
    TechniqueEntry emc;
    emc.name = "emc";
    emc.docs = "multi-image photon tracing (Yao et al. 2010)";
    emc.has_presets = true;
    emc.reads = {"gi.bounces", "gi.photons", "gi.seed",       "gi.accumulate", "gi.caustics.",
                 "gi.emc.",    "gi.gather.", "gi.emc.splat.", "gi.specular."};
    emc.turns = {{"gi.photons", {"5000", "10000", "40000", "80000", "160000"}},
                 {"gi.emc.count", {"4", "6", "12"}},
                 {"gi.emc.resolution", {"64", "192", "256"}},
                 {"gi.emc.steps", {"16", "64", "128"}},
                 {"gi.bounces", {"1", "3"}},
                 {"gi.gather.grid", {"2", "3", "6"}},
                 {"gi.gather.rays", {"2", "8", "16"}},
                 {"gi.gather.texels", {"32", "96", "128"}},
                 {"gi.emc.rays", {"maps", "bvh"}},
                 {"gi.emc.splat.bandwidth", {"fixed"}},
                 {"gi.emc.splat.c0", {"4", "5.6", "11", "16"}},
                 {"gi.emc.splat.base", {"1", "2", "4", "8"}}};
    emc.make = make<EmcTechnique>;
    emc.first_plan = first_emc_plan;
    return emc;
}

TechniqueEntry none_entry() {
    TechniqueEntry none;
    none.name = "none";
    none.docs = "direct light alone";
    none.make = make<NoIndirectLight>;
    none.first_plan = plan_of_none;
    return none;
}

TechniqueEntry path_entry() {
    TechniqueEntry path;
    path.name = "path";
    path.docs = "the path-traced reference (lanthorn render only)";
    path.reads = {"path.", "gi.bounces"};
    path.turns = {{"path.spp", {"1", "4", "16", "64"}}};
    path.make = make_path;
    path.first_plan = plan_of_path;
    return path;
}

// References stay valid when another is added.
std::deque<TechniqueEntry>& entries() {
    static std::deque<TechniqueEntry> all = {emc_entry(), none_entry(), path_entry()};
    return all;
}

}  // namespace

TechniqueKind add_technique(TechniqueEntry entry) {
    std::deque<TechniqueEntry>& all = entries();
    const auto same = std::ranges::find(all, entry.name, &TechniqueEntry::name);
    const auto kind = static_cast<TechniqueKind>(same - all.begin());
    if (same == all.end()) {
        all.push_back(std::move(entry));
    }
    return kind;
}

const std::deque<TechniqueEntry>& techniques() {
    return entries();
}

std::vector<std::string> technique_names() {
    std::vector<std::string> names;
    for (const TechniqueEntry& entry : entries()) {
        names.push_back(entry.name);
    }
    return names;
}

const TechniqueEntry& technique_entry(TechniqueKind kind) {
    return entries().at(static_cast<std::size_t>(kind));
}

const TechniqueEntry* find_technique(std::string_view name) {
    const auto found = std::ranges::find(entries(), name, &TechniqueEntry::name);
    return found == entries().end() ? nullptr : &*found;
}

std::unique_ptr<Technique> make_technique(TechniqueKind kind) {
    return technique_entry(kind).make();
}

GiPlan first_plan(const FrameScene& scene, const GiSettings& settings) {
    return technique_entry(settings.technique).first_plan(scene, settings);
}

}  // namespace lanthorn::gi
