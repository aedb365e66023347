#include "gi_module/techniques/vertex-map/kept_tree.h"

#include <algorithm>

namespace lanthorn::gi {

namespace {

constexpr std::uint32_t kLeafAxis = 3;
constexpr float kLeans = 0.7f;  // the share of a node's photons from which on one side has too many

// The axis along which they spread widest; kLeafAxis if they all lie in one point.
template <class Entry>
std::uint32_t widest_axis(const Entry* first, const Entry* last) {
    Aabb box;
    for (const Entry* e = first; e != last; ++e) {
        box.add(e->position);
    }
    const vec3 size = box.size();
    const std::uint32_t axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    return size[static_cast<glm::length_t>(axis)] > 0 ? axis : kLeafAxis;
}

}  // namespace

void KeptTree::update(const PhotonStore& store, bool anew) {
    if (anew || where_.size() != store.places().size()) {
        where_.assign(store.places().size(), {});
        nodes_.clear();
        leaves_.clear();
        free_pairs_.clear();
        free_leaves_.clear();
        roots_.clear();
        size_ = store.used();
        std::unordered_map<SurfaceKey, std::vector<Entry>> by_surface;
        for (std::size_t i = 0; i < where_.size(); ++i) {
            if (store[i].used) {
                by_surface[key(store[i])].push_back({store[i].position, static_cast<std::uint32_t>(i)});
            }
        }
        for (auto& [surface, entries] : by_surface) {
            const std::uint32_t root = root_of(surface);
            free_leaves_.push_back(nodes_[root].child);
            build(root, entries.data(), entries.data() + entries.size());
        }
        return;
    }
    for (const std::uint32_t place : store.changed()) {
        if (where_[place].node != kNone) {
            remove(place);
        }
        if (store[place].used) {
            insert(key(store[place]), {store[place].position, place});
        }
    }
}

std::uint32_t KeptTree::root_of(SurfaceKey surface) {
    const auto [at, fresh] = roots_.try_emplace(surface, 0);
    if (fresh) {
        at->second = new_pair();  // the second of them stays empty
        make_leaf(at->second, nullptr, nullptr);
    }
    return at->second;
}

void KeptTree::make_leaf(std::uint32_t node, const Entry* first, const Entry* last) {
    const std::uint32_t leaf = new_leaf();
    nodes_[node].axis = kLeafAxis;
    nodes_[node].child = leaf;
    leaves_[leaf].assign(first, last);
    std::uint32_t i = 0;
    for (const Entry* e = first; e != last; ++e) {
        where_[e->place] = {node, i++};
    }
}

// About the median; false if they all lie in one point.
bool KeptTree::split(std::uint32_t node, Entry* first, Entry* last, Entry*& middle) {
    const std::uint32_t wide = widest_axis(first, last);
    if (wide == kLeafAxis) {
        return false;
    }
    const auto axis = static_cast<glm::length_t>(wide);
    middle = first + (last - first) / 2;
    std::nth_element(first, middle, last,
                     [axis](const Entry& a, const Entry& b) { return a.position[axis] < b.position[axis]; });
    float at = middle->position[axis];
    middle = std::partition(first, last, [&](const Entry& e) { return e.position[axis] < at; });
    if (middle == first) {  // many lie at the lowest: the split is the next above it
        float above = std::numeric_limits<float>::infinity();
        for (const Entry* e = first; e != last; ++e) {
            above = e->position[axis] > at ? std::min(above, e->position[axis]) : above;
        }
        at = above;
        middle = std::partition(first, last, [&](const Entry& e) { return e.position[axis] < at; });
    }
    nodes_[node].axis = wide;
    nodes_[node].split = at;
    return true;
}

void KeptTree::build(std::uint32_t node, Entry* first, Entry* last) {
    const auto count = static_cast<std::size_t>(last - first);
    nodes_[node].count = static_cast<std::uint32_t>(count);
    nodes_[node].changes = 0;
    Entry* middle = nullptr;
    if (count <= kLeaf || !split(node, first, last, middle)) {
        make_leaf(node, first, last);
        return;
    }
    const std::uint32_t pair = new_pair();
    nodes_[node].child = pair;
    nodes_[pair].parent = nodes_[pair + 1].parent = node;
    build(pair, first, middle);
    build(pair + 1, middle, last);
}

std::uint32_t KeptTree::new_pair() {
    if (!free_pairs_.empty()) {
        const std::uint32_t pair = free_pairs_.back();
        free_pairs_.pop_back();
        nodes_[pair] = nodes_[pair + 1] = {};
        return pair;
    }
    nodes_.resize(nodes_.size() + 2);
    return static_cast<std::uint32_t>(nodes_.size() - 2);
}

std::uint32_t KeptTree::new_leaf() {
    if (!free_leaves_.empty()) {
        const std::uint32_t leaf = free_leaves_.back();
        free_leaves_.pop_back();
        return leaf;
    }
    leaves_.emplace_back();
    return static_cast<std::uint32_t>(leaves_.size() - 1);
}

void KeptTree::take_out(std::uint32_t node, std::vector<Entry>& entries) {
    const Node& n = nodes_[node];
    if (n.axis == kLeafAxis) {
        entries.insert(entries.end(), leaves_[n.child].begin(), leaves_[n.child].end());
        leaves_[n.child].clear();
        free_leaves_.push_back(n.child);
        return;
    }
    take_out(n.child, entries);
    take_out(n.child + 1, entries);
    free_pairs_.push_back(n.child);
}

void KeptTree::rebuild(std::uint32_t node) {
    scratch_.clear();
    take_out(node, scratch_);
    rebuilt_ += scratch_.size();
    build(node, scratch_.data(), scratch_.data() + scratch_.size());
}

void KeptTree::count_change(std::uint32_t node, bool comes) {
    std::uint32_t leaning = kNone;  // the highest
    for (std::uint32_t at = node; at != kNone; at = nodes_[at].parent) {
        Node& n = nodes_[at];
        n.count += comes ? 1u : 0xffffffffu;
        if (n.axis == kLeafAxis || ++n.changes <= std::max<std::uint32_t>(n.count / 2, 2 * kLeaf)) {
            continue;
        }
        n.changes = 0;
        const auto larger = static_cast<float>(std::max(nodes_[n.child].count, nodes_[n.child + 1].count));
        if (n.count <= kLeaf || larger > kLeans * static_cast<float>(n.count)) {
            leaning = at;
        }
    }
    if (leaning != kNone) {
        rebuild(leaning);
    }
}

void KeptTree::insert(SurfaceKey surface, const Entry& entry) {
    ++size_;
    std::uint32_t at = root_of(surface);
    while (nodes_[at].axis != kLeafAxis) {
        const Node& n = nodes_[at];
        at = n.child + (entry.position[static_cast<glm::length_t>(n.axis)] < n.split ? 0 : 1);
    }
    std::vector<Entry>& leaf = leaves_[nodes_[at].child];
    where_[entry.place] = {at, static_cast<std::uint32_t>(leaf.size())};
    leaf.push_back(entry);
    const std::size_t size = leaf.size();
    count_change(at, true);
    // A leaf is split when it has more than twice what it was built for, so that few that come cost nothing;
    // where all lie in one point that is tried each time their number has doubled.
    const bool doubled = size > 2 * kLeaf && ((size - 1) & (size - 2)) == 0;
    if (doubled && where_[entry.place].node == at) {
        rebuild(at);
    }
}

void KeptTree::remove(std::uint32_t place) {
    const Where gone = where_[place];
    where_[place] = {};
    --size_;
    std::vector<Entry>& leaf = leaves_[nodes_[gone.node].child];
    leaf[gone.entry] = leaf.back();
    leaf.pop_back();
    if (gone.entry < leaf.size()) {
        where_[leaf[gone.entry].place].entry = gone.entry;
    }
    count_change(gone.node, false);
}

struct KeptTree::Search {
    vec3 point;
    float radius2;
    std::vector<NearPhoton>& found;
};

// `off`: how far the point lies outside the node's cell along each axis (Arya and Mount 1993).
void KeptTree::search(std::uint32_t node, Search& s, vec3& off) const {
    while (nodes_[node].axis != kLeafAxis) {
        const Node& n = nodes_[node];
        const auto axis = static_cast<glm::length_t>(n.axis);
        const float to_split = s.point[axis] - n.split;
        const std::uint32_t beyond = to_split < 0 ? 1 : 0;
        const float before = off[axis];
        off[axis] = to_split;
        if (glm::dot(off, off) <= s.radius2) {
            search(n.child + beyond, s, off);
        }
        off[axis] = before;
        node = n.child + 1 - beyond;
    }
    // Each is written and counts if it lies within: as many do as do not, and a branch would be guessed wrong
    // half the time.
    const std::vector<Entry>& leaf = leaves_[nodes_[node].child];
    std::size_t count = s.found.size();
    s.found.resize(count + leaf.size());
    for (const Entry& e : leaf) {
        const vec3 span = e.position - s.point;
        const float d2 = glm::dot(span, span);
        s.found[count] = {d2, e.place};
        count += d2 <= s.radius2 ? 1 : 0;
    }
    s.found.resize(count);
}

void KeptTree::within(SurfaceKey surface, const vec3& point, float radius,
                      std::vector<NearPhoton>& found) const {
    const auto root = roots_.find(surfaces_ == TreeSurfaces::apart ? surface : SurfaceKey{0});
    if (root != roots_.end()) {
        Search s{point, radius * radius, found};
        vec3 off(0);
        search(root->second, s, off);
    }
}

std::size_t KeptTree::depth() const {
    std::size_t deepest = 0;
    for (const auto& [surface, root] : roots_) {
        deepest = std::max(deepest, depth(root));
    }
    return deepest;
}

std::size_t KeptTree::depth(std::uint32_t node) const {
    const Node& n = nodes_[node];
    return n.axis == kLeafAxis ? 1 : 1 + std::max(depth(n.child), depth(n.child + 1));
}

}  // namespace lanthorn::gi
