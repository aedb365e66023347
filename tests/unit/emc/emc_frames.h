// Frames of `emc` without what they draw: planned, and taken for done.
#pragma once

#include "gi_module/techniques/emc/emc_plan.h"

namespace lanthorn::gi::test {

class EmcFrames {
  public:
    explicit EmcFrames(bool exact_rays = false) { frame.exact_rays = exact_rays; }

    // Follows what scene and settings have become, and plans the frame.
    EmcPlan plan(const FrameScene& scene, const GiSettings& settings) {
        frame.light = light_bounds(scene);
        frame.specular = shows_specular(scene, settings);
        inputs_.follow(scene, ivec2(64), settings, frame.light.unlit, frame.inputs);
        const EmcPlan result = make_emc_plan(scene, settings, frame, kept);
        frame.inputs = result.now;
        return result;
    }
    // The plan of the frame that would come next.
    EmcPlan next(const FrameScene& scene, const GiSettings& settings) const {
        EmcFrames then = *this;
        return then.plan(scene, settings);
    }
    EmcPlan run(const FrameScene& scene, const GiSettings& settings) {
        const EmcPlan result = plan(scene, settings);
        if (result.bounces > 0) {
            kept.done(result, {}, scene.bounds);
        }
        return result;
    }

    EmcFrame frame;
    EmcKept kept;

  private:
    EmcInputs inputs_;
};

inline EmcPlan first_plan_of(const FrameScene& scene, const GiSettings& settings) {
    return EmcFrames().plan(scene, settings);
}

// After the first frame of the scene.
inline EmcFrames running(const FrameScene& scene, const GiSettings& settings, bool exact_rays = false) {
    EmcFrames frames(exact_rays);
    FrameScene first = scene;
    first.changes = {};
    frames.run(first, settings);
    return frames;
}

}  // namespace lanthorn::gi::test
