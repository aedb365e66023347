#include "lanthorn/gi/gi_plugin.h"

#include "engine/render/light_sensors.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/deformation_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/scene/light_sensor.h"

namespace lanthorn::gi {

namespace {

using ecs::Res;
using ecs::ResMut;

// What measures the scene's light sensors: a resource.
struct Sensors {
    std::unique_ptr<render::LightSensors> meter;  // null before the first frame with sensors, which makes it
};

// Maps look too, from where they stood in the frame before.
void gather_detail(Res<ActiveTechnique> active, Res<FrameScene> before, ResMut<SurfaceDetail> detail) {
    if (detail.read().adaptive && active->technique) {
        active->technique->add_eyes(detail->hints, before->origin);
    }
}

void plan(Res<FrameScene> scene, Res<View> view, Res<GiSettings> settings, ResMut<ActiveTechnique> active,
          ResMut<render::TracedLobes> traced) {
    if (!active->technique || active->kind != settings->technique) {
        active->technique = make_technique(settings->technique);
        active->kind = settings->technique;
    }
    active->technique->plan(*scene, view->size, *settings);
    *traced = active->technique->traced_lobes();
}

void update(Res<FrameScene> scene, Res<Renderer> renderer, ResMut<ActiveTechnique> active) {
    const gpu::PassTimer::Scope pass(*renderer->timer, "gi");
    active->technique->update(renderer->frame->light_inputs(*scene, *renderer->timer));
}

void indirect(Res<FrameScene> scene, Res<Renderer> renderer, ResMut<ActiveTechnique> active,
              ResMut<render::IndirectLight> light) {
    const gpu::PassTimer::Scope pass(*renderer->timer, "gi");
    *light = active->technique->indirect(renderer->frame->inputs(*scene, *renderer->timer));
}

// What the GPU has measured comes back frames later, and enters the simulation with the next step.
void measure_sensors(Res<FrameScene> scene, Res<Renderer> renderer, Res<Time> time,
                     ResMut<ActiveTechnique> active, ResMut<Sensors> sensors, ResMut<SensorInbox> inbox) {
    if (scene->sensors.empty()) {
        return;
    }
    if (!sensors->meter) {
        sensors->meter = std::make_unique<render::LightSensors>();
    }
    render::LightSensors& meter = *sensors->meter;
    for (const render::SensorLight& light : meter.take()) {
        inbox->samples.push_back({light.id, light.step, light.reading});
    }
    const gpu::PassTimer::Scope pass(*renderer->timer, "sensors");
    const render::LightMaps& light_maps = renderer->frame->light_maps();
    if (meter.wants(*scene, light_maps, active.read().technique->light_version())) {
        active->technique->add_irradiance(renderer->frame->light_inputs(*scene, *renderer->timer),
                                          meter.measure_direct(*scene, light_maps));
        meter.send(time->steps);
    }
}

}  // namespace

void GiPlugin::build(App& app) {
    techniques();  // registers them, before frames run on many threads
    ecs::World& world = app.world();
    world.insert_resource(ActiveTechnique());
    if (world.try_resource<GiSettings>() == nullptr) {
        world.insert_resource(GiSettings());
    }
    ecs::Schedule& frame = app.frame_schedule();
    if (app.has("deformation")) {
        frame.add("gi.detail", gather_detail).after("detail").before("skinning");
    }
    frame.add("gi.plan", plan).before("gi.update").before("direct").on_main_thread();  // may make a technique
    frame.add("gi.update", update)
        .reads_resource<render::GpuScene>()
        .reads_resource<render::LightMaps>()
        .before("gi.indirect")
        .on_main_thread();
    frame.add("gi.indirect", indirect)
        .reads_resource<render::GpuScene>()
        .reads_resource<render::LightMaps>()
        .reads_resource<render::GBuffer>()
        .on_main_thread();
    if (app.has("sensors")) {
        world.insert_resource(Sensors());
        frame.add("sensors", measure_sensors)
            .reads_resource<render::GpuScene>()
            .reads_resource<render::LightMaps>()
            .after("gi.update")
            .before("gi.indirect")
            .on_main_thread();
    }
}

void add_picture_plugins(App& app, const Settings& settings, bool timed) {
    app.add<RenderPlugin>(timed).add<GiPlugin>();
    apply_settings(app, settings);
}

void add_picture_plugins(App& app, std::string_view preset) {
    app.add<RenderPlugin>().add<GiPlugin>();
    apply_preset(app, preset);
}

void declare_settings(SettingsSchema& schema) {
    render::declare_render_settings(schema);
    declare_gi_settings(schema);
}

void apply_settings(App& app, const Settings& settings) {
    app.world().insert_resource(render::render_settings(settings));
    app.world().insert_resource(gi_settings(settings));
}

void apply_preset(App& app, std::string_view preset) {
    SettingsSchema schema;
    declare_settings(schema);
    Settings settings(schema);
    settings.apply_preset(preset);
    apply_settings(app, settings);
}

}  // namespace lanthorn::gi
