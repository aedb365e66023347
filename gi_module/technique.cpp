#include "lanthorn/gi/technique.h"

#include <array>

#include "lanthorn/core/error.h"
#include "lanthorn/gi/emc/emc_technique.h"

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
    throw InputError(
        "gi.technique: found 'path', expected emc, coarse-path or none for frames (lanthorn render "
        "alone traces paths)");
}

std::array<TechniqueEntry, kTechniqueKinds>& entries() {
    static std::array<TechniqueEntry, kTechniqueKinds> all = [] {
        std::array<TechniqueEntry, kTechniqueKinds> known{};
        known[static_cast<std::size_t>(TechniqueKind::emc)] = {make<EmcTechnique>, first_emc_plan};
        known[static_cast<std::size_t>(TechniqueKind::none)] = {make<NoIndirectLight>, plan_of_none};
        known[static_cast<std::size_t>(TechniqueKind::path)] = {make_path, plan_of_path};
        return known;
    }();
    return all;
}

const TechniqueEntry& entry_of(TechniqueKind kind) {
    const TechniqueEntry& entry = entries()[static_cast<std::size_t>(kind)];
    if (entry.make == nullptr) {
        throw InputError("gi.technique: found '" + technique_name(kind) +
                         "', expected emc or none: this program is built without it");
    }
    return entry;
}

}  // namespace

void add_technique(TechniqueKind kind, const TechniqueEntry& entry) {
    entries()[static_cast<std::size_t>(kind)] = entry;
}

std::unique_ptr<Technique> make_technique(TechniqueKind kind) {
    return entry_of(kind).make();
}

GiPlan first_plan(const FrameScene& scene, const GiSettings& settings) {
    return entry_of(settings.technique).first_plan(scene, settings);
}

}  // namespace lanthorn::gi
