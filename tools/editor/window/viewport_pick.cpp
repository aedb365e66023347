// What lies under the pointer and in the frame that it draws.
#include <algorithm>
#include <utility>

#include "lanthorn/scene/components.h"
#include "tools/editor/window/lines.h"
#include "tools/editor/window/viewport.h"

namespace lanthorn::edit_window {

using editor::EditModel;
using editor::EditSession;

namespace {

constexpr double kIcon = 12;        // units: half of a light icon's target
constexpr double kBefore = 0.3;     // metres from a surface to the light that is put there
constexpr double kInTheOpen = 1.5;  // metres from the eye, where no surface is

}  // namespace

std::vector<std::uint32_t> Viewport::under(const vec2& pixel) {
    std::vector<std::uint32_t> found;
    const auto add = [&](std::uint32_t node) {
        if (node != kNone && std::ranges::find(found, node) == found.end()) {
            found.push_back(node);
        }
    };
    // Icons first: they are small and lie over everything.
    if (state_.helpers) {
        for (const editor::LightRow& light : state_.lights) {
            const auto at = eye_.at(light.at);
            const double reach = kIcon * static_cast<double>(state_.unit);
            if (at && light.shown && static_cast<double>(glm::length(*at - pixel)) < reach) {
                add(light.node);
            }
        }
    }
    EditSession& session = state_.session;
    if (session.world().try_resource<FrameScene>() != nullptr) {
        PickOptions options;
        options.lights = options.cameras = false;
        for (const Picked& hit :
             pick(session.world(), session.world().resource<FrameScene>(), eye_.ray(pixel), options)) {
            add(session.node_of(hit.entity));
        }
    }
    return found;
}

void Viewport::place_light(const vec2& pixel) {
    const std::string name = std::exchange(state_.places, {});
    const PickRay ray = eye_.ray(pixel);
    const std::optional<Picked> hit = surface_at(pixel);
    const dvec3 at =
        hit ? hit->position + kBefore * hit->normal : ray.origin + kInTheOpen * glm::normalize(ray.direction);
    state_.add_light(name, name == "spot" ? "spot" : "point", at,
                     hit ? vec3(hit->normal) : glm::normalize(vec3(ray.direction)));
}

void Viewport::click(const vec2& pixel, bool add) {
    std::vector<std::uint32_t> found = under(pixel);
    const bool again = glm::length(pixel - clicked_at_) < kClick * state_.unit && found == last_under_;
    clicked_at_ = pixel;
    if (found.empty()) {
        if (!add) {
            state_.select({});
        }
        last_under_.clear();
        return;
    }
    // Clicking again takes what lies behind.
    cycle_ = again && !add ? (cycle_ + 1) % found.size() : 0;
    const std::uint32_t node = found[cycle_];
    last_under_ = std::move(found);
    std::vector<std::uint32_t> chosen = add ? state_.chosen : std::vector<std::uint32_t>();
    const auto at = std::ranges::find(chosen, node);
    if (at != chosen.end()) {
        chosen.erase(at);
    } else {
        chosen.push_back(node);
    }
    state_.reveal = node;
    state_.select(std::move(chosen));
}

void Viewport::marquee(bool add) {
    const vec2 a = glm::min(*marquee_from_, last_), b = glm::max(*marquee_from_, last_);
    std::vector<std::uint32_t> chosen = add ? state_.chosen : std::vector<std::uint32_t>();
    const auto take = [&](std::uint32_t node) {
        if (node != kNone && std::ranges::find(chosen, node) == chosen.end()) {
            chosen.push_back(node);
        }
    };
    // Only what is seen: a grid of rays, and lights by their icons.
    constexpr int kRays = 24;
    for (int y = 0; y < kRays; ++y) {
        for (int x = 0; x < kRays; ++x) {
            const vec2 pixel = a + (b - a) * (vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f) /
                                       static_cast<float>(kRays);
            PickOptions options;
            options.lights = options.cameras = false;
            const auto hits = pick(state_.session.world(), state_.session.world().resource<FrameScene>(),
                                   eye_.ray(pixel), options);
            if (!hits.empty()) {
                take(state_.session.node_of(hits.front().entity));
            }
        }
    }
    for (const editor::LightRow& light : state_.lights) {
        const auto at = eye_.at(light.at);
        if (at && light.shown && at->x >= a.x && at->y >= a.y && at->x <= b.x && at->y <= b.y) {
            take(light.node);
        }
    }
    state_.select(std::move(chosen));
}

void Viewport::drop_to_surface(double now) {
    std::vector<std::string> lines;
    const EditModel& model = state_.session.model();
    for (const std::uint32_t node : state_.chosen) {
        const editor::ModelNode* found = model.find(node);
        if (found == nullptr || moves_with_another(node)) {
            continue;
        }
        const dvec3 at(model.world_matrix(node)[3]);
        PickOptions options;
        options.lights = options.cameras = false;
        for (const Picked& hit : pick(state_.session.world(), state_.session.world().resource<FrameScene>(),
                                      {at, dvec3(0, -1, 0)}, options)) {
            const std::uint32_t below = state_.session.node_of(hit.entity);
            if (below == kNone || model.is_within(below, node)) {
                continue;
            }
            const dmat4 parent = found->parent == kNone ? dmat4(1) : model.world_matrix(found->parent);
            lines.push_back(move_line(state_.session.path_of(node),
                                      dvec3(glm::inverse(parent) * dvec4(hit.position, 1))));
            break;
        }
    }
    if (!lines.empty()) {
        state_.desk.run("drop to the surface below", std::move(lines));
        state_.pace.changed(now, false);
    }
}

}  // namespace lanthorn::edit_window
