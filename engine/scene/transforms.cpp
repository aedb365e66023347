#include "lanthorn/scene/transforms.h"

#include <algorithm>
#include <span>
#include <utility>

namespace lanthorn {
namespace {

using ecs::Changed;
using ecs::Entity;
using ecs::With;
using ecs::Without;

// Sorted, without repetition.
template <class T>
void sort_once(std::vector<T>& list) {
    if (!std::is_sorted(list.begin(), list.end())) std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

// The same for many numbers below `end`, in O(end).
void in_node_order(std::vector<std::uint32_t>& numbers, std::size_t end) {
    std::vector<bool> marked(end);
    for (const std::uint32_t i : numbers) marked[i] = true;
    numbers.clear();
    for (std::size_t i = 0; i < end; ++i) {
        if (marked[i]) numbers.push_back(static_cast<std::uint32_t>(i));
    }
}

}  // namespace

dmat4 local_matrix(const Transform& local, const mat3& shear) {
    const dmat4 m = local.matrix();
    return shear == mat3(1) ? m : m * dmat4(glm::dmat3(shear));
}

std::uint32_t Transforms::Tree::find(Entity e) const {
    if (e.index >= node_of.size() || node_of[e.index] == kNone) {
        return kNone;
    }
    return nodes[node_of[e.index]].entity == e ? node_of[e.index] : kNone;
}

Entity Transforms::Tree::parent_of(std::uint32_t node) const {
    const std::uint32_t parent = nodes[node].parent;
    return parent == kNone ? ecs::kNullEntity : nodes[parent].entity;
}

Transforms::Counts Transforms::count(const ecs::World& world) {
    return {parents_.in(world).count(), children_.in(world).count(), inner_.in(world).count()};
}

bool Transforms::hierarchy_changed(const ecs::World& world) {
    return world.id() != world_id_ || count(world) != counts_ || !new_parents_.in(world, since_).empty() ||
           !new_children_.in(world, since_).empty() || !new_inner_.in(world, since_).empty();
}

void Transforms::add_tree(const ecs::World& world, Entity root) {
    struct Open {
        std::uint32_t node;
        std::span<const Entity> left;  // of its children
    };
    std::vector<Open> path;
    const auto enter = [&](Entity e, std::uint32_t parent) {
        const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.push_back({e, parent, 0});
        if (e.index >= tree_.node_of.size()) {
            tree_.node_of.resize(e.index + 1, kNone);
        }
        tree_.node_of[e.index] = index;
        path.push_back({index, children_of(world, e)});
    };
    enter(root, kNone);
    while (!path.empty()) {
        Open& open = path.back();
        if (open.left.empty()) {
            tree_.nodes[open.node].end = static_cast<std::uint32_t>(tree_.nodes.size());
            path.pop_back();
            continue;
        }
        const Entity child = open.left.front();
        open.left = open.left.subspan(1);
        if (world.has<LocalTransform>(child)) {
            enter(child, open.node);
        }
    }
}

void Transforms::rebuild(const ecs::World& world) {
    tree_ = {};
    inner_.in(world).each([&](Entity e) {
        const Parent* parent = world.try_get<Parent>(e);
        if (!parent || !world.has<LocalTransform>(parent->entity)) {
            add_tree(world, e);
        }
    });
    counts_ = count(world);
    world_id_ = world.id();
}

void Transforms::compare(const ecs::World& world, const Tree& before, std::vector<Entity>& dirty) const {
    for (std::uint32_t i = 0; i < tree_.nodes.size(); ++i) {
        const std::uint32_t old = before.find(tree_.nodes[i].entity);
        const Entity old_parent = old == kNone ? ecs::kNullEntity : before.parent_of(old);
        if (old_parent != tree_.parent_of(i)) {
            dirty.push_back(tree_.nodes[i].entity);
        }
    }
    for (const Node& node : before.nodes) {
        if (tree_.find(node.entity) == kNone && world.has<LocalTransform>(node.entity)) {
            dirty.push_back(node.entity);
        }
    }
}

const dmat4* Transforms::compute(const ecs::World& world, const Writes& writes, Entity e,
                                 const dmat4* parent) const {
    const WorldTransform* before = writes.try_get<WorldTransform>(e);
    if (!before) {
        return nullptr;
    }
    const LocalTransform* local = world.try_get<LocalTransform>(e);
    if (!local) {
        return &before->matrix;
    }
    const Shear* shear = shears_ > 0 ? world.try_get<Shear>(e) : nullptr;
    dmat4 matrix = local_matrix(local->value, shear ? shear->value : mat3(1));
    if (parent) matrix = *parent * matrix;
    if (before->matrix != matrix) {
        writes.try_get_mut<WorldTransform>(e)->matrix = matrix;
    }
    return &before->matrix;
}

const dmat4* Transforms::matrix_of(const Writes& writes, std::uint32_t node) const {
    const WorldTransform* at = writes.try_get<WorldTransform>(tree_.nodes[node].entity);
    return at ? &at->matrix : nullptr;
}

std::size_t Transforms::update(ecs::World& world) {
    for (const Entity e : world.query<With<LocalTransform>, Without<WorldTransform>>().entities()) {
        world.add(e, WorldTransform{});
    }
    const ecs::Tick now = world.mark();
    return update(world, Writes(world), now);
}

std::size_t Transforms::update(const ecs::World& world, const Writes& writes, ecs::Tick now) {
    if (world.id() != world_id_) {
        since_ = 0;
        tree_ = {};
    }
    std::vector<Entity> dirty = new_worlds_.in(world, since_).entities();
    if (hierarchy_changed(world)) {
        const Tree before = std::exchange(tree_, {});
        rebuild(world);
        compare(world, before, dirty);
    }
    const auto changed = moved_.in(world, since_).entities();
    dirty.insert(dirty.end(), changed.begin(), changed.end());
    const std::size_t shears = sheared_.in(world).count();
    if (shears < shears_)
        dirty = world.query<With<LocalTransform>>().entities();  // which lost it is not known
    shears_ = shears;
    since_ = now;

    std::size_t computed = 0;
    std::vector<std::uint32_t> tops;
    std::vector<Entity> free;
    for (const Entity e : dirty) {
        if (const std::uint32_t node = tree_.find(e); node != kNone) {
            tops.push_back(node);
        } else {
            free.push_back(e);
        }
    }
    sort_once(free);
    for (const Entity e : free) compute(world, writes, e, nullptr);
    computed += free.size();

    const std::vector<Node>& nodes = tree_.nodes;
    if (tops.size() > nodes.size() / 8) {
        in_node_order(tops, nodes.size());
    } else {
        sort_once(tops);
    }
    struct Above {
        std::uint32_t node;
        const dmat4* matrix;  // null: it has no WorldTransform
    };
    std::vector<Above> path;  // down to the parent of the next node
    std::uint32_t done = 0;
    for (const std::uint32_t top : tops) {
        path.clear();
        for (std::uint32_t i = std::max(top, done); i < nodes[top].end; ++i, ++computed) {
            const Node& node = nodes[i];
            while (!path.empty() && path.back().node != node.parent) {
                path.pop_back();
            }
            if (path.empty() && node.parent != kNone) {
                path.push_back({node.parent, matrix_of(writes, node.parent)});
            }
            const dmat4* parent = path.empty() ? nullptr : path.back().matrix;
            const dmat4* matrix = compute(world, writes, node.entity, parent);
            if (node.end > i + 1) {
                path.push_back({i, matrix});
            }
        }
        done = std::max(done, nodes[top].end);
    }
    return computed;
}

}  // namespace lanthorn
