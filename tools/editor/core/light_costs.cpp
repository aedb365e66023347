#include "tools/editor/core/light_costs.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "lanthorn/ecs/query.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/scene/components.h"
#include "tools/editor/core/same_as_game.h"

namespace lanthorn::editor {

std::vector<LightShare> light_shares(const reference::LightSplitter& light, const CameraView& camera,
                                     ivec2 size, int places, int paths) {
    // A grid of about so many places of the picture's shape.
    const double side = std::sqrt(static_cast<double>(size.x) * size.y / std::max(1, places));
    const ivec2 cells = glm::max(ivec2(glm::dvec2(size) / std::max(1.0, side)), 1);
    std::map<reference::LightSource, LightShare> by_lamp;
    double whole = 0;
    int seen = 0;
    for (int y = 0; y < cells.y; ++y) {
        for (int x = 0; x < cells.x; ++x) {
            const ivec2 pixel((2 * ivec2(x, y) + 1) * size / (2 * cells));
            const auto point = light.seen(camera, size, pixel);
            if (!point) {
                continue;
            }
            ++seen;
            for (const reference::LampPart& lamp : light.lamps(*point, paths)) {
                LightShare& share = by_lamp[lamp.source];
                share.source = lamp.source;
                share.entity = lamp.entity;
                share.lux += lamp.sum.value();
                whole += lamp.sum.value();
            }
        }
    }
    std::vector<LightShare> result;
    for (auto& [source, share] : by_lamp) {
        share.share = whole > 0 ? share.lux / whole : 0;
        share.lux /= std::max(1, seen);
        result.push_back(share);
    }
    std::ranges::stable_sort(result, std::greater(), &LightShare::share);
    return result;
}

struct LightCosts::Shown {
    Shown(const EditSession& session, const Settings& settings, ivec2 size) {
        const EditSession::Copy copy(session.document());
        workbench::SceneView view = session.view();
        SceneData scene = workbench::load_scene(copy.file().string(), view);
        view.camera = workbench::add_pose_camera(scene, session.pose());
        shown.emplace(std::move(scene), view);
        gi::add_picture_plugins(shown->app(), settings);
        shown->app().view().size = size;
        std::as_const(*shown).world().query<ecs::Read<LightComponent>>().each(
            [&](ecs::Entity e, const LightComponent&) { lamps.push_back(e); });
        std::ranges::sort(lamps, {}, &ecs::Entity::index);
    }
    double draw() {
        const auto begun = std::chrono::steady_clock::now();
        shown->show_at(0);
        glFinish();
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
    }
    static double median(std::vector<double> values) {
        std::ranges::sort(values);
        return values[values.size() / 2];
    }

    std::optional<ShownScene> shown;
    std::vector<ecs::Entity> lamps;
    // Rounds: all lights, without the first, all, without the second, ..., all.
    std::size_t round = 0;
    int in_round = 0;
    std::optional<Light> taken;
    std::vector<double> timed;
    std::vector<double> medians;
};

LightCosts::LightCosts(const EditSession& session, const Settings& settings, ivec2 size)
    : shown_(std::make_unique<Shown>(session, settings, size)) {}
LightCosts::~LightCosts() = default;

bool LightCosts::step() {
    Shown& s = *shown_;
    const std::size_t rounds = 2 * s.lamps.size() + 1;
    if (s.round >= rounds || s.lamps.empty()) {
        return false;
    }
    ecs::World& world = s.shown->world();
    const bool without = s.round % 2 == 1;
    const ecs::Entity lamp = s.lamps[std::min(s.round / 2, s.lamps.size() - 1)];
    if (s.in_round == 0 && without) {
        s.taken = world.get<LightComponent>(lamp).light;
        world.remove<LightComponent>(lamp);
    }
    const double ms = s.draw();
    ++frames_;
    if (++s.in_round > kSettling) {
        s.timed.push_back(ms);
    }
    if (s.in_round < kSettling + kTimed) {
        return true;
    }
    s.medians.push_back(Shown::median(std::exchange(s.timed, {})));
    s.in_round = 0;
    if (without) {
        world.insert(lamp, LightComponent{*s.taken});
    } else if (s.round > 0) {
        const double before = s.medians[s.round - 2], after = s.medians[s.round];
        costs_.push_back({s.lamps[s.round / 2 - 1].index, 0.5 * (before + after) - s.medians[s.round - 1],
                          std::abs(before - after)});
    }
    return ++s.round < rounds;
}

}  // namespace lanthorn::editor
