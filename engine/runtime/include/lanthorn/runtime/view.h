// What the picture shows: a resource of every App, altered between frames.
#pragma once

#include <optional>

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/entity.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {

struct View {
    ivec2 size{512, 512};  // pixels
    // With a CameraComponent and a WorldTransform; null: a camera that sees everything.
    ecs::Entity camera = ecs::kNullEntity;
    // Instead of the entity: in the render space of the FrameScene before (FrameScene::origin).
    std::optional<CameraView> placed;
};

}  // namespace lanthorn
