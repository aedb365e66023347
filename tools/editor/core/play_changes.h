// What stands otherwise after a scene has been played: offered as commands that would make it so.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lanthorn/ecs/world.h"
#include "tools/editor/core/edit_model.h"

namespace lanthorn::editor {

// Where a node of the document stands in a world, and the light that it has there.
struct PlayedNode {
    dmat4 to_world{1};
    Light light;
    bool has_light = false;
};

// Of all entities that came from the file `scene` was read from, by the document's node.
std::map<std::uint32_t, PlayedNode> played_nodes(const ecs::World& world, const SceneData& scene);

struct PlayChange {
    std::uint32_t node = kNone;
    std::string title;  // "lantern: 3.1 m away, turned by 40 degrees"
    std::vector<std::string> lines;
};

// From a world as it began to be played to what it was at the end, as a model's nodes would say it. Left out:
// the player with all that is below it, cameras, `animated` nodes of the document, which come and go by
// themselves, and what has moved by less than kLeastMetres and kLeastDegrees. Fields of components are none
// of it: what the simulation writes of those is in no file.
std::vector<PlayChange> play_changes(const EditModel& model,
                                     const std::map<std::uint32_t, PlayedNode>& before,
                                     const std::map<std::uint32_t, PlayedNode>& after,
                                     const std::vector<std::uint32_t>& animated);
inline constexpr double kLeastMetres = 0.01, kLeastDegrees = 1;

}  // namespace lanthorn::editor
