#include "gi_module/technique.h"

#include <fmt/format.h>

#include "engine/core/error.h"
#include "gi_module/emc/emc_technique.h"

namespace lanthorn::gi {

namespace {

// Direct light alone.
class NoIndirectLight final : public Technique {
  public:
    render::IndirectLight render(const render::FrameInputs& inputs, const GiSettings& settings) override {
        GiSettings off = settings;
        off.technique = "none";
        statistics_.plan = make_plan(inputs.scene, off, {});
        return {};
    }
    GiStatistics statistics(bool) override { return statistics_; }

  private:
    GiStatistics statistics_;
};

}  // namespace

std::vector<std::string> technique_names() { return {"emc", "none"}; }

std::unique_ptr<Technique> make_technique(const std::string& name) {
    if (name == "emc") {
        return std::make_unique<EmcTechnique>();
    }
    if (name == "none") {
        return std::make_unique<NoIndirectLight>();
    }
    throw InputError(fmt::format("gi.technique: found '{}', expected {}", name, fmt::join(technique_names(), " or ")));
}

}  // namespace lanthorn::gi
