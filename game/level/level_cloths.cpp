// Cloths of a level that begins.
#include <utility>
#include <vector>

#include "game/level/level_starts.h"
#include "game/rules/cloth.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/hierarchy.h"

namespace lanthorn::game {

using ecs::Entity;
using ecs::World;

void start_cloths(World& world, const std::string& source) {
    for (const Entity e : world.query<ecs::With<Cloth>>().entities()) {
        Cloth cloth = world.get<Cloth>(e);
        const SkinInstance* skin = world.try_get<SkinInstance>(e);
        if (skin == nullptr || skin->joints.size() != std::size_t{cloth.columns} * cloth.rows) {
            fail(world, e, source, "has a cloth, expected a skin of columns times rows joints");
        }
        std::vector<dvec3> points;
        for (const Entity joint : std::vector<Entity>(skin->joints)) {
            if (parent_of(world, joint) != e) {
                fail(world, e, source, "has a cloth, expected the joints of its skin right below it");
            }
            points.push_back(world.get<LocalTransform>(joint).value.translation);
            world.insert(joint, Interpolated{});
        }
        start_cloth(cloth, std::move(points));
        world.get_mut<Cloth>(e) = std::move(cloth);
    }
}

}  // namespace lanthorn::game
