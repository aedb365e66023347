#include "lanthorn/scene/transforms.h"

#include <algorithm>
#include <unordered_map>

#include "lanthorn/ecs/query.h"

namespace lanthorn {
namespace {

using ecs::Changed;
using ecs::Entity;
using ecs::Read;
using ecs::With;
using ecs::Without;

std::string described(const ecs::World& world, Entity e) {
    const Name* name = world.try_get<Name>(e);
    return name ? ecs::to_string(e) + " '" + name->value + "'" : ecs::to_string(e);
}

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

bool Transforms::hierarchy_changed(ecs::World& world) const {
    if (world.id() != world_id_) return true;
    // Whatever was added or altered shows as changed; whatever was removed lowers a count.
    if (world.query<With<Parent>>().count() != parents_) return true;
    if (world.query<With<Parent, LocalTransform>>().count() != children_) return true;
    if (!world.query<Changed<Parent>>(since_).empty()) return true;
    return std::any_of(roots_.begin(), roots_.end(),
                       [&](std::uint32_t root) { return !world.has<LocalTransform>(nodes_[root].entity); });
}

void Transforms::rebuild(ecs::World& world) {
    std::vector<std::pair<Entity, Entity>> links;  // parent, child
    world.query<Read<Parent>>().each(
        [&](Entity e, const Parent& parent) { links.emplace_back(parent.entity, e); });
    std::sort(links.begin(), links.end());
    for (const auto& [parent, child] : links) {
        if (!world.has<LocalTransform>(parent)) {
            throw ecs::Error("transforms: the parent of " + described(world, child) + ", " +
                             described(world, parent) +
                             (world.alive(parent) ? ", has no LocalTransform" : ", is not alive"));
        }
    }
    const auto children_of = [&](Entity e) {
        return std::lower_bound(links.begin(), links.end(), std::pair(e, Entity{0, 0}));
    };
    nodes_.clear();
    roots_.clear();
    node_of_.clear();
    struct Open {
        std::uint32_t node;
        std::vector<std::pair<Entity, Entity>>::const_iterator next;
    };
    std::vector<Open> path;
    const auto enter = [&](Entity e, std::uint32_t parent) {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({e, parent, 0});
        if (e.index >= node_of_.size()) node_of_.resize(e.index + 1, kNone);
        node_of_[e.index] = index;
        path.push_back({index, children_of(e)});
    };
    for (auto it = links.begin(); it != links.end(); ++it) {
        const Entity root = it->first;
        if (it != links.begin() && std::prev(it)->first == root) continue;
        if (world.has<Parent>(root)) continue;
        roots_.push_back(static_cast<std::uint32_t>(nodes_.size()));
        enter(root, kNone);
        while (!path.empty()) {
            Open& open = path.back();
            if (open.next != links.end() && open.next->first == nodes_[open.node].entity) {
                const Entity child = (open.next++)->second;
                enter(child, open.node);
            } else {
                nodes_[open.node].end = static_cast<std::uint32_t>(nodes_.size());
                path.pop_back();
            }
        }
    }
    // What no root leads to goes round in a circle, or hangs below one: walking up leads into it.
    for (const auto& link : links) {
        if (find(link.second)) continue;
        std::vector<Entity> walked;
        Entity at = link.second;
        while (std::find(walked.begin(), walked.end(), at) == walked.end()) {
            walked.push_back(at);
            at = world.get<Parent>(at).entity;
        }
        std::string text = "transforms: cycle of parents: " + described(world, at);
        for (auto it = std::find(walked.begin(), walked.end(), at) + 1; it != walked.end(); ++it) {
            text += " is below " + described(world, *it) + ", which";
        }
        throw ecs::Error(text + " is below " + described(world, at));
    }
    world_id_ = world.id();
    parents_ = links.size();
    children_ = world.query<With<Parent, LocalTransform>>().count();
}

const Transforms::Node* Transforms::find(Entity e) const {
    if (e.index >= node_of_.size() || node_of_[e.index] == kNone) return nullptr;
    const Node& node = nodes_[node_of_[e.index]];
    return node.entity == e ? &node : nullptr;
}

void Transforms::compute(ecs::World& world, Entity e, const dmat4* parent) const {
    const LocalTransform* local = world.try_get<LocalTransform>(e);
    if (!local) return;
    const Shear* shear = world.try_get<Shear>(e);
    dmat4 matrix = local_matrix(local->value, shear ? shear->value : mat3(1));
    if (parent) matrix = *parent * matrix;
    if (world.get<WorldTransform>(e).matrix != matrix) world.get_mut<WorldTransform>(e).matrix = matrix;
}

std::size_t Transforms::update(ecs::World& world) {
    if (world.id() != world_id_) since_ = 0;
    std::vector<Entity> dirty = world.query<With<LocalTransform>, Without<WorldTransform>>().entities();
    for (const Entity e : dirty) world.add(e, WorldTransform{});
    bool everything = false;
    if (hierarchy_changed(world)) {
        // Children of a removed Parent changed too, and nothing tells which: all that have or had a parent.
        everything = true;
        for (const Node& node : nodes_) {
            if (world.id() == world_id_ && world.has<LocalTransform>(node.entity))
                dirty.push_back(node.entity);
        }
        world_id_ = 0;  // until it succeeds
        rebuild(world);
    }
    const auto changed = world.query<With<LocalTransform>, Changed<LocalTransform, Shear>>(since_).entities();
    dirty.insert(dirty.end(), changed.begin(), changed.end());
    const std::size_t shears = world.query<With<Shear>>().count();
    if (shears < shears_)
        dirty = world.query<With<LocalTransform>>().entities();  // which lost it is not known
    shears_ = shears;
    since_ = world.mark();

    std::size_t computed = 0;
    std::vector<std::uint32_t> tops;
    std::vector<Entity> free;
    if (everything) tops = roots_;
    for (const Entity e : dirty) {
        if (const Node* node = find(e)) {
            tops.push_back(static_cast<std::uint32_t>(node - nodes_.data()));
        } else {
            free.push_back(e);
        }
    }
    sort_once(free);
    for (const Entity e : free) compute(world, e, nullptr);
    computed += free.size();

    if (tops.size() > nodes_.size() / 8) {
        in_node_order(tops, nodes_.size());
    } else {
        sort_once(tops);
    }
    std::uint32_t done = 0;
    for (const std::uint32_t top : tops) {
        for (std::uint32_t i = std::max(top, done); i < nodes_[top].end; ++i, ++computed) {
            const Node& node = nodes_[i];
            if (node.parent == kNone) {
                compute(world, node.entity, nullptr);
            } else {
                const dmat4 parent = world.get<WorldTransform>(nodes_[node.parent].entity).matrix;
                compute(world, node.entity, &parent);
            }
        }
        done = std::max(done, nodes_[top].end);
    }
    return computed;
}

}  // namespace lanthorn
