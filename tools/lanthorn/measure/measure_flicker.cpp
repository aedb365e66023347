#include "tools/lanthorn/measure/measure_flicker.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/reference/path_tracer.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn::tools {

namespace {

using Image = std::vector<float>;

// Moves what the motion moves, a step a frame.
class Mover {
  public:
    Mover(ecs::World& world, ecs::Entity camera, const FlickerJob& job)
        : world_(world), job_(job), still_(extractor_.extract(world, camera)) {
        if (job.motion == FlickerMotion::light) {
            find_lights();
        }
    }

    bool moves_something() const { return job_.motion == FlickerMotion::pan || !lights_.empty(); }

    // The frame `k` steps from where the scene has it; one half of the steps lies before.
    FrameScene frame(double k) {
        CameraView view = still_.camera;
        if (job_.motion == FlickerMotion::pan) {
            const auto angle = static_cast<float>(job_.step * k);
            view.view = glm::rotate(mat4(1), angle, vec3(0, 1, 0)) * view.view;
        }
        for (const MovedLight& light : lights_) {
            auto& local = world_.get_mut<LocalTransform>(light.entity).value;
            const double distance = job_.step * k * static_cast<double>(still_.diagonal());
            if (light.turns) {
                local.rotation =
                    glm::angleAxis(static_cast<float>(job_.step * k), vec3(0, 1, 0)) * light.still.rotation;
            } else {
                local.translation = light.still.translation + light.to_local * dvec3(distance, 0, 0);
            }
        }
        transforms_.update(world_);
        return extractor_.extract(world_, view);
    }

  private:
    struct MovedLight {
        ecs::Entity entity;
        Transform still;
        glm::dmat3 to_local;  // world directions to the parent's
        bool turns;
    };

    void add(ecs::Entity entity, bool turns) {
        const auto* parent = world_.try_get<Parent>(entity);
        const glm::dmat3 to_world =
            parent != nullptr ? glm::dmat3(world_.get<WorldTransform>(parent->entity).matrix) : glm::dmat3(1);
        const double volume = glm::determinant(to_world);
        if (volume != 0 && std::isfinite(volume)) {
            lights_.push_back(
                {entity, world_.get<LocalTransform>(entity).value, glm::inverse(to_world), turns});
        }
    }

    void find_lights() {
        std::vector<std::pair<ecs::Entity, bool>> found;
        world_.query<ecs::Read<LightComponent>>().each([&](ecs::Entity e, const LightComponent& c) {
            found.emplace_back(e, c.light.type == LightType::directional);
        });
        if (found.empty()) {
            world_.query<ecs::Read<MeshInstances>>().each([&](ecs::Entity e, const MeshInstances& instances) {
                const SceneAssets& assets = *still_.assets;
                if (std::ranges::any_of(instances.meshes, [&](MeshHandle handle) {
                        const Mesh* mesh = assets.meshes.find(handle);
                        return mesh != nullptr && assets.materials[mesh->material].emits();
                    })) {
                    found.emplace_back(e, false);
                }
            });
        }
        for (const auto& [entity, turns] : found) {
            add(entity, turns);
        }
    }

    ecs::World& world_;
    FlickerJob job_;
    Extractor extractor_;
    Transforms transforms_;
    FrameScene still_;
    std::vector<MovedLight> lights_;
};

Image path_traced(const FrameScene& frame, ivec2 size, reference::PathSettings settings, int spp,
                  std::uint32_t seed) {
    settings.spp = spp;
    settings.seed = seed;
    settings.time_limit = 0;
    settings.target_noise = 0;
    reference::PathTracer tracer(frame, size, settings, {.indirect = true});
    tracer.render({});
    return tracer.image(reference::PathAov::indirect);
}

// Mean over pixels and channels of the product of two images' changes, and the variance of that mean, its
// pixels (not their channels) taken as independent.
struct MeanProduct {
    double mean = 0, variance = 0;
};

MeanProduct mean_product(const Image& a_now, const Image& a_before, const Image& b_now,
                         const Image& b_before) {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < a_now.size(); i += 3) {
        double pixel = 0;
        for (std::size_t c = i; c < i + 3; ++c) {
            pixel += (static_cast<double>(a_now[c]) - a_before[c]) *
                     (static_cast<double>(b_now[c]) - b_before[c]) / 3;
        }
        sum += pixel;
        squares += pixel * pixel;
    }
    const double n = static_cast<double>(a_now.size()) / 3;
    return {sum / n, std::max(squares / n - (sum / n) * (sum / n), 0.0) / n};
}

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
    ShownScene shown(std::move(scene), job.view);
    shown.show(job.view.time.value_or(0));
    Mover mover(shown.world(), shown.camera(), job);
    if (!mover.moves_something()) {
        throw InputError(source, "", "found no light that can move, expected one (or --motion pan)");
    }
    const auto context = gpu::create_headless_context();
    const gi::GiSettings gi_settings = gi::gi_settings(settings);
    const auto technique = gi::make_technique(gi_settings.technique);
    render::FrameRenderer renderer;
    renderer.settings = render::render_settings(settings);
    gpu::PassTimer timer(false, context->info().software);
    const auto indirect = [&](const render::FrameInputs& inputs) {
        return technique->render(inputs, gi_settings);
    };
    const reference::PathSettings path = reference::path_settings(settings);

    Changes changes;
    Image before, a_before, b_before;
    for (int i = -job.warmup; i <= job.frames; ++i) {
        const FrameScene frame = mover.frame(i - 0.5 * job.frames);
        renderer.render(frame, job.size, indirect, timer);
        if (i >= 0) {
            Image now = renderer.read(render::Aov::indirect).pixels;
            Image a = path_traced(frame, job.size, path, (job.spp + 1) / 2, path.seed);
            Image b = path_traced(frame, job.size, path, (job.spp + 1) / 2, path.seed + 0x5bd1e995u);
            if (i > 0) {
                const MeanProduct reference = mean_product(a, a_before, b, b_before);
                changes.technique.push_back(mean_product(now, before, now, before).mean);
                changes.reference.push_back(reference.mean);
                changes.reference_variance += reference.variance;
            } else {
                for (std::size_t p = 0; p < a.size(); ++p) {
                    changes.reference_mean += 0.5 * (static_cast<double>(a[p]) + b[p]);
                }
                changes.reference_mean /= static_cast<double>(a.size());
            }
            before = std::move(now);
            a_before = std::move(a);
            b_before = std::move(b);
        }
        done(static_cast<std::uint64_t>(i + job.warmup + 1));
    }
    return summarise(changes);
}

}  // namespace lanthorn::tools
