#include <nanoflann.hpp>
#include <span>
#include <unordered_map>
#include <utility>

#include "gi_module/techniques/vertex-map/photon_tree.h"

namespace lanthorn::gi {

namespace {

struct Point {
    vec3 position;
    std::uint32_t place;
};

// The photons of a surface as nanoflann reads them.
struct Points {
    std::span<const Point> all;

    std::size_t kdtree_get_point_count() const { return all.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t axis) const {
        return all[i].position[static_cast<glm::length_t>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Points>, Points, 3,
                                                  std::uint32_t>;

struct Surface {
    Points points;
    Index index;
    explicit Surface(std::span<const Point> all)
        : points{all}, index(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {}
};

// Takes whatever lies within.
struct Collector {
    float radius2;
    std::span<const Point> points;
    std::vector<NearPhoton>& found;

    bool addPoint(float distance2, std::uint32_t i) {
        found.push_back({distance2, points[i].place});
        return true;
    }
    float worstDist() const { return radius2; }
    bool full() const { return true; }
};

class RebuiltTree final : public PhotonTree {
  public:
    explicit RebuiltTree(TreeSurfaces surfaces) : surfaces_(surfaces) {}

    void update(const PhotonStore& store, bool anew) override {
        if (!anew && store.changed().empty()) {
            return;
        }
        by_key_.clear();
        const auto key = [&](const StoredPhoton& p) {
            return surfaces_ == TreeSurfaces::apart ? p.surface : SurfaceKey{0};
        };
        std::unordered_map<SurfaceKey, std::size_t> next;  // where a surface's photons go
        for (const StoredPhoton& photon : store.places()) {
            next[key(photon)] += photon.used ? 1 : 0;
        }
        std::size_t first = 0;
        std::vector<std::pair<SurfaceKey, std::size_t>> counts(next.begin(), next.end());
        for (const auto& [surface, count] : counts) {
            next[surface] = first;
            first += count;
        }
        points_.resize(first);
        for (std::size_t i = 0; i < store.places().size(); ++i) {
            if (store[i].used) {
                points_[next[key(store[i])]++] = {store[i].position, static_cast<std::uint32_t>(i)};
            }
        }
        first = 0;
        for (const auto& [surface, count] : counts) {
            if (count > 0) {
                by_key_.emplace(surface, std::make_unique<Surface>(
                                             std::span<const Point>(points_).subspan(first, count)));
            }
            first += count;
        }
    }

    void within(SurfaceKey surface, const vec3& point, float radius,
                std::vector<NearPhoton>& found) const override {
        const auto at = by_key_.find(surfaces_ == TreeSurfaces::apart ? surface : SurfaceKey{0});
        if (at != by_key_.end()) {
            // nanoflann takes what is nearer than the bound, and what lies at it counts too.
            Collector collector{std::nextafter(radius * radius, std::numeric_limits<float>::infinity()),
                                at->second->points.all, found};
            at->second->index.findNeighbors(collector, &point.x, nanoflann::SearchParams());
        }
    }

    std::size_t size() const override { return points_.size(); }

  private:
    TreeSurfaces surfaces_;
    std::vector<Point> points_;  // surface by surface
    std::unordered_map<SurfaceKey, std::unique_ptr<Surface>> by_key_;
};

}  // namespace

std::unique_ptr<PhotonTree> make_rebuilt_tree(TreeSurfaces surfaces) {
    return std::make_unique<RebuiltTree>(surfaces);
}

}  // namespace lanthorn::gi
