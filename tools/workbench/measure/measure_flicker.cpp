#include "lanthorn/workbench/measure_flicker.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "lanthorn/core/error.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/workbench/reference_pairs.h"
#include "tools/workbench/measure/image_changes.h"
#include "tools/workbench/scene/light_sources.h"
#include "tools/workbench/scene/moved_nodes.h"

namespace lanthorn::workbench {

namespace {

// Moves what the motion moves, a step a frame.
class Mover {
  public:
    // Of a scene that has been shown once and stands still.
    Mover(ShownScene& shown, const FlickerJob& job)
        : shown_(shown), job_(job), still_(shown.frame()), lights_(shown.world()) {
        if (job.motion == FlickerMotion::light) {
            find_lights();
        }
    }

    bool moves_something() const { return job_.motion == FlickerMotion::pan || !lights_.empty(); }

    // Shows the frame `k` steps from where the scene has it; one half of the steps lies before.
    const FrameScene& show(double k) {
        CameraView view = still_.camera;
        if (job_.motion == FlickerMotion::pan) {
            const auto angle = static_cast<float>(job_.step * k);
            view.view = glm::rotate(mat4(1), angle, vec3(0, 1, 0)) * view.view;
        }
        lights_.move(dvec3(job_.step * k * static_cast<double>(still_.diagonal()), 0, 0), job_.step * k);
        shown_.app().view().placed = view;
        shown_.app().show();
        return shown_.frame();
    }

  private:
    void find_lights() {
        ecs::World& world = shown_.world();
        const std::vector<ecs::Entity> punctual = punctual_lights(world);
        for (const ecs::Entity e : punctual.empty() ? emissive_meshes(world) : punctual) {
            const auto* light = world.try_get<LightComponent>(e);
            lights_.add(e, light != nullptr && light->light.type == LightType::directional);
        }
    }

    ShownScene& shown_;
    FlickerJob job_;
    FrameScene still_;
    MovedNodes lights_;
};

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) {
        sum += v;
    }
    return sum / static_cast<double>(values.size());
}

// Squares of the changes between frames, one a frame.
struct Changes {
    std::vector<double> technique, reference;
    double reference_variance = 0;  // sum of those of `reference`
    double reference_mean = 0;
};

FlickerFigures summarise(const Changes& changes) {
    FlickerFigures figures;
    for (const double square : changes.technique) {
        figures.by_frame.push_back(std::sqrt(square));
    }
    figures.change = std::sqrt(mean_of(changes.technique));
    figures.reference_mean = changes.reference_mean;
    const double square = mean_of(changes.reference);
    // Of `square`.
    const double error =
        std::sqrt(changes.reference_variance) / static_cast<double>(changes.reference.size());
    const bool known = square > 2 * error;
    figures.reference_change = known ? std::sqrt(square) : std::nan("");
    figures.reference_error = known ? error / (2 * figures.reference_change) : std::nan("");
    figures.ratio = figures.change / figures.reference_change;
    return figures;
}

}  // namespace

FlickerFigures measure_flicker(SceneData scene, const Settings& settings, const FlickerJob& job,
                               const std::function<void(std::uint64_t)>& done) {
    const std::string source = scene.source;
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    ShownScene shown(std::move(scene), job.view);
    shown.show_at(job.view.time.value_or(0));
    shown.hold();
    Mover mover(shown, job);
    if (!mover.moves_something()) {
        throw InputError(source, "", "found no light that can move, expected one (or --motion pan)");
    }
    context = gpu::create_headless_context();
    gi::add_picture_plugins(shown.app(), settings);
    shown.app().view().size = job.size;
    const reference::PathSettings path = reference::path_settings(settings);

    Changes changes;
    ImageF before;
    ReferencePair traced_before;
    for (int i = -job.warmup; i <= job.frames; ++i) {
        const FrameScene& frame = mover.show(i - 0.5 * job.frames);
        if (i >= 0) {
            ImageF now = shown.world().resource<Renderer>().frame->read(render::Aov::indirect);
            ReferencePair traced = trace_pair(frame, job.size, path, job.spp);
            if (i > 0) {
                const MeanProduct reference =
                    mean_product(traced.a, traced_before.a, traced.b, traced_before.b);
                changes.technique.push_back(mean_product(now, before, now, before).mean);
                changes.reference.push_back(reference.mean);
                changes.reference_variance += reference.variance;
            } else {
                for (std::size_t p = 0; p < traced.a.pixels.size(); ++p) {
                    changes.reference_mean +=
                        0.5 * (static_cast<double>(traced.a.pixels[p]) + traced.b.pixels[p]);
                }
                changes.reference_mean /= static_cast<double>(traced.a.pixels.size());
            }
            before = std::move(now);
            traced_before = std::move(traced);
        }
        done(static_cast<std::uint64_t>(i + job.warmup + 1));
    }
    return summarise(changes);
}

}  // namespace lanthorn::workbench
