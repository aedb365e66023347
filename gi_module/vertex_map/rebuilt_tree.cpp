#include <nanoflann.hpp>

#include "lanthorn/vertex_map/photon_tree.h"

namespace lanthorn::gi {

namespace {

// The photons as nanoflann reads them.
struct Points {
    std::vector<vec3> positions;
    std::vector<std::uint32_t> places;

    std::size_t kdtree_get_point_count() const { return positions.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t axis) const {
        return positions[i][static_cast<glm::length_t>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Points>, Points, 3,
                                                  std::uint32_t>;

// Takes whatever lies within.
struct Collector {
    float radius2;
    const std::vector<std::uint32_t>& places;
    std::vector<NearPhoton>& found;

    bool addPoint(float distance2, std::uint32_t i) {
        found.push_back({distance2, places[i]});
        return true;
    }
    float worstDist() const { return radius2; }
    bool full() const { return true; }
};

class RebuiltTree final : public PhotonTree {
  public:
    void update(const PhotonStore& store, bool anew) override {
        if (!anew && store.changed().empty()) {
            return;
        }
        points_.positions.clear();
        points_.places.clear();
        for (std::size_t i = 0; i < store.places().size(); ++i) {
            if (store[i].used) {
                points_.positions.push_back(store[i].position);
                points_.places.push_back(static_cast<std::uint32_t>(i));
            }
        }
        index_ = points_.places.empty()
                     ? nullptr
                     : std::make_unique<Index>(3, points_, nanoflann::KDTreeSingleIndexAdaptorParams(16));
    }

    void within(const vec3& point, float radius, std::vector<NearPhoton>& found) const override {
        if (index_) {
            // nanoflann takes what is nearer than the bound, and what lies at it counts too.
            Collector collector{std::nextafter(radius * radius, std::numeric_limits<float>::infinity()),
                                points_.places, found};
            index_->findNeighbors(collector, &point.x, nanoflann::SearchParams());
        }
    }

    std::size_t size() const override { return points_.places.size(); }

  private:
    Points points_;
    std::unique_ptr<Index> index_;
};

}  // namespace

std::unique_ptr<PhotonTree> make_rebuilt_tree() {
    return std::make_unique<RebuiltTree>();
}

}  // namespace lanthorn::gi
