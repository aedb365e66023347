#include "lanthorn/gi/technique.h"

#include "lanthorn/core/error.h"
#include "lanthorn/gi/emc/emc_technique.h"

namespace lanthorn::gi {

namespace {

// Direct light alone.
class NoIndirectLight final : public Technique {
  public:
    render::IndirectLight render(const render::FrameInputs& inputs, const GiSettings& settings) override {
        GiSettings off = settings;
        off.technique = TechniqueKind::none;
        statistics_.plan = make_plan(inputs.scene, off, {});
        return {};
    }
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
