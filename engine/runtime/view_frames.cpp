#include "engine/runtime/view_frames.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/render/scene_renderer.h"
#include "engine/runtime/view_cameras.h"
#include "lanthorn/scene/view.h"

namespace lanthorn {

namespace {

template <class T>
std::vector<std::uint32_t> occupied(const AssetTable<T>& table) {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < table.size(); ++slot) {
        if (table.has(slot)) {
            slots.push_back(slot);
        }
    }
    return slots;
}

// As of a first extraction.
SceneChanges everything(const FrameScene& scene) {
    SceneChanges changes;
    changes.replaced = true;
    changes.moved.resize(scene.instances.size());
    std::iota(changes.moved.begin(), changes.moved.end(), 0u);
    changes.arrived = changes.moved;
    changes.dirty = scene.bounds;
    changes.meshes = occupied(scene.assets->meshes);
    changes.materials = occupied(scene.assets->materials);
    changes.images = occupied(scene.assets->images);
    return changes;
}

// What differs from a scene of some frames ago; nothing where things came or went, or assets are others.
std::optional<SceneChanges> changes_since(const FrameScene& before, const FrameScene& now) {
    const auto same_thing = [](const Instance& a, const Instance& b) {
        return a.id == b.id && a.mesh == b.mesh;
    };
    if (before.origin != now.origin || before.assets->serial != now.assets->serial ||
        !std::ranges::equal(before.instances, now.instances, same_thing)) {
        return std::nullopt;
    }
    SceneChanges changes;
    changes.assets = false;
    for (std::uint32_t i = 0; i < now.instances.size(); ++i) {
        const Instance &was = before.instances[i], &is = now.instances[i];
        if (was.transform != is.transform || was.bounds != is.bounds || was.version != is.version) {
            changes.moved.push_back(i);
            changes.dirty.add(was.bounds);
            changes.dirty.add(is.bounds);
        }
    }
    changes.geometry = !changes.moved.empty();
    changes.lights = before.lights != now.lights || before.sky != now.sky;
    return changes;
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
        drawn.own->changes = everything(scene);
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
