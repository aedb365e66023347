#include "tools/editor/window/handles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lanthorn::edit_window {

namespace {

constexpr double kLength = 88, kHit = 7;  // units
constexpr int kRingPoints = 64;
constexpr double kFar = 1e7;  // metres: no hand goes farther

double snapped(double value, double step, bool snap) {
    return snap && step > 0 ? step * std::round(value / step) : value;
}

double distance_to(const vec2& p, const vec2& a, const vec2& b) {
    const vec2 way = b - a;
    const float length = glm::dot(way, way);
    const float t = length > 0 ? std::clamp(glm::dot(p - a, way) / length, 0.0f, 1.0f) : 0;
    return static_cast<double>(glm::length(p - a - t * way));
}

bool inside(const vec2& p, const std::vector<vec2>& area) {
    bool in = false;
    for (std::size_t i = 0, j = area.size() - 1; i < area.size(); j = i++) {
        if ((area[i].y > p.y) != (area[j].y > p.y) &&
            p.x < (area[j].x - area[i].x) * (p.y - area[i].y) / (area[j].y - area[i].y) + area[i].x) {
            in = !in;
        }
    }
    return in;
}

int index_of(Part part) {
    switch (part) {
        case Part::x:
        case Part::yz:
            return 0;
        case Part::y:
        case Part::zx:
            return 1;
        case Part::z:
        case Part::xy:
            return 2;
        default:
            return -1;
    }
}

constexpr std::array kAxes = {Part::x, Part::y, Part::z};
constexpr std::array kPlanes = {Part::yz, Part::zx, Part::xy};
constexpr std::array kAxisNames = {"x", "y", "z"};

}  // namespace

std::optional<double> along(const PickRay& ray, const dvec3& point, const dvec3& axis) {
    const dvec3 between = point - ray.origin;
    const double cosine = glm::dot(ray.direction, axis);
    const double square = 1 - cosine * cosine;
    if (square < 1e-6) {
        return std::nullopt;
    }
    const double t = (cosine * glm::dot(between, ray.direction) - glm::dot(between, axis)) / square;
    return std::clamp(t, -kFar, kFar);
}

std::optional<dvec3> on_plane(const PickRay& ray, const dvec3& point, const dvec3& normal) {
    const double slope = glm::dot(ray.direction, normal);
    if (std::abs(slope) < 1e-4) {
        return std::nullopt;
    }
    const double t = glm::dot(point - ray.origin, normal) / slope;
    if (t <= 0 || t > kFar) {
        return std::nullopt;
    }
    return ray.origin + t * ray.direction;
}

void Handles::add_line(Part part, const dvec3& from, const dvec3& to) {
    if (const auto line = eye_.line(from, to)) {
        lines_.push_back({part, {line->first, line->second}});
    }
}

void Handles::add_ring(Part part, const dvec3& centre, const dvec3& a, const dvec3& b, bool front_only) {
    std::vector<vec2> run;
    const auto flush = [&] {
        if (run.size() > 1) {
            lines_.push_back({part, run});
        }
        run.clear();
    };
    for (int i = 0; i <= kRingPoints; ++i) {
        const double angle = 2 * static_cast<double>(kPi) * i / kRingPoints;
        const dvec3 way = std::cos(angle) * a + std::sin(angle) * b;
        const bool hidden = front_only && glm::dot(way, centre - eye_.eye()) > 0;
        const auto pixel = eye_.at(centre + way);
        if (hidden || !pixel) {
            flush();
        } else {
            run.push_back(*pixel);
        }
    }
    flush();
}

void Handles::add_patch(Part part, std::span<const dvec3> corners) {
    Stroke stroke{part, {}, true};
    for (const dvec3& corner : corners) {
        if (const auto pixel = eye_.at(corner)) {
            stroke.points.push_back(*pixel);
        }
    }
    if (stroke.points.size() == corners.size()) {
        lines_.push_back(std::move(stroke));
    }
}

void Handles::add_knob(Part part, const dvec3& at, float half) {
    if (const auto pixel = eye_.at(at)) {
        const float h = half * unit_;
        const vec2 p = *pixel;
        lines_.push_back({part, {p + vec2(-h, -h), p + vec2(h, -h), p + vec2(h, h), p + vec2(-h, h)}, true});
    }
}

