#include "lanthorn/gi/gi_plugin.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/render/light_sensors.h"
#include "lanthorn/core/error.h"
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
    ViewId view = ViewId::first;                  // whose technique it measures with
};

// What has the technique and the settings of a view at hand.
struct Lit {
    ActiveTechnique& active;
    const GiSettings& settings;
};

Lit lit(const DrawnView& view, ActiveTechnique& first, ViewTechniques& others, const GiSettings& settings) {
    if (view.id == ViewId::first) {
        return {first, settings};
    }
    ViewTechniques::Entry& entry = others.entries[view.id];
    return {entry.active, entry.settings ? *entry.settings : settings};
}

// Maps look too, from where they stood in the frame before.
void gather_detail(Res<ActiveTechnique> active, Res<ViewTechniques> others, Res<FrameScene> before,
                   ResMut<SurfaceDetail> detail) {
    if (!detail.read().adaptive) {
        return;
    }
    if (active->technique) {
        active->technique->add_eyes(detail->hints, before->origin);
    }
    for (const auto& [id, entry] : others->entries) {
        if (entry.active.technique) {
            entry.active.technique->add_eyes(detail->hints, before->origin);
        }
    }
}

std::unique_ptr<Technique> make_technique_for(const DrawnView& view, TechniqueKind kind) {
    const auto number = static_cast<std::size_t>(kind);
    if (number >= techniques().size()) {
        throw Error(ExitCode::bad_input,
                    fmt::format("{}: found technique {}, expected one of {} (0 to {})", view.name, number,
                                fmt::join(technique_names(), ", "), techniques().size() - 1));
    }
    try {
        return make_technique(kind);
    } catch (const Error& error) {
        if (view.id == ViewId::first) {
            throw;
        }
        throw Error(error.code(), view.name + ": " + error.what());
    }
}

void plan(Res<Renderer> renderer, Res<Views> views, Res<GiSettings> settings, ResMut<ActiveTechnique> active,
          ResMut<ViewTechniques> others, ResMut<render::TracedLobes> traced) {
    std::erase_if(others->entries, [&](const auto& entry) { return views->find(entry.first) == nullptr; });
    for (auto& [id, entry] : others->entries) {
        const View& view = *views->find(id);
        if (!view.is_drawn() && !view.rests) {
            entry.active.technique.reset();
        }
    }
    for_each_view(*renderer, [&](DrawnView& view) {
        const Lit of = lit(view, *active, *others, *settings);
        std::unique_ptr<Technique>& technique = of.active.technique;
        if (!technique || of.active.kind != of.settings.technique || view.restarted) {
            technique = make_technique_for(view, of.settings.technique);
            of.active.kind = of.settings.technique;
        }
        technique->plan(*view.scene, view.frame->size(), of.settings);
        (view.id == ViewId::first ? *traced : view.traced) = technique->traced_lobes();
    });
}

void update(Res<Renderer> renderer, ResMut<ActiveTechnique> active, ResMut<ViewTechniques> others,
            Res<GiSettings> settings) {
    for_each_view(*renderer, [&](const DrawnView& view) {
        const gpu::PassTimer::Scope pass(*renderer->timer, "gi");
        lit(view, *active, *others, *settings)
            .active.technique->update(view.frame->light_inputs(*view.scene, *renderer->timer));
    });
}

void indirect(Res<Renderer> renderer, ResMut<ActiveTechnique> active, ResMut<ViewTechniques> others,
              Res<GiSettings> settings, ResMut<render::IndirectLight> light) {
    for_each_view(*renderer, [&](DrawnView& view) {
        const gpu::PassTimer::Scope pass(*renderer->timer, "gi");
        (view.id == ViewId::first ? *light : view.indirect) =
            lit(view, *active, *others, *settings)
                .active.technique->indirect(view.frame->inputs(*view.scene, *renderer->timer));
    });
}

// What the GPU has measured comes back frames later, and enters the simulation with the next step.
void measure_sensors(Res<FrameScene> scene, Res<Renderer> renderer, Res<Time> time, Res<GiSettings> settings,
                     ResMut<ActiveTechnique> active, ResMut<ViewTechniques> others, ResMut<Sensors> sensors,
                     ResMut<SensorInbox> inbox) {
    if (scene->sensors.empty() || renderer->views.empty()) {
        return;
    }
    const DrawnView& view = *renderer->views.front();
    if (!sensors->meter || sensors->view != view.id || view.restarted) {
        sensors->meter = std::make_unique<render::LightSensors>();
        sensors->view = view.id;
    }
    Technique& technique = *lit(view, *active, *others, *settings).active.technique;
    render::LightSensors& meter = *sensors->meter;
    for (const render::SensorLight& light : meter.take()) {
        inbox->samples.push_back({light.id, light.step, light.reading});
    }
    const gpu::PassTimer::Scope pass(*renderer->timer, "sensors");
    const render::LightMaps& light_maps = view.frame->light_maps();
    if (meter.wants(*scene, light_maps, technique.light_version())) {
        technique.add_irradiance(view.frame->light_inputs(*view.scene, *renderer->timer),
                                 meter.measure_direct(*scene, light_maps));
        meter.send(time->steps);
    }
}

}  // namespace

void GiPlugin::build(App& app) {
    techniques();  // registers them, before frames run on many threads
    ecs::World& world = app.world();
    world.insert_resource(ActiveTechnique());
    world.insert_resource(ViewTechniques());
    if (world.try_resource<GiSettings>() == nullptr) {
        world.insert_resource(GiSettings());
    }
    ecs::Schedule& frame = app.frame_schedule();
    if (app.has("deformation")) {
        frame.add("gi.detail", gather_detail).after("detail").before("skinning");
    }
    // May make a technique, or free one.
    frame.add("gi.plan", plan).before("gi.update").before("direct").on_main_thread();
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

void apply_settings(App& app, const Settings& settings, ViewId view) {
    if (view == ViewId::first) {
        apply_settings(app, settings);
        return;
    }
    app.view(view).settings = render::render_settings(settings);
    set_gi_settings(app, gi_settings(settings), view);
}

void set_gi_settings(App& app, const GiSettings& settings, ViewId view) {
    app.view(view);  // or throws
    if (view == ViewId::first) {
        app.world().insert_resource(settings);
    } else {
        app.world().resource_mut<ViewTechniques>().entries[view].settings = settings;
    }
}

Technique& technique_of(App& app, ViewId view) {
    const View& shown = app.view(view);
    const ecs::World& world = app.world();
    const auto& others = world.resource<ViewTechniques>().entries;
    const auto other = others.find(view);
    Technique* technique = nullptr;
    if (view == ViewId::first) {
        technique = world.resource<ActiveTechnique>().technique.get();
    } else if (other != others.end()) {
        technique = other->second.active.technique.get();
    }
    if (technique == nullptr) {
        throw Error(ExitCode::bad_input, described_view(view, shown) +
                                             ": its technique is asked for, expected a frame that drew it");
    }
    return *technique;
}

}  // namespace lanthorn::gi
