// The pictures of a FrameRenderer, all of one size.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "engine/render/air.h"
#include "engine/render/direct.h"
#include "engine/render/upscaler.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/render/composite.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/render/gbuffer.h"
#include "lanthorn/render/picture_only.h"

namespace lanthorn::render {

struct FrameRenderer::Targets {
    explicit Targets(ivec2 size)
        : gbuffer(size),
          direct(size),
          composite(size, gbuffer.depth()),
          display({&composite.final()}, &gbuffer.depth()) {}
    GBuffer gbuffer;
    std::unique_ptr<GBuffer> blended;  // where something blended is in view
    DirectLight direct;
    std::unique_ptr<AirLight> air;  // once asked for
    Composite composite;
    std::unique_ptr<Upscaler> upscaler;  // where fewer pixels are drawn than are shown
    gpu::Framebuffer display;            // the composite's final picture, with the G-buffer's depth

    // What the G-buffer and the direct light in it were drawn for.
    struct Drawn {
        std::uint64_t frame;
        CameraView camera;
        dvec3 origin;
        RenderSettings settings;
        std::optional<std::uint64_t> light_maps;  // version, where direct light is drawn
        float traced_roughness = 0;
        Looks looks = {};
    };
    std::optional<Drawn> drawn;   // nothing: they are to be drawn
    bool keeps_surfaces = false;  // in this frame
};

}  // namespace lanthorn::render
