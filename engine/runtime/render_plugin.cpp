#include "lanthorn/runtime/render_plugin.h"

#include "engine/render/detail_hints.h"
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

// Who looks: the camera as it is now, and the light maps as they were in the frame before.
void gather_detail(Res<View> view, Res<FrameScene> before, Res<Renderer> renderer,
                   Res<render::RenderSettings> settings, ResMut<SurfaceDetail> detail,
                   ecs::Query<ecs::Read<CameraComponent>, ecs::Read<WorldTransform>> cameras) {
    detail->hints.eyes.clear();
    detail->hints.samples_per_metre = 0;
    detail->adaptive = settings->adaptive_detail && renderer->frames > 0;
    if (!detail->adaptive) {
        return;
    }
    CameraView seen = view->placed.value_or(before->camera);
    if (!view->placed && view->camera) {
        const auto [lens, at] = cameras.get(view->camera);
        seen = camera_view(lens.camera, at.matrix, before->origin);
    }
    render::add_camera(detail->hints, seen, before->origin, view->size.y);
    render::add_light_maps(detail->hints, renderer->frame->light_maps(), before->origin);
}

// What differs from the frame before goes to the GPU.
void upload(Res<FrameScene> scene, Res<View> view, Res<render::RenderSettings> settings,
            ResMut<Renderer> renderer) {
    if (!renderer->frame) {
        renderer->frame = std::make_unique<FrameRenderer>();
        renderer->timer = std::make_unique<gpu::PassTimer>(renderer->timed, gpu::draws_in_software());
    }
    renderer->frame->settings = *settings;
    renderer->frame->begin(*scene, view->size, *renderer->timer);
    ++renderer->frames;
}

void draw_light_maps(Res<FrameScene> scene, Res<Renderer> renderer) {
    renderer->frame->draw_light_maps(*scene, *renderer->timer);
}

void draw_gbuffer(Res<FrameScene> scene, Res<Renderer> renderer) {
    renderer->frame->draw_gbuffer(*scene, *renderer->timer);
}

void draw_direct(Res<FrameScene> scene, Res<render::TracedLobes> traced, Res<Renderer> renderer) {
    renderer->frame->draw_direct(*scene, *traced, *renderer->timer);
}

void compose(Res<FrameScene> scene, Res<render::IndirectLight> indirect, Res<Renderer> renderer) {
    renderer->frame->compose(*scene, *indirect, *renderer->timer);
}

}  // namespace

void RenderPlugin::build(App& app) {
    ecs::World& world = app.world();
    world.insert_resource(Renderer{nullptr, nullptr, timed_, 0});
    world.insert_resource(render::IndirectLight());
    world.insert_resource(render::TracedLobes());
    if (world.try_resource<render::RenderSettings>() == nullptr) {
        world.insert_resource(render::RenderSettings());
    }
    ecs::Schedule& frame = app.frame_schedule();
    if (app.has("deformation")) {
        frame.add("detail", gather_detail).after("transforms").before("skinning");
    }
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
}

}  // namespace lanthorn
