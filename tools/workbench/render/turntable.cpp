#include "tools/workbench/render/turntable.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/scene/view.h"
#include "lanthorn/workbench/render_job.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::workbench {

namespace {

constexpr float kFlat = 0.05f;  // height of a floor beside its length

bool is_flat(const Aabb& box) {
    return box.size().y < kFlat * std::max(box.size().x, box.size().z);
}

}  // namespace

CameraView turned(const CameraView& view, const vec3& pivot, double radians) {
    const dvec3 middle(pivot);
    const dmat4 turn = glm::translate(dmat4(1), middle) * glm::rotate(dmat4(1), radians, dvec3(0, 1, 0)) *
                       glm::translate(dmat4(1), -middle);
    CameraView result = view;
    result.position = vec3(turn * dvec4(dvec3(view.position), 1));
    const glm::dmat3 to_view = glm::dmat3(view.view) * glm::transpose(glm::dmat3(turn));
    dmat4 placed(to_view);
    placed[3] = dvec4(-(to_view * dvec3(result.position)), 1);
    result.view = mat4(placed);
    return result;
}

vec3 framed_middle(const FrameScene& scene) {
    Aabb things;
    for (const Instance& instance : scene.instances) {
        if (!is_flat(instance.bounds)) {
            things.add(instance.bounds);
        }
    }
    // It is what stands on floors that is framed where that gives the same view.
    const bool stand_alone = !things.empty() && frame_all(things) == frame_all(scene);
    return (stand_alone ? things : scene.bounds).centre();
}

void render_turntable(SceneData scene, const Settings& settings, const TurntableJob& job,
                      const std::function<void(const ImageF&)>& done) {
    std::unique_ptr<gpu::Context> context;  // before what draws in it
    ShownScene shown(std::move(scene), job.view);
    App& app = shown.app();
    context = gpu::create_headless_context();
    check_picture_fits(job.size);
    gi::add_picture_plugins(app, settings);
    app.view().size = job.size;
    const auto picture = [&] { return app.world().resource<Renderer>().frame->read(render::Aov::final); };

    RenderJob first;
    first.view = job.view;
    for (int left = job.warmup; left >= 0; --left) {
        shown.show_at(shown_time(first, left));
        stop_if_asked("turntable", "nothing is written");
    }
    done(picture());
    shown.hold();
    app.world().resource_mut<render::RenderSettings>().exposure_glide = 0;
    const CameraView start = shown.frame().camera;
    const vec3 pivot = framed_middle(shown.frame());
    for (int i = 1; i < job.pictures; ++i) {
        app.view().placed = turned(start, pivot, 2 * glm::pi<double>() * i / job.pictures);
        for (int frame = 0; frame <= job.warmup; ++frame) {
            app.show();
            stop_if_asked("turntable", "nothing is written");
        }
        done(picture());
    }
}

}  // namespace lanthorn::workbench
