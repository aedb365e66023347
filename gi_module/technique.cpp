#include "lanthorn/gi/technique.h"

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

}  // namespace

std::unique_ptr<Technique> make_technique(TechniqueKind kind) {
    switch (kind) {
        case TechniqueKind::emc:
            return std::make_unique<EmcTechnique>();
        case TechniqueKind::none:
            return std::make_unique<NoIndirectLight>();
        case TechniqueKind::path:
            break;
    }
    throw InputError(
        "gi.technique: found 'path', expected emc or none for frames (lanthorn render alone traces paths)");
}

}  // namespace lanthorn::gi
