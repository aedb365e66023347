// The pictures of a FrameRenderer, all of one size.
#pragma once

#include "engine/render/direct.h"
#include "lanthorn/render/composite.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/render/gbuffer.h"

namespace lanthorn::render {

struct FrameRenderer::Targets {
    explicit Targets(ivec2 size) : gbuffer(size), direct(size), composite(size, gbuffer.depth()) {}
    GBuffer gbuffer;
    DirectLight direct;
    Composite composite;
};

}  // namespace lanthorn::render
