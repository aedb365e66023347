#include "engine/runtime/view_cameras.h"

#include <fmt/format.h>

#include "engine/core/finite.h"
#include "engine/scene/described.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/view.h"

namespace lanthorn {

namespace {

void check_camera(const ecs::World& world, ViewId id, const View& view) {
    if (!view.is_drawn() || view.placed || !view.camera) {
        return;
    }
    const char* problem = !world.alive(view.camera)                                ? "has been destroyed"
                          : world.try_get<CameraComponent>(view.camera) == nullptr ? "has no CameraComponent"
                          : world.try_get<WorldTransform>(view.camera) == nullptr  ? "has no WorldTransform"
                                                                                   : nullptr;
    if (problem != nullptr) {
        throw Error(ExitCode::bad_input,
                    fmt::format("{}: its camera, {}, {}; expected an entity with a camera, or none",
                                described_view(id, view), ecs::to_string(view.camera), problem));
    }
}

}  // namespace

ecs::Entity camera_entity(const ecs::World& world, const View& view) {
    return world.try_get<CameraComponent>(view.camera) != nullptr &&
                   world.try_get<WorldTransform>(view.camera) != nullptr
               ? view.camera
               : ecs::kNullEntity;
}

void check_cameras(const ecs::World& world) {
    check_camera(world, ViewId::first, world.resource<View>());
    for (const auto& [id, view] : world.resource<Views>().all()) {
        check_camera(world, id, view);
    }
}

std::optional<CameraView> look_of(const ecs::World& world, const View& view, const dvec3& origin) {
    const auto with_fov = [&](CameraView look) {
        look.camera.y_fov = view.y_fov.value_or(look.camera.y_fov);
        return look;
    };
    if (view.placed) {
        return with_fov(*view.placed);
    }
    const bool there = view.camera && world.alive(view.camera);
    const auto* lens = there ? world.try_get<CameraComponent>(view.camera) : nullptr;
    const auto* at = there ? world.try_get<WorldTransform>(view.camera) : nullptr;
    if (lens == nullptr || at == nullptr || !is_finite(at->matrix)) {
        return std::nullopt;
    }
    const CameraView look = camera_view(lens->camera, at->matrix, origin);
    return is_finite(look.position) ? std::optional(with_fov(look)) : std::nullopt;
}

}  // namespace lanthorn
