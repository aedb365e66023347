#include "engine/render/line_pass.h"

#include <algorithm>
#include <cmath>

#include "engine/core/finite.h"
#include "engine/render/picture_strips.h"

namespace lanthorn::render {

namespace {

// What is left of a line after planes have cut it.
struct Range {
    double from = 0, to = 1;

    // By how far its ends are inside a plane; returns whether anything is left.
    bool cut(double at_from, double at_to) {
        if (at_from < 0 && at_to < 0) {
            return false;
        }
        if (at_from < 0) {
            from = std::max(from, at_from / (at_from - at_to));
        } else if (at_to < 0) {
            to = std::min(to, at_from / (at_from - at_to));
        }
        return from <= to;
    }
};

// Clip space of a point relative to the camera.
dvec4 clip(const CameraUniforms& camera, const dvec3& relative) {
    return dmat4(camera.clip_from_relative) * dvec4(relative, 1);
}

}  // namespace

std::optional<PictureLine> in_picture(const Line& line, const CameraUniforms& camera, const dvec3& origin,
                                      ivec2 size) {
    const dvec3 eye = origin + dvec3(camera.position);
    dvec3 from = line.from - eye, to = line.to - eye;
    if (!is_finite(from) || !is_finite(to) || !(line.width > 0)) {
        return std::nullopt;
    }
    const dvec4 a = clip(camera, from), b = clip(camera, to);
    // Sides are wider than the picture's by the line's width: its rim may be seen where its middle is not.
    const glm::dvec2 margin = 1.0 + 2.0 * (static_cast<double>(line.width) + 2) / glm::dvec2(size);
    Range seen;
    const bool any = seen.cut(a.w - a.z, b.w - b.z) && seen.cut(a.z, b.z) &&
                     seen.cut(margin.x * a.w - a.x, margin.x * b.w - b.x) &&
                     seen.cut(margin.x * a.w + a.x, margin.x * b.w + b.x) &&
                     seen.cut(margin.y * a.w - a.y, margin.y * b.w - b.y) &&
                     seen.cut(margin.y * a.w + a.y, margin.y * b.w + b.y);
    if (!any) {
        return std::nullopt;
    }
    const double pixel = 2 * static_cast<double>(glm::length(camera.up)) / size.y;
    PictureLine result{};
    for (const bool end : {false, true}) {
        const dvec4 p = glm::mix(a, b, end ? seen.to : seen.from);
        if (!(p.w > 0)) {
            return std::nullopt;
        }
        const glm::dvec2 at = (0.5 * glm::dvec2(p) / p.w + 0.5) * glm::dvec2(size);
        const double depth =
            camera.orthographic
                ? p.z + pixel * std::abs(static_cast<double>(glm::dot(
                                    vec3(camera.clip_from_relative[0].z, camera.clip_from_relative[1].z,
                                         camera.clip_from_relative[2].z),
                                    camera.forward)))
                : p.z / p.w * (1 + pixel);
        (end ? result.to : result.from) = vec2(at);
        (end ? result.to_depth : result.from_depth) = static_cast<float>(std::min(depth, 1.0));
    }
    result.colour = line.colour;
    result.width = line.width;
    return result;
}

LinePass::LinePass() : program_({"engine/render/line.vert", "engine/render/line.frag"}) {}

void LinePass::draw(std::span<const Line> everywhere, std::span<const Line> here,
                    const CameraUniforms& camera, const dvec3& origin, const gpu::Framebuffer& target,
                    ivec2 size) {
    lines_.clear();
    std::size_t tested = 0;
    for (const bool on_top : {false, true}) {
        for (const std::span<const Line> some : {everywhere, here}) {
            for (const Line& line : some) {
                if (line.on_top == on_top) {
                    if (const auto shown = in_picture(line, camera, origin, size)) {
                        lines_.push_back(*shown);
                    }
                }
            }
        }
        tested = on_top ? tested : lines_.size();
    }
    if (lines_.empty()) {
        return;
    }
    buffer_.hold(std::span<const PictureLine>(lines_)).bind_storage(kPictureStripsBinding);
    program_.set("picture_size", vec2(size));
    const PictureStrips strips(program_, target, size, PictureStrips::Alpha::straight);
    const auto draw_some = [&](std::size_t first, std::size_t count, bool hidden) {
        if (count > 0) {
            program_.set("first_line", static_cast<int>(first));
            strips.draw(count, hidden);
        }
    };
    draw_some(0, tested, true);
    draw_some(tested, lines_.size() - tested, false);
}

}  // namespace lanthorn::render
