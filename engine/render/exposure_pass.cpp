#include "engine/render/exposure_pass.h"

#include <cmath>
#include <string>
#include <vector>

#include "engine/render/composite_state.h"

namespace lanthorn::render {

void ExposurePass::measure(const gpu::Texture& radiance, const RenderSettings& settings,
                           const Composite::Metering& metering, const gpu::Buffer& state) {
    const gpu::Program& program =
        program_.with(metering.around ? std::vector<std::string>{"WITH_AROUND"} : std::vector<std::string>());
    program.set("radiance", 0);
    program.set("manual", settings.exposure_mode == ExposureMode::manual ? 1 : 0);
    program.set("manual_exposure", exposure_of_ev100(settings.exposure_ev100));
    program.set("compensation", std::exp2(settings.exposure_compensation));
    program.set("darkest", settings.exposure_darkest);
    program.set("rate", metering.reset ? 1.0f : settings.exposure_glide);
    state.bind_storage(kCompositeStateBinding);
    radiance.bind(0);
    program.use();
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace lanthorn::render
