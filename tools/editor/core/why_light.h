// "Why is this light here?": asked of a pixel of the edited scene.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gi_module/reference/light_split.h"
#include "lanthorn/core/settings.h"
#include "tools/editor/core/edit_session.h"

namespace lanthorn::editor {

struct WhyAnswer {
    reference::LitPoint point;
    reference::LightSplit split;
    dvec3 at{0};           // the point in the world
    dvec3 origin{0};       // what places of the split are relative to
    double built_ms = 0;   // for the rays' structure; 0: it was there
    double traced_ms = 0;  // for the answer itself
};

class WhyLight {
  public:
    // Of a frame that has been drawn, or shown without pictures; rows from the top. Nothing where no surface
    // is seen. The rays' structure is kept while no surface changes: then an answer takes what 4096 paths
    // take. Throws InputError for what Embree cannot hold.
    std::optional<WhyAnswer> ask(const FrameScene& frame, const Settings& settings, ivec2 size, ivec2 pixel);
    // Made ready, so that the next answer does not wait for it. Whether there was anything to do.
    bool prepare(const FrameScene& frame, const Settings& settings);
    void forget() { splitter_.reset(); }

  private:
    std::unique_ptr<reference::LightSplitter> splitter_;
    std::string settings_;  // that it was made with
};

// What the session calls an entity, by its index: its node's name, "guest" for lent lights.
std::function<std::string(std::uint32_t)> names_in(EditSession& session);

}  // namespace lanthorn::editor
