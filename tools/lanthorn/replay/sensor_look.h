// Draws a replay now and then, so that its light sensors read again what they read when it was recorded.
#pragma once

#include <cstdint>
#include <memory>

#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/app.h"

namespace lanthorn::tools {

class SensorLook {
  public:
    // Needs OpenGL: throws Error with ExitCode::no_gl without. It must outlive the App that it draws.
    SensorLook();

    // From now on `app` has a small picture, drawn with the seed of its session.
    void draw(App& app, std::uint64_t seed);
    // After each step: draws some frames where it is time to.
    void look(App& app, std::uint64_t step, std::uint64_t steps);

  private:
    std::unique_ptr<gpu::Context> context_;
    std::uint64_t looked_ = 0;  // the step of the last picture
};

}  // namespace lanthorn::tools
