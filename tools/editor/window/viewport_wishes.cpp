// Light wishes in the picture: where they are, and a hand that makes one.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lanthorn/core/error.h"
#include "tools/editor/window/viewport.h"
#include "tools/workbench/measure/light_words.h"

namespace lanthorn::edit_window {

namespace {

constexpr int kRim = 32;            // corners of a disc's rim
constexpr double kSmallest = 0.02;  // metres
constexpr double kRounded = 1e-4;   // metres, of what a hand does

dvec3 rounded(const dvec3& v) {
    return glm::round(v / kRounded) * kRounded;
}

}  // namespace

std::optional<Picked> Viewport::surface_at(const vec2& pixel) {
    editor::EditSession& session = state_.session;
    if (session.world().try_resource<FrameScene>() == nullptr) {
        return std::nullopt;
    }
    PickOptions options;
    options.lights = options.cameras = false;
    const std::vector<Picked> hits =
        pick(session.world(), session.world().resource<FrameScene>(), eye_.ray(pixel), options);
    return hits.empty() ? std::nullopt : std::optional(hits.front());
}

void Viewport::begin_wish(const vec2& pixel) {
    const std::optional<Picked> hit = surface_at(pixel);
    if (!hit) {
        return;
    }
    const dvec3 at = rounded(hit->position), normal = hit->normal;
    try {
        state_.wishes.rows.push_back(
            {editor::wish_of(fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}", at.x, at.y, at.z,
                                         normal.x, normal.y, normal.z),
                             state_.wishes.lux),
             {}});
        makes_wish_ = true;
    } catch (const Error& error) {
        state_.problem = error.what();
    }
}

// The rim goes where the pointer meets the disc's plane.
void Viewport::widen_wish(const vec2& pixel) {
    editor::LightWish& wish = state_.wishes.rows.back().wish;
    const dvec3 normal(*wish.normal);
    const PickRay ray = eye_.ray(pixel);
    const double along = glm::dot(ray.direction, normal);
    const double t = along != 0 ? glm::dot(wish.place - ray.origin, normal) / along : -1;
    if (t > 0) {
        const double radius = glm::length(ray.origin + t * ray.direction - wish.place);
        wish.radius = std::max(kSmallest, std::round(radius / kRounded) * kRounded);
    }
}

void Viewport::end_wish() {
    makes_wish_ = false;
    ++state_.wishes.edition;
}

void Viewport::drop_wish() {
    if (std::exchange(makes_wish_, false)) {
        state_.wishes.rows.pop_back();
    }
}

void Viewport::draw_wishes_places() {
    if (state_.wishes.rows.empty() || !(state_.splits.drawer_open && state_.drawer_tab == kWishesTab)) {
        return;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool old = state_.wishes.old(state_.session.version());
    for (const WishRow& row : state_.wishes.rows) {
        const editor::LightWish& wish = row.wish;
        if (wish.of_node || !wish.normal) {
            continue;
        }
        const bool known = row.found && !old;
        const ImU32 shade = !known                                   ? colour::words
                            : row.found->met_with(row.found->before) ? colour::good
                                                                     : colour::warning;
        const dvec3 normal(*wish.normal);
        const dvec3 u =
            glm::normalize(glm::cross(normal, std::abs(normal.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
        const dvec3 v = glm::cross(normal, u);
        const auto rim = [&](int i) {
            const double a = 2 * glm::pi<double>() * i / kRim;
            return wish.place + wish.radius * (std::cos(a) * u + std::sin(a) * v);
        };
        for (int i = 0; i < kRim; ++i) {
            if (const auto line = eye_.line(rim(i), rim(i + 1))) {
                list.AddLine(im(line->first), im(line->second), IM_COL32(0, 0, 0, 160), 4);
                list.AddLine(im(line->first), im(line->second), shade, 2);
            }
        }
        if (const auto at = eye_.at(wish.place)) {
            const std::string words =
                known ? fmt::format("{} of {}", workbench::lux_text(row.found->before), asked_words(wish))
                      : asked_words(wish);
            const ImVec2 size = ImGui::CalcTextSize(words.c_str());
            list.AddRectFilled({at->x - size.x / 2 - 3, at->y - size.y / 2 - 1},
                               {at->x + size.x / 2 + 3, at->y + size.y / 2 + 1}, IM_COL32(0, 0, 0, 190));
            list.AddText({at->x - size.x / 2, at->y - size.y / 2}, shade, words.c_str());
        }
    }
}

}  // namespace lanthorn::edit_window
