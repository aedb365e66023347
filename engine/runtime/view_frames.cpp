#include "engine/runtime/view_frames.h"

#include <algorithm>
#include <utility>

#include "engine/render/scene_renderer.h"
#include "engine/runtime/view_cameras.h"
#include "engine/scene/scene_changes.h"
#include "lanthorn/scene/view.h"

namespace lanthorn {

namespace {

// What differs from a scene of some frames ago; nothing where things came or went, or assets are others.
std::optional<SceneChanges> changes_since(const FrameScene& before, const FrameScene& now) {
    if (before.origin != now.origin || before.instances.size() != now.instances.size()) {
        return std::nullopt;
    }
    SceneChanges changes = changes_between(before, now, earlier_instances(before.instances, now.instances));
    // As many as before, and none came: none went.
    return changes.assets || !changes.arrived.empty() ? std::nullopt : std::optional(std::move(changes));
}

// The scene for a view that has none of its own yet, or of the frame before.
void see(DrawnView& drawn, const FrameScene& scene, const CameraView& look, bool goes_on) {
    const bool same_look =
        goes_on && drawn.own && drawn.own->camera == look && drawn.own->origin == scene.origin;
    if (!drawn.own) {
        drawn.own = std::make_shared<FrameScene>();
    }
    *drawn.own = scene;
    drawn.own->camera = look;
    if (goes_on) {
        drawn.own->changes.camera = !same_look;
    } else {
        drawn.own->changes = all_changed(scene);
    }
    drawn.scene = drawn.own.get();
}

std::unique_ptr<DrawnView> taken(std::vector<std::unique_ptr<DrawnView>>& before, ViewId id) {
    const auto found = std::ranges::find_if(before, [&](const auto& view) { return view && view->id == id; });
    return found == before.end() ? nullptr : std::move(*found);
}

void start(DrawnView& drawn, ViewId id, const View& view, const render::RenderSettings& settings) {
    drawn.id = id;
    drawn.name = described_view(id, view);
    drawn.frame->settings = view.settings.value_or(settings);
    const render::RenderSettings& chosen = drawn.frame->settings;
    const ivec2 whole = view.whole == ivec2(0) ? view.size : view.whole;
    const float scale = chosen.upscale == render::Upscale::none ? 1 : chosen.upscale_scale;
    drawn.frame->resize(glm::max(ivec2(glm::round(scale * vec2(view.size))), 1), whole);
}

}  // namespace

void follow_views(const ecs::World& world, const FrameScene& scene, Renderer& renderer) {
    std::vector<std::unique_ptr<DrawnView>> before = std::exchange(renderer.views, {});
    std::vector<std::unique_ptr<DrawnView>> rested = std::exchange(renderer.resting, {});
    const auto& settings = world.resource<render::RenderSettings>();
    if (!renderer.shared) {
        renderer.shared = std::make_shared<render::SceneRenderer>();
        renderer.frame = std::make_shared<render::FrameRenderer>(renderer.shared);
    }
    const View& first = world.resource<View>();
    if (first.is_drawn()) {
        std::unique_ptr<DrawnView> drawn = taken(before, ViewId::first);
        const bool goes_on = drawn && drawn->finished;
        if (!drawn) {
            drawn = std::make_unique<DrawnView>();
        }
        drawn->frame = renderer.frame;
        start(*drawn, ViewId::first, first, settings);
        drawn->restarted = !goes_on && renderer.frames > 0;
        if (drawn->restarted) {
            drawn->frame->restart();
        }
        drawn->scene = &scene;
        if (drawn->restarted) {
            see(*drawn, scene, scene.camera, false);
        } else {
            drawn->own.reset();
        }
        renderer.views.push_back(std::move(drawn));
    }
    for (const auto& [id, view] : world.resource<Views>().all()) {
        std::unique_ptr<DrawnView> waited = taken(rested, id);
        if (view.rests) {
            waited = waited ? std::move(waited) : taken(before, id);
            if (waited) {
                renderer.resting.push_back(std::move(waited));
            }
            continue;
        }
        if (!view.is_drawn()) {
            continue;
        }
        // What it has missed where it rested.
        const std::optional<SceneChanges> missed =
            waited && waited->finished ? changes_since(*waited->own, scene) : std::nullopt;
        const bool has_waited = waited != nullptr;
        std::unique_ptr<DrawnView> drawn = has_waited ? std::move(waited) : taken(before, id);
        const bool goes_on = has_waited ? missed.has_value() : drawn && drawn->finished;
        const bool known = drawn != nullptr;
        if (!drawn) {
            drawn = std::make_unique<DrawnView>();
            drawn->frame = std::make_shared<render::FrameRenderer>(renderer.shared);
        }
        start(*drawn, id, view, settings);
        drawn->restarted = known && !goes_on;
        if (drawn->restarted) {
            drawn->frame->restart();
        }
        see(*drawn, scene, look_of(world, view, scene.origin).value_or(frame_all(scene)), goes_on);
        if (missed) {
            const bool looks_elsewhere = drawn->own->changes.camera;
            drawn->own->changes = *missed;
            drawn->own->changes.camera = looks_elsewhere;
        }
        renderer.views.push_back(std::move(drawn));
    }
    for (const std::unique_ptr<DrawnView>& drawn : renderer.views) {
        drawn->finished = false;
        drawn->traced = {};
        drawn->indirect = {};
    }
}

}  // namespace lanthorn