void Handles::place(const HandlePlace& at, Tool tool, const Projector& eye, float unit) {
    at_ = at;
    eye_ = eye;
    unit_ = unit;
    tool_ = tool;
    lines_.clear();
    const dvec3& p = at.pivot;
    if (!eye.at(p)) {
        return;
    }
    const double length = kLength * static_cast<double>(unit) / eye.pixels_a_metre(p);
    const dvec3 to_eye = glm::normalize(eye.eye() - p);
    for (int i = 0; i < 3; ++i) {
        const Part part = kAxes[static_cast<std::size_t>(i)];
        const dvec3 a = at.axes[i], b = at.axes[(i + 1) % 3], c = at.axes[(i + 2) % 3];
        if (tool == Tool::rotate) {
            add_ring(part, p, length * b, length * c, true);
            continue;
        }
        if (tool == Tool::move && std::abs(glm::dot(a, to_eye)) > 0.2) {
            const double from = 0.28 * length, to = 0.45 * length;
            const std::array<dvec3, 4> patch = {p + from * b + from * c, p + to * b + from * c,
                                                p + to * b + to * c, p + from * b + to * c};
            add_patch(kPlanes[static_cast<std::size_t>(i)], patch);
        }
        // An axis that points at the eye cannot be dragged.
        if (std::abs(glm::dot(a, to_eye)) > 0.985) {
            continue;
        }
        if (tool == Tool::move) {
            add_line(part, p + 0.15 * length * a, p + 0.85 * length * a);
            const dvec3 side = 0.06 * length * glm::normalize(glm::cross(a, to_eye));
            const std::array<dvec3, 3> head = {p + length * a, p + 0.82 * length * a + side,
                                               p + 0.82 * length * a - side};
            add_patch(part, head);
        } else if (tool == Tool::scale) {
            add_line(part, p + 0.15 * length * a, p + 0.9 * length * a);
            add_knob(part, p + 0.95 * length * a, 5);
        }
    }
    if (tool == Tool::move || tool == Tool::scale) {
        add_knob(Part::view, p, 5);
    }
    if (tool != Tool::select && at.range) {
        add_ring(Part::range, p, *at.range * eye.right(), *at.range * eye.up(), false);
        add_knob(Part::range, p + *at.range * eye.right(), 4);
    }
    if (tool != Tool::select && at.cone) {
        const double reach = std::min(2 * length, at.range.value_or(2 * length));
        const dvec3 tip = p - reach * std::cos(*at.cone) * at.light_axes[2];
        const double radius = reach * std::sin(*at.cone);
        add_ring(Part::cone, tip, radius * at.light_axes[0], radius * at.light_axes[1], false);
        for (const dvec3& way : {at.light_axes[0], -at.light_axes[0], at.light_axes[1], -at.light_axes[1]}) {
            add_line(Part::none, p, tip + radius * way);
        }
        add_knob(Part::cone, tip + radius * at.light_axes[0], 4);
    }
}

Part Handles::hit(const vec2& pixel) const {
    Part best = Part::none;
    double nearest = kHit * static_cast<double>(unit_);
    for (const Stroke& stroke : lines_) {
        if (stroke.part == Part::none) {
            continue;
        }
        if (stroke.filled && inside(pixel, stroke.points)) {
            // The knob in the middle lies over the rest.
            if (stroke.part == Part::view) {
                return Part::view;
            }
            best = stroke.part;
            nearest = 0;
            continue;
        }
        for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
            const double away = distance_to(pixel, stroke.points[i], stroke.points[i + 1]);
            if (away < nearest) {
                nearest = away;
                best = stroke.part;
            }
        }
    }
    return best;
}

void Handles::begin(Part part, const vec2& pixel) {
    part_ = part;
    taken_ = at_;
    taken_eye_ = eye_;
    taken_pixel_ = pixel;
}

dvec3 Handles::axis(Part part) const {
    const int i = index_of(part);
    return i < 0 ? taken_eye_.right() : dvec3(taken_.axes[i]);
}

dvec3 Handles::normal(Part part) const {
    const int i = index_of(part);
    return i < 0 ? taken_eye_.ahead() : dvec3(taken_.axes[i]);
}

