// Vertex arrays that go out with a frame and are written anew once nobody holds them any more.
#pragma once

#include <memory>
#include <vector>

#include "lanthorn/scene/deformed_mesh.h"

namespace lanthorn::deform {

class FramePool {
  public:
    // An array of `vertices` that nobody else holds; what is in it is left from before. Allocates only while
    // all of the right size are held: the pool grows to one more than are ever held at a time.
    std::shared_ptr<std::vector<VertexFrame>> take(std::size_t vertices);

  private:
    std::vector<std::shared_ptr<std::vector<VertexFrame>>> arrays_;
};

}  // namespace lanthorn::deform
