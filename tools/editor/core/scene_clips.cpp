#include "tools/editor/core/scene_clips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/components.h"
#include "tools/editor/core/command.h"
#include "tools/editor/core/edit_world.h"

namespace lanthorn::editor {

namespace {

// The usual rate that the median distance of neighbouring keys is nearest to.
double rate_of(const std::vector<float>& keys) {
    std::vector<float> steps;
    for (std::size_t i = 1; i < keys.size(); ++i) {
        steps.push_back(keys[i] - keys[i - 1]);
    }
    if (steps.empty()) {
        return 60;
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::ranges::nth_element(steps, middle);
    const double found = 1 / std::max(1e-3, static_cast<double>(*middle));
    constexpr std::array kUsual = {24.0, 25.0, 30.0, 50.0, 60.0};
    const auto* nearest = std::ranges::min_element(
        kUsual, {}, [&](double rate) { return std::abs(std::remainder(rate / found, 1)); });
    return *nearest;
}

}  // namespace

std::vector<ClipRow> clip_rows(EditSession& session) {
    std::vector<ClipRow> rows;
    const ecs::World& world = std::as_const(session.app()).world();
    world.query<ecs::Read<AnimationSet>>().each([&](const AnimationSet& set) {
        for (std::size_t i = 0; set.clips && i < set.clips->size(); ++i) {
            const AnimationClip& clip = (*set.clips)[i];
            ClipRow row;
            row.name = clip.name;
            const bool taken =
                std::ranges::any_of(rows, [&](const ClipRow& r) { return r.name == clip.name; });
            row.key = clip.name.empty() || clip.name == "none" || taken ? std::to_string(i) : clip.name;
            row.seconds = clip.duration;
            const auto add = [&](std::uint32_t loaded) {
                const EditedNode* node = loaded < set.nodes.size() && world.alive(set.nodes[loaded])
                                             ? world.try_get<EditedNode>(set.nodes[loaded])
                                             : nullptr;
                if (node != nullptr && node->node != kNone) {
                    row.nodes.push_back(node->node);
                }
            };
            for (const AnimationChannel& channel : clip.channels) {
                add(channel.node);
                row.keys.insert(row.keys.end(), channel.times.begin(), channel.times.end());
            }
            for (const PropertyChannel& channel : clip.properties) {
                std::ranges::for_each(channel.nodes, add);
                row.keys.insert(row.keys.end(), channel.keys.times.begin(), channel.keys.times.end());
            }
            const auto sort = [](auto& all) {
                std::ranges::sort(all);
                all.erase(std::unique(all.begin(), all.end()), all.end());
            };
            sort(row.nodes);
            sort(row.keys);
            row.rate = rate_of(row.keys);
            rows.push_back(std::move(row));
        }
    });
    return rows;
}

bool moves(const ClipRow& clip, const EditModel& model, std::uint32_t node) {
    return std::ranges::any_of(
        clip.nodes, [&](std::uint32_t moved) { return moved == node || model.is_within(moved, node); });
}

std::string start_clip(EditSession& session, const std::vector<ClipRow>& clips) {
    if (clips.empty()) {
        return "";
    }
    const std::string named = named_clip(session.world());
    if (named.empty()) {
        return clips.front().key;
    }
    const auto found = std::ranges::find_if(
        clips, [&](const ClipRow& clip) { return clip.key == named || clip.name == named; });
    return found == clips.end() ? "none" : found->key;
}

std::string start_clip_line(EditSession& session, const std::string& key) {
    std::uint32_t node = kNone;
    session.world().query<ecs::Read<StartClip>>().each(
        [&](ecs::Entity e, const StartClip&) { node = node == kNone ? session.node_of(e) : node; });
    if (node == kNone) {
        node = session.model().roots.front();
    }
    return "set " + word(session.path_of(node)) + " start_clip.clip " + word(key);
}

}  // namespace lanthorn::editor