HandleChange Handles::change(const vec2& pixel, bool snap, const SnapSteps& steps,
                             std::optional<double> typed) const {
    HandleChange result;
    const PickRay from = taken_eye_.ray(taken_pixel_), to = taken_eye_.ray(pixel);
    const dvec3& p = taken_.pivot;
    const int i = index_of(part_);
    const bool one_axis = part_ == Part::x || part_ == Part::y || part_ == Part::z;
    if (part_ == Part::range || part_ == Part::cone) {
        const auto a = on_plane(to, p, taken_eye_.ahead());
        if (part_ == Part::range) {
            const double now = a ? glm::length(*a - p) : taken_.range.value_or(1);
            result.range = std::max(0.01, typed.value_or(snapped(now, steps.metres, snap)));
            result.words = fmt::format("range {:.2f} m", result.range);
        } else {
            const dvec3 ahead = -dvec3(taken_.light_axes[2]);
            // In the plane of the cone's axis that faces the eye most.
            dvec3 facing = taken_eye_.ahead() - glm::dot(taken_eye_.ahead(), ahead) * ahead;
            facing = glm::length(facing) > 1e-6 ? glm::normalize(facing) : dvec3(taken_.light_axes[1]);
            const auto at = on_plane(to, p, facing);
            double angle = taken_.cone.value_or(0.5);
            if (at && glm::length(*at - p) > 1e-9) {
                angle = std::acos(std::clamp(glm::dot(glm::normalize(*at - p), ahead), -1.0, 1.0));
            }
            double degrees = glm::degrees(angle);
            degrees = typed.value_or(snapped(degrees, steps.degrees, snap));
            result.cone = glm::radians(std::clamp(degrees, 0.5, 90.0));
            result.words = fmt::format("cone {:.1f}\u00b0", glm::degrees(result.cone));
        }
        return result;
    }
    if (tool_ == Tool::rotate) {
        const dvec3 n = normal(part_);
        double angle = 0;
        const auto a = on_plane(from, p, n), b = on_plane(to, p, n);
        if (a && b && glm::length(*a - p) > 1e-9 && glm::length(*b - p) > 1e-9) {
            const dvec3 u = glm::normalize(*a - p), v = glm::normalize(*b - p);
            angle = std::atan2(glm::dot(n, glm::cross(u, v)), glm::dot(u, v));
        } else {
            angle = 0.01 * static_cast<double>(pixel.x - taken_pixel_.x);  // seen from the side
        }
        const double degrees = typed.value_or(snapped(glm::degrees(angle), steps.degrees, snap));
        result.turn = glm::angleAxis(glm::radians(degrees), n);
        result.words = fmt::format("{} {:+.1f}\u00b0",
                                   i < 0 ? "view" : kAxisNames[static_cast<std::size_t>(i)], degrees);
        return result;
    }
    if (tool_ == Tool::scale) {
        double factor = 1;
        if (one_axis) {
            const auto a = along(from, p, axis(part_)), b = along(to, p, axis(part_));
            factor = a && b && std::abs(*a) > 1e-9 ? *b / *a : 1;
        } else {
            factor = std::exp(static_cast<double>(pixel.x - taken_pixel_.x) / 150);
        }
        factor = typed.value_or(snapped(factor, steps.share, snap));
        factor = std::clamp(factor, 1e-3, 1e3);
        if (one_axis) {
            result.stretch[i] = factor;
        } else {
            result.stretch = dvec3(factor);
        }
        result.words = fmt::format("{} \u00d7{:.2f}",
                                   one_axis ? kAxisNames[static_cast<std::size_t>(i)] : "all", factor);
        return result;
    }
    if (one_axis) {
        const dvec3 way = axis(part_);
        const auto a = along(from, p, way), b = along(to, p, way);
        double metres = a && b ? *b - *a : 0;
        metres = typed.value_or(snapped(metres, steps.metres, snap));
        result.move = metres * way;
        result.words = fmt::format("{} {:+.2f} m", kAxisNames[static_cast<std::size_t>(i)], metres);
        return result;
    }
    const dvec3 n = normal(part_);
    const auto a = on_plane(from, p, n), b = on_plane(to, p, n);
    dvec3 way = a && b ? *b - *a : dvec3(0);
    if (typed) {
        way = *typed * (i < 0 ? taken_eye_.right() : dvec3(taken_.axes[(i + 1) % 3]));
    } else if (snap) {
        for (int k = 0; k < 3; ++k) {
            const dvec3 u = taken_.axes[k];
            const double part = glm::dot(way, u);
            way += (snapped(part, steps.metres, true) - part) * u;
        }
    }
    result.move = way;
    result.words = fmt::format("{:+.2f} {:+.2f} {:+.2f} m", way.x, way.y, way.z);
    return result;
}

}  // namespace lanthorn::edit_window
