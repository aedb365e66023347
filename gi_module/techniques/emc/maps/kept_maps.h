// Environment maps of rooms left behind, for when the camera comes back: what stands still in them, and what
// rays from their lit texels have met. Within a budget of GPU memory; those used longest ago go first.
#pragma once

#include <functional>
#include <list>
#include <memory>

#include "gi_module/techniques/emc/gather/kept_rays.h"
#include "gi_module/techniques/emc/maps/map_renderer.h"

namespace lanthorn::gi {

struct KeptMap {
    vec3 centre{0};                        // render space
    CubeMaps still;                        // one slot
    std::shared_ptr<const KeptRays> rays;  // not null; none if there were none

    std::size_t bytes() const { return still.bytes() + rays->bytes(); }
};

class KeptMaps {
  public:
    // The one about `centre`; null: it is not kept. It counts as used.
    const KeptMap* find(const vec3& centre);
    // Keeps it, instead of one about the same centre, and lets others go until all fit into `budget` bytes:
    // itself, too, where it alone does not.
    void keep(KeptMap map, std::size_t budget);
    void drop_if(const std::function<bool(const KeptMap&)>& outdated);

    int count() const { return static_cast<int>(maps_.size()); }
    std::size_t bytes() const;

  private:
    std::list<KeptMap> maps_;  // the last used first
};

}  // namespace lanthorn::gi
