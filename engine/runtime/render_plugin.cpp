#include "lanthorn/runtime/render_plugin.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/gpu/pass_end.h"
#include "engine/render/detail_hints.h"
#include "engine/render/direct.h"
#include "engine/render/scene_renderer.h"
#include "engine/runtime/view_cameras.h"
#include "engine/runtime/view_frames.h"
#include "lanthorn/core/error.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/deformation_plugin.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/view.h"

namespace lanthorn {

namespace {

using ecs::Res;
using ecs::ResMut;
using render::FrameRenderer;

// Who looks: the cameras as they are now, and the light maps as they were in the frame before.
void gather_detail(const ecs::World& world, const FrameScene& before, const Renderer& renderer,
                   SurfaceDetail& detail) {
    detail.hints.eyes.clear();
    detail.hints.samples_per_metre = 0;
    // As finely as the files say, where one view wants that.
    const auto& settings = world.resource<render::RenderSettings>();
    const auto wants = [&](const View& view) {
        return !view.is_drawn() || view.settings.value_or(settings).adaptive_detail;
    };
    const View& first = world.resource<View>();
    const auto& others = world.resource<Views>().all();
    detail.adaptive = !renderer.views.empty() && wants(first) &&
                      std::ranges::all_of(others, [&](const auto& entry) { return wants(entry.second); });
    if (!detail.adaptive) {
        return;
    }
    const auto add = [&](const View& view, const CameraView& otherwise) {
        if (view.is_drawn()) {
            render::add_camera(detail.hints, look_of(world, view, before.origin).value_or(otherwise),
                               before.origin, view.size.y);
        }
    };
    add(first, before.camera);
    for (const auto& [id, view] : others) {
        add(view, frame_all(before));
    }
    std::vector<const render::LightMaps*> added;
    for (const std::unique_ptr<DrawnView>& view : renderer.views) {
        const render::LightMaps* maps = view->finished ? &view->frame->light_maps() : nullptr;
        if (maps != nullptr && std::ranges::find(added, maps) == added.end()) {
            added.push_back(maps);
            render::add_light_maps(detail.hints, *maps, before.origin);
        }
    }
}

// What differs from the frame before goes to the GPU.
void upload(Res<FrameScene> scene, ResMut<Renderer> renderer) {
    renderer->shared->keep_before(std::ranges::any_of(renderer->views, [](const auto& view) {
        return view->frame->settings.upscale == render::Upscale::temporal &&
               view->frame->final_size() != view->frame->size();
    }));
    renderer->shared->update(*scene, *renderer->timer);
    ++renderer->frames;
}

void draw_light_maps(Res<FrameScene> scene, Res<Renderer> renderer) {
    std::vector<FrameRenderer*> views;
    for (const std::unique_ptr<DrawnView>& view : renderer->views) {
        views.push_back(view->frame.get());
    }
    renderer->shared->draw_light_maps(*scene, views, *renderer->timer);
}

void draw_gbuffer(Res<render::Looks> looks, Res<Renderer> renderer) {
    renderer->shared->show(*looks);
    for_each_view(*renderer,
                  [&](const DrawnView& view) { view.frame->draw_gbuffer(*view.scene, *renderer->timer); });
}

void draw_direct(Res<render::TracedLobes> traced, Res<Renderer> renderer) {
    for_each_view(*renderer, [&](const DrawnView& view) {
        view.frame->draw_direct(*view.scene, view.id == ViewId::first ? *traced : view.traced,
                                *renderer->timer);
    });
}

// Whose exposure a view has beside its own; null: its own. Views are composed in their order.
const FrameRenderer* exposed_as(const DrawnView& view, const Renderer& renderer, const Views& others) {
    const View* asked = view.id == ViewId::first ? nullptr : others.find(view.id);
    if (asked == nullptr || !asked->exposed_as) {
        return nullptr;
    }
    const auto found = std::ranges::find_if(renderer.views, [&](const auto& other) {
        return other->id == *asked->exposed_as && other->finished;
    });
    return found == renderer.views.end() ? nullptr : (*found)->frame.get();
}

void compose(Res<render::IndirectLight> indirect, Res<render::Glows> glows, Res<Views> others,
             Res<Renderer> renderer) {
    renderer->shared->show(*glows);
    for_each_view(*renderer, [&](DrawnView& view) {
        view.frame->compose(*view.scene, view.id == ViewId::first ? *indirect : view.indirect,
                            *renderer->timer, exposed_as(view, *renderer, *others));
        view.finished = true;
    });
}

void draw_lines(Res<render::Lines> everywhere, Res<View> first, Res<Views> others, Res<Renderer> renderer) {
    for (const std::unique_ptr<DrawnView>& view : renderer->views) {
        const View& shown = view->id == ViewId::first ? *first : *others->find(view->id);
        view->frame->draw_lines(*view->scene, everywhere->lines, shown.lines.lines, *renderer->timer);
    }
}

void upscale(Res<Renderer> renderer) {
    for_each_view(*renderer,
                  [&](const DrawnView& view) { view.frame->upscale(*view.scene, *renderer->timer); });
}

}  // namespace

const DrawnView& Renderer::drawn(ViewId id) const {
    const auto found = std::ranges::find_if(views, [&](const auto& view) { return view->id == id; });
    if (found == views.end()) {
        throw Error(ExitCode::bad_input,
                    fmt::format("renderer: view {} is asked for, expected one that the last frame drew",
                                static_cast<std::uint32_t>(id)));
    }
    return **found;
}

ViewPass::ViewPass(const Renderer& renderer, DrawnView& view) : view_(view) {
    if (view.id != ViewId::first) {
        whole_.emplace(*renderer.timer, view.name);
    }
    view.at_work = true;
}

ViewPass::~ViewPass() {
    // Whose time it was is asked at the end of a pass.
    if (whole_) {
        whole_.reset();
    } else {
        gpu::PassEnd::tell();
    }
    view_.at_work = false;
}

void RenderPlugin::build(App& app) {
    ecs::World& world = app.world();
    Renderer renderer;
    renderer.timed = timed_;
    world.insert_resource(std::move(renderer));
    world.insert_resource(render::IndirectLight());
    world.insert_resource(render::TracedLobes());
    world.insert_resource(render::Lines());
    if (world.try_resource<render::Glows>() == nullptr) {
        world.insert_resource(render::Glows());
    }
    if (world.try_resource<render::Looks>() == nullptr) {
        world.insert_resource(render::Looks());
    }
    if (world.try_resource<render::RenderSettings>() == nullptr) {
        world.insert_resource(render::RenderSettings());
    }
    ecs::Schedule& frame = app.frame_schedule();
    if (app.has("deformation")) {
        frame
            .add("detail",
                 [&world](Res<FrameScene> before, Res<Renderer> renderer, Res<render::RenderSettings>,
                          Res<View>, Res<Views>, ResMut<SurfaceDetail> detail) {
                     gather_detail(world, *before, *renderer, *detail);
                 })
            .after("transforms")
            .before("skinning")
            .reads<CameraComponent>()
            .reads<WorldTransform>();
    }
    frame
        .add("views",
             [&world](Res<FrameScene> scene, Res<render::RenderSettings>, Res<View>, Res<Views>,
                      ResMut<Renderer> renderer) {
                 if (!renderer->timer) {
                     renderer->timer =
                         std::make_unique<gpu::PassTimer>(renderer->timed, gpu::draws_in_software());
                 }
                 follow_views(world, *scene, *renderer);
             })
        .before("upload")
        .reads<CameraComponent>()
        .reads<WorldTransform>()
        .on_main_thread();
    // What the passes hand on lies in the renderer; that is told here.
    frame.add("upload", upload).writes_resource<render::GpuScene>().on_main_thread();
    frame.add("light_maps", draw_light_maps)
        .reads_resource<render::GpuScene>()
        .writes_resource<render::LightMaps>()
        .on_main_thread();
    frame.add("gbuffer", draw_gbuffer)
        .reads_resource<render::GpuScene>()
        .writes_resource<render::GBuffer>()
        .on_main_thread();
    frame.add("direct", draw_direct)
        .reads_resource<render::GBuffer>()
        .reads_resource<render::LightMaps>()
        .writes_resource<render::DirectLight>()
        .on_main_thread();
    frame.add("composite", compose)
        .reads_resource<render::GBuffer>()
        .reads_resource<render::DirectLight>()
        .writes_resource<render::Composite>()
        .on_main_thread();
    frame.add("lines", draw_lines)
        .after("composite")
        .reads_resource<render::GBuffer>()
        .writes_resource<render::Composite>()
        .on_main_thread();
    frame.add("upscale", upscale)
        .after("lines")
        .reads_resource<render::GBuffer>()
        .writes_resource<render::Composite>()
        .on_main_thread();
}

}  // namespace lanthorn
