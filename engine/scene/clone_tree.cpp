#include "lanthorn/scene/clone_tree.h"

#include "lanthorn/scene/hierarchy.h"

namespace lanthorn {

std::vector<ecs::Entity> clone_tree(ecs::World& world, const ecs::Registry& registry, ecs::Entity root) {
    std::vector<ecs::Entity> tree{root};
    const std::vector<ecs::Entity> below = descendants(world, root);
    tree.insert(tree.end(), below.begin(), below.end());
    return ecs::clone(world, registry, tree);
}

}  // namespace lanthorn
