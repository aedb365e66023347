// A k-d tree that is kept from frame to frame: a photon that goes is taken out of its leaf, one that comes is
// put into the leaf where it lies, and a part of the tree is built anew only once half as much has come
// and gone in it as it holds and it leans to one side (after the scapegoat trees of Galperin and Rivest
// 1993). So a frame costs O(per_frame max_level log total) instead of O(total log total).
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "gi_module/techniques/vertex-map/photon_tree.h"

namespace lanthorn::gi {

class KeptTree final : public PhotonTree {
  public:
    explicit KeptTree(TreeSurfaces surfaces = TreeSurfaces::apart) : surfaces_(surfaces) {}

    void update(const PhotonStore& store, bool anew) override;
    void within(SurfaceKey surface, const vec3& point, float radius,
                std::vector<NearPhoton>& found) const override;
    std::size_t size() const override { return size_; }

    // Photons that were put into a part built anew, since the tree was made: what balancing costs.
    std::uint64_t rebuilt() const { return rebuilt_; }
    // Levels of the deepest leaf. O(nodes).
    std::size_t depth() const;

  private:
    static constexpr std::size_t kLeaf = 16;  // photons that a leaf is split above, if they lie apart
    static constexpr std::uint32_t kNone = 0xffffffffu;

    struct Entry {
        vec3 position;
        std::uint32_t place;
    };
    struct Node {
        float split = 0;          // of an inner node: below it `child`, else `child` + 1
        std::uint32_t axis = 0;   // 3: a leaf
        std::uint32_t child = 0;  // first of two nodes; of a leaf: into leaves_
        std::uint32_t parent = kNone;
        std::uint32_t count = 0;    // photons beneath
        std::uint32_t changes = 0;  // come and gone since it was built
    };
    struct Where {
        std::uint32_t node = kNone;  // the leaf; kNone: not in the tree
        std::uint32_t entry = 0;
    };
    struct Search;

    SurfaceKey key(const StoredPhoton& photon) const {
        return surfaces_ == TreeSurfaces::apart ? photon.surface : SurfaceKey{0};
    }
    // The root of a surface's photons; made where there is none.
    std::uint32_t root_of(SurfaceKey surface);
    void insert(SurfaceKey surface, const Entry& entry);
    void remove(std::uint32_t place);
    // After a change beneath `node`: counts it on the way up and builds anew what leans.
    void count_change(std::uint32_t node, bool comes);
    void build(std::uint32_t node, Entry* first, Entry* last);
    void make_leaf(std::uint32_t node, const Entry* first, const Entry* last);
    bool split(std::uint32_t node, Entry* first, Entry* last, Entry*& middle);
    void rebuild(std::uint32_t node);
    void take_out(std::uint32_t node, std::vector<Entry>& entries);
    std::uint32_t new_pair();
    std::uint32_t new_leaf();
    void search(std::uint32_t node, Search& s, vec3& off) const;
    std::size_t depth(std::uint32_t node) const;

    TreeSurfaces surfaces_;
    std::unordered_map<SurfaceKey, std::uint32_t> roots_;
    std::vector<Node> nodes_;
    std::vector<std::vector<Entry>> leaves_;
    std::vector<std::uint32_t> free_pairs_, free_leaves_;
    std::vector<Where> where_;  // by place: photon_location of fig. 12
    std::vector<Entry> scratch_;
    std::size_t size_ = 0;
    std::uint64_t rebuilt_ = 0;
};

}  // namespace lanthorn::gi
