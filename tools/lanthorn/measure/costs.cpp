#include "tools/lanthorn/measure/costs.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/reference/path_settings.h"
#include "tools/workbench/measure/light_costs.h"
#include "tools/workbench/measure/light_shares.h"

namespace lanthorn::tools {

namespace {

using reference::LightKind;

std::string kind_of(LightKind kind) {
    return kind == LightKind::punctual ? "lamp" : kind == LightKind::emitter ? "glowing surface" : "sky";
}

bool is_of(const LightShare& share, const Lamp& lamp) {
    return share.source.kind == lamp.kind &&
           (lamp.kind == LightKind::sky ||
            std::ranges::any_of(lamp.entities, [&](ecs::Entity e) { return e.index == share.entity; }));
}

// A lamp of a scene at rest, and what it gives.
struct GivingLamp {
    Lamp lamp;
    double share = 0, lux = 0;
};

// Most first. What a thing that glows by two materials gives counts as the first's.
std::vector<GivingLamp> giving_lamps(MovingScene& still, const Settings& settings, ivec2 size) {
    still.show(0);
    std::vector<GivingLamp> lamps;
    for (Lamp& lamp : all_lamps(still.shown().world())) {
        lamps.push_back({std::move(lamp)});
    }
    const FrameScene& frame = still.shown().frame();
    const reference::LightSplitter light(frame, reference::path_settings(settings));
    for (const LightShare& share : light_shares(light, frame.camera, size)) {
        const auto found =
            std::ranges::find_if(lamps, [&](const GivingLamp& of) { return is_of(share, of.lamp); });
        if (found != lamps.end()) {
            found->share += share.share;
            found->lux += share.lux;
        }
    }
    std::ranges::stable_sort(lamps, std::greater(), &GivingLamp::share);
    return lamps;
}

// The motions that lights are muted in: rest, and the first in which they stay what they are.
std::vector<Motion> light_motions(const std::vector<MotionCosts>& motions) {
    std::vector<Motion> list = {Motion::rest};
    for (const MotionCosts& m : motions) {
        const Motion motion = m.planned.motion;
        if (motion != Motion::rest && motion != Motion::dim && motion != Motion::cut &&
            m.planned.lacking.empty()) {
            list.push_back(motion);
            break;
        }
    }
    return list;
}

// Costs of the first `count` of `giving`, all of them muted in turn; in that order.
std::vector<LightCost::Ms> mute_lights(const MotionScene& scene, Motion motion, const Settings& settings,
                                       const FrameCostsJob& job, const std::vector<GivingLamp>& giving,
                                       std::size_t count, const std::function<void()>& done) {
    std::vector<Lamp> lamps;
    for (std::size_t i = 0; i < count; ++i) {
        lamps.push_back(giving[i].lamp);
    }
    const LightCostFrames each{job.warmup, job.frames};
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    MovingScene moving(scene.data, scene.view, motion, std::max(LightCosts::all_frames(count, each), 1));
    context = gpu::create_headless_context();
    const bool software = context->info().software;
    App& app = moving.shown().app();
    gi::add_picture_plugins(app, settings);
    app.view().size = job.size;
    int frame = 0;
    LightCosts costs(
        app.world(), std::move(lamps),
        [&] {
            moving.show(frame++);
            glFinish();
        },
        each);
    for (std::size_t told = 0; costs.step();) {
        for (; told < costs.costs().size(); ++told) {
            done();
        }
    }
    if (count > 0) {
        done();  // the last one
    }
    std::vector<LightCost::Ms> list;
    for (const LightCosts::Cost& cost : costs.costs()) {
        list.push_back(software ? LightCost::Ms{cost.cpu_ms, cost.cpu_noise, cost.ms}
                                : LightCost::Ms{cost.ms, cost.noise, cost.ms});
    }
    return list;
}

void measure_lights(SceneCosts& costs, const MotionScene& scene, const Settings& settings,
                    const CostsJob& job, const std::function<void()>& done) {
    MovingScene still(scene.data, scene.view, Motion::rest, 1);
    const std::vector<GivingLamp> giving = giving_lamps(still, settings, job.frames.size);
    const std::size_t muted = std::min(giving.size(), static_cast<std::size_t>(job.lights));
    costs.light_motions = light_motions(costs.motions);
    for (const GivingLamp& of : giving) {
        costs.lights.push_back({of.lamp.name, kind_of(of.lamp.kind), of.share, of.lux, {}});
    }
    for (const Motion motion : costs.light_motions) {
        const std::vector<LightCost::Ms> ms =
            mute_lights(scene, motion, settings, job.frames, giving, muted, done);
        for (std::size_t i = 0; i < giving.size(); ++i) {
            costs.lights[i].by_motion.push_back(i < ms.size() ? std::optional(ms[i]) : std::nullopt);
        }
    }
}

}  // namespace

SceneCosts measure_costs(const MotionScene& scene, const Settings& settings, const CostsJob& job,
                         const std::function<void()>& done) {
    const std::vector<RuleSwitch> rules = rule_switches();
    SceneCosts costs;
    costs.name = scene.name;
    for (const Motion motion : job.motions) {
        std::vector<FrameCosts> planned;
        std::vector<std::vector<FrameCosts>> off(rules.size());
        for (int round = 0; round < job.rounds; ++round) {
            planned.push_back(measure_frame_costs(scene, motion, settings, job.frames));
            done();
            if (!planned.back().lacking.empty()) {
                break;
            }
            for (std::size_t r = 0; r < rules.size(); ++r) {
                Settings without = settings;
                without.set<bool>(rules[r].setting, false);
                off[r].push_back(measure_frame_costs(scene, motion, without, job.frames));
                done();
            }
        }
        costs.motions.push_back(motion_costs(planned, off, rules));
    }
    measure_lights(costs, scene, settings, job, done);
    return costs;
}

}  // namespace lanthorn::tools
