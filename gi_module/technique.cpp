#include "lanthorn/gi/technique.h"

#include <array>

#include "lanthorn/core/error.h"
#include "lanthorn/gi/emc/emc_technique.h"

namespace lanthorn::gi {

namespace {

// Direct light alone.
class NoIndirectLight final : public Technique {
  public:
    void plan(const FrameScene& scene, ivec2, const GiSettings& settings) override {
        GiSettings off = settings;
        off.technique = TechniqueKind::none;
        statistics_.plan = make_plan(scene, off, {});
    }
    void update(const render::LightInputs&) override {}
    render::IndirectLight indirect(const render::FrameInputs&) override { return {}; }
    GiStatistics statistics(bool) override { return statistics_; }

  private:
    GiStatistics statistics_;
};

std::array<TechniqueMaker, kTechniqueKinds>& makers() {
    static std::array<TechniqueMaker, kTechniqueKinds> all{};
    return all;
}

}  // namespace

void add_technique(TechniqueKind kind, TechniqueMaker maker) {
    makers()[static_cast<std::size_t>(kind)] = maker;
}

std::unique_ptr<Technique> make_technique(TechniqueKind kind) {
    switch (kind) {
        case TechniqueKind::emc:
            return std::make_unique<EmcTechnique>();
        case TechniqueKind::none:
            return std::make_unique<NoIndirectLight>();
        case TechniqueKind::path:
            throw InputError(
                "gi.technique: found 'path', expected emc, coarse-path or none for frames (lanthorn render "
                "alone traces paths)");
        case TechniqueKind::coarse_path:
            break;
    }
    if (const TechniqueMaker maker = makers()[static_cast<std::size_t>(kind)]) {
        return maker();
    }
    throw InputError("gi.technique: found '" + technique_name(kind) +
                     "', expected emc or none: this program is built without it");
}

}  // namespace lanthorn::gi
