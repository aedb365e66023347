#include "tools/workbench/render/turntable.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
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

constexpr float kFlat = 0.05f;                 // height of a floor beside its length
constexpr int kSteps = 200, kStepsAWay = 100;  // back: at most, and of the way to the middle

bool is_flat(const Aabb& box) {
    return box.size().y < kFlat * std::max(box.size().x, box.size().z);
}

// Whether all of the box lies in the picture.
bool shows_all_of(const CameraView& view, const Aabb& box, const mat4& projection) {
    const mat4 clip_from_render = projection * view.view;
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 at((corner & 1) != 0 ? box.upper.x : box.lower.x,
                      (corner & 2) != 0 ? box.upper.y : box.lower.y,
                      (corner & 4) != 0 ? box.upper.z : box.lower.z);
        const vec4 clip = clip_from_render * vec4(at, 1);
        if (!(clip.w > 0) || std::max(std::abs(clip.x), std::abs(clip.y)) > clip.w) {
            return false;
        }
    }
    return true;
}

CameraView moved(const CameraView& view, const vec3& by) {
    CameraView result = view;
    result.position += by;
    result.view = view.view * glm::translate(mat4(1), -by);
    return result;
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

CameraView stepped_back(const CameraView& start, const Aabb& box, int pictures, float aspect,
                        float diagonal) {
    const mat4 projection = projection_matrix(start.camera, aspect, diagonal);
    const vec3 middle = box.centre();
    if (!shows_all_of(start, box, projection)) {
        return start;
    }
    for (int step = 0; step <= kSteps; ++step) {
        const CameraView view =
            moved(start, static_cast<float>(step) / kStepsAWay * (start.position - middle));
        bool all = true;
        for (int i = 0; all && i < pictures; ++i) {
            all = shows_all_of(turned(view, middle, 2 * glm::pi<double>() * i / pictures), box, projection);
        }
        if (all) {
            return view;
        }
    }
    return start;
}

Aabb framed_box(const FrameScene& scene) {
    Aabb things;
    for (const Instance& instance : scene.instances) {
        if (!is_flat(instance.bounds)) {
            things.add(instance.bounds);
        }
    }
    // It is what stands on floors that is framed where that gives the same view.
    const bool stand_alone = !things.empty() && frame_all(things) == frame_all(scene);
    return stand_alone ? things : scene.bounds;
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
    const CameraView given = shown.frame().camera;
    const Aabb box = framed_box(shown.frame());
    const CameraView start = stepped_back(given, box, job.pictures,
                                          static_cast<float>(job.size.x) / static_cast<float>(job.size.y),
                                          shown.frame().diagonal());
    const bool whole = start == given;
    if (whole) {
        done(picture());
    }
    shown.hold();
    app.world().resource_mut<render::RenderSettings>().exposure_glide = 0;
    for (int i = whole ? 1 : 0; i < job.pictures; ++i) {
        app.view().placed = turned(start, box.centre(), 2 * glm::pi<double>() * i / job.pictures);
        for (int frame = 0; frame <= job.warmup; ++frame) {
            app.show();
            stop_if_asked("turntable", "nothing is written");
        }
        done(picture());
    }
}

}  // namespace lanthorn::workbench
