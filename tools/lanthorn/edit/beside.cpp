#include "tools/lanthorn/edit/beside.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/hierarchy.h"
#include "tools/editor/core/play_changes.h"
#include "tools/lanthorn/edit/recorded_state.h"
#include "tools/lanthorn/replay/field_differences.h"
#include "tools/lanthorn/replay/reference.h"
#include "tools/lanthorn/replay/replayed_level.h"

namespace lanthorn::tools {

namespace {

constexpr std::size_t kMostRows = 200;

std::string expected_state(const LevelFile& level, const std::string& file,
                           const replay::Recording& recording, std::uint64_t step,
                           const std::string& against) {
    if (!against.empty()) {
        if (step == 0) {
            throw InputError("--at: found step 0, expected a later one: nothing has been played by then");
        }
        return program_reference(against, level.path)->traced(recording, step - 1, "").state;
    }
    std::vector<std::uint64_t> steps;
    for (const replay::StoredState& stored : recording.annotations.states) {
        if (stored.step == step) {
            return stored.bytes;
        }
        steps.push_back(stored.step);
    }
    throw InputError(
        file, "",
        fmt::format("found {}, expected one of step {}; or --against PROGRAM, the build that recorded it",
                    steps.empty() ? "no states" : fmt::format("states of steps {}", fmt::join(steps, ", ")),
                    step));
}

std::uint32_t node_of(const ecs::World& world, ecs::Entity e, const SceneData& scene) {
    const Source* source = e && world.alive(e) ? world.try_get<Source>(e) : nullptr;
    return source != nullptr && source->node < scene.file.nodes.size() ? scene.file.nodes[source->node]
                                                                       : kNone;
}

// What stands otherwise because what it belongs to does.
bool goes_with_parent(const ecs::World& world, ecs::Entity e, std::uint32_t node, const SceneData& scene,
                      const std::map<std::uint32_t, dmat4>& to_expected) {
    constexpr double kSame = 1e-9;  // of numbers of a few metres
    const auto own = to_expected.find(node),
               above = to_expected.find(node_of(world, parent_of(world, e), scene));
    if (own == to_expected.end() || above == to_expected.end()) {
        return false;
    }
    double most = 0;
    for (int column = 0; column < 4; ++column) {
        const dvec4 difference = glm::abs(own->second[column] - above->second[column]);
        most = std::max({most, difference.x, difference.y, difference.z, difference.w});
    }
    return most < kSame;
}

}  // namespace

edit_window::BesideShown beside(const std::string& level, const std::string& at, const std::string& against) {
    const auto [file, step] = recorded_place(at);
    const auto recording = std::make_shared<const replay::Recording>(replay::read_recording(file));
    const auto read = read_level(file, recording->header, level);
    if (step > recording->steps.size()) {
        throw InputError(file, "",
                         fmt::format("found {} steps, expected at least {}", recording->steps.size(), step));
    }
    ReplayedLevel found(*read, file, recording), expected(*read, file, recording);
    while (found.session().steps() < step) {
        found.app().step();
    }
    const ecs::Registry& registry = expected.app().registry();
    expected.session().jump(session::Moment(
        step, ecs::Snapshot::from_bytes(expected_state(*read, file, *recording, step, against), registry,
                                        against.empty() ? file : against)));
    edit_window::BesideShown shown;
    shown.title = fmt::format("after step {} of {}", step, std::filesystem::path(file).filename().string());
    std::vector<FieldDifference> fields =
        field_differences(registry, found.world(), expected.world(), kMostRows + 1);
    shown.more = fields.size() > kMostRows;
    fields.resize(std::min(fields.size(), kMostRows));
    for (FieldDifference& field : fields) {
        shown.rows.push_back({node_of(found.world(), field.id, read->scene),
                              field.entity.empty() ? field.name() : field.entity + ": " + field.name(),
                              std::move(field.found), std::move(field.expected)});
    }
    const auto here = editor::played_nodes(found.world(), read->scene),
               there = editor::played_nodes(expected.world(), read->scene);
    for (const auto& [node, one] : here) {
        const auto other = there.find(node);
        if (other != there.end() && other->second.to_world != one.to_world) {
            shown.to_expected[node] = other->second.to_world * glm::inverse(one.to_world);
        }
    }
    const std::map<std::uint32_t, dmat4> all = shown.to_expected;
    found.world().query<ecs::Read<Source>>().each([&](ecs::Entity e, const Source&) {
        const std::uint32_t node = node_of(found.world(), e, read->scene);
        if (goes_with_parent(found.world(), e, node, read->scene, all)) {
            shown.to_expected.erase(node);
        }
    });
    return shown;
}

std::string beside_text(const edit_window::BesideShown& shown) {
    std::string text = fmt::format("beside    {}: {}{} fields differ\n", shown.title, shown.rows.size(),
                                   shown.more ? " and more" : "");
    for (const edit_window::BesideRow& row : shown.rows) {
        text += fmt::format("          {}\n          expected {}\n          found    {}\n", row.name,
                            row.expected, row.found);
    }
    return text;
}

}  // namespace lanthorn::tools
