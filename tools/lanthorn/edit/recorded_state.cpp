#include "tools/lanthorn/edit/recorded_state.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <memory>
#include <system_error>

#include "game/rules/components.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/transforms.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/lanthorn/replay/replayed_level.h"

namespace lanthorn::tools {

namespace {

std::vector<std::uint32_t> moved_by_clips(const SceneData& scene) {
    std::vector<std::uint32_t> nodes;
    for (const AnimationClip& clip : scene.animations) {
        for (const AnimationChannel& channel : clip.channels) {
            if (channel.node < scene.file.nodes.size()) {
                nodes.push_back(scene.file.nodes[channel.node]);
            }
        }
    }
    return nodes;
}

std::optional<workbench::CameraPose> eyes_of(const ecs::World& world) {
    std::optional<workbench::CameraPose> pose;
    world.query<ecs::With<game::Eyes>, ecs::Read<WorldTransform>>().each(
        [&](ecs::Entity e, const WorldTransform& at) {
            const CameraComponent* lens = world.try_get<CameraComponent>(e);
            pose = workbench::pose_of(at.matrix, lens != nullptr ? lens->camera : Camera());
        });
    return pose;
}

}  // namespace

RecordedState recorded_state(const std::string& file, const std::string& level,
                             std::optional<std::uint64_t> step) {
    const auto recording = std::make_shared<const replay::Recording>(replay::read_recording(file));
    const auto read = read_level(file, recording->header, level);
    const auto steps = static_cast<std::uint64_t>(recording->steps.size());
    if (step && *step > steps) {
        throw InputError(file, "", fmt::format("found {} steps, expected at least {}", steps, *step));
    }
    ReplayedLevel replayed(*read, file, recording);
    RecordedState state;
    state.step = step.value_or(steps);
    state.scene.animated = moved_by_clips(read->scene);
    state.scene.before = editor::played_nodes(replayed.world(), read->scene);
    while (replayed.session().steps() < state.step) {
        replayed.app().step();
    }
    state.scene.after = editor::played_nodes(replayed.world(), read->scene);
    state.eyes = eyes_of(replayed.world());
    return state;
}

RecordedPlace recorded_place(const std::string& at) {
    const std::size_t colon = at.rfind(':');
    std::uint64_t step = 0;
    const auto is_step = [&] {
        const char* const end = at.data() + at.size();
        const auto [last, problem] = std::from_chars(at.data() + colon + 1, end, step);
        return problem == std::errc() && last == end;
    };
    if (colon == std::string::npos || colon == 0 || !is_step()) {
        throw InputError(fmt::format("--at: found '{}', expected FILE:STEP of a recording", at));
    }
    return {at.substr(0, colon), step};
}

void show_recorded(editor::EditSession& session, const std::string& at) {
    const auto [file, step] = recorded_place(at);
    const RecordedState state = recorded_state(file, session.path().string(), step);
    std::vector<std::string> lines;
    for (const editor::PlayChange& change :
         play_changes(session.model(), state.scene.before, state.scene.after, state.scene.animated)) {
        lines.insert(lines.end(), change.lines.begin(), change.lines.end());
    }
    if (!lines.empty()) {
        session.run(
            fmt::format("as after step {} of {}", step, std::filesystem::path(file).filename().string()),
            lines);
    }
    if (state.eyes) {
        session.set_pose(*state.eyes);
    }
}

}  // namespace lanthorn::tools
