// What frames cost: of a whole frame, and of its indirect light.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "lanthorn/core/settings.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/app.h"

namespace lanthorn::workbench {

// Milliseconds: by the clock (GL timer queries on real hardware), and of processor time of all threads.
struct FrameCost {
    // Milliseconds of a pass: by the clock, and of processor time.
    struct Pass {
        double ms = 0, cpu = 0;
    };
    double gi = 0, gi_cpu = 0;
    double frame = 0, frame_cpu = 0;
    std::map<std::string, Pass> gi_passes;  // what each takes itself, without those within it
    std::map<std::string, Pass> passes;     // those of the whole frame, likewise

    // What the frame takes without its indirect light, by the clock.
    double direct() const { return frame - gi; }
    // The same of processor time.
    double direct_cpu() const { return frame_cpu - gi_cpu; }
};

// Processor time of this process so far, all threads (llvmpipe's too), milliseconds.
double processor_ms();

class FrameMeter {
  public:
    // Adds the plugins of the picture to an App without them, with a technique as `settings` name it. Its
    // systems run on one thread from here on, so that processor time is the technique's alone.
    FrameMeter(App& app, const Settings& settings, const gpu::Context& context);

    // `show` shows one frame of the App. Waits for the GPU.
    FrameCost measure(const std::function<void()>& show);

    // Bytes of GPU memory that the technique has taken so far, less what it has given back: for what does not
    // depend on the camera (maps, light on them, photons), and for the picture.
    struct Held {
        std::int64_t scene = 0, picture = 0;
    };
    // So far, from this meter's App alone.
    const Held& held() const { return *held_; }

  private:
    App* app_;
    bool software_;
    std::shared_ptr<double> gi_cpu_;  // of this frame, milliseconds
    std::shared_ptr<Held> held_;
};

}  // namespace lanthorn::workbench
