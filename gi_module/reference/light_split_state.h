// What a LightSplitter holds, and what its parts share.
#pragma once

#include <optional>
#include <vector>

#include "gi_module/reference/camera_rays.h"
#include "gi_module/reference/integrator.h"
#include "gi_module/reference/light_split.h"
#include "gi_module/reference/path_listener.h"

namespace lanthorn::reference {

struct LightSplitter::State {
    State(const FrameScene& given, const PathSettings& wanted)
        : frame(given),
          settings(settled(wanted, false)),
          materials(*frame.assets),
          scene(frame, materials),
          emitters(scene, materials),
          lights(frame),
          sky(frame) {
        integrator.emplace(scene, materials, emitters, lights, sky, settings);
    }

    std::uint32_t entity(std::uint32_t instance) const { return frame.instances[instance].id; }
    std::uint32_t entity_of(const LightSource& lamp) const {
        return lamp.kind == LightKind::punctual  ? frame.lights[lamp.index].id
               : lamp.kind == LightKind::emitter ? entity(lamp.index)
                                                 : 0;
    }
    // Emissive surfaces of an entity are one lamp: its first instance.
    LightSource lamp(LightSource source) const {
        while (source.kind == LightKind::emitter && source.index > 0 &&
               entity(source.index - 1) == entity(source.index)) {
            --source.index;
        }
        return source;
    }
    std::vector<std::uint32_t> in_the_way(const DrawnLight& drawn) const;
    template <class Visit>
    void visit_punctual(const LitPoint& point, const Visit& visit) const;
    template <class Visit>
    void visit_emitter(const LitPoint& point, const RandomNumbers& random, const Visit& visit) const;
    template <class ReflectedOf>
    void look_without(const LitPoint& point, int samples, LightSplit& split,
                      const ReflectedOf& reflected_of) const;
    std::vector<IrradianceStart> starts(const LitPoint& point, int batch, int samples) const;

    FrameScene frame;
    PathSettings settings;
    MaterialTable materials;
    TraceScene scene;
    Emitters emitters;
    PunctualLights lights;
    SkyLight sky;
    std::optional<Integrator> integrator;
};

}  // namespace lanthorn::reference
