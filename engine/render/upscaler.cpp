#include "engine/render/upscaler.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "engine/render/fullscreen.h"

namespace lanthorn::render {

namespace {

constexpr float kMostKnown = 8;       // samples that a still pixel's past counts for
constexpr float kShiftsAPixel = 8;    // of the whole picture
constexpr float kLeastCosine = 0.5f;  // of what a camera turns in a frame
constexpr float kOtherAngle = 1.1f;   // of view, to the one before

// The number of index `i`, from 1 on, in base `base` (Halton 1964): its digits mirrored at the point.
float halton(std::uint64_t i, std::uint64_t base) {
    double result = 0, place = 1;
    for (; i > 0; i /= base) {
        place /= static_cast<double>(base);
        result += place * static_cast<double>(i % base);
    }
    return static_cast<float>(result);
}

void copy(const gpu::Texture& from, const gpu::Texture& to) {
    glCopyImageSubData(from.id(), GL_TEXTURE_2D, 0, 0, 0, 0, to.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       from.size().x, from.size().y, 1);
}

struct Input {
    const char* name;
    const gpu::Texture* texture;
};

// To texture units from 0 on.
void bind(const gpu::Program& program, std::span<const Input> inputs) {
    GLuint unit = 0;
    for (const Input& input : inputs) {
        input.texture->bind(unit);
        program.set(input.name, static_cast<int>(unit++));
    }
}

}  // namespace

Upscaler::Upscaler(ivec2 drawn, ivec2 whole)
    : drawn_(drawn),
      whole_(whole),
      final_(gpu::Texture::make_2d(GL_RGBA8, whole)),
      final_framebuffer_({&final_}, nullptr),
      mean_(gpu::Texture::make_2d(GL_RGBA16F, drawn)),
      spread_(gpu::Texture::make_2d(GL_RGBA16F, drawn)),
      motion_(gpu::Texture::make_2d(GL_RGBA32F, drawn)),
      distance_before_(gpu::Texture::make_2d(GL_R32F, drawn)),
      normals_before_(gpu::Texture::make_2d(GL_RGBA16_SNORM, drawn)),
      guide_framebuffer_({&mean_, &spread_, &motion_}, nullptr),
      still_guide_framebuffer_({&mean_, &spread_}, nullptr),
      movers_(drawn),
      sharpen_({"engine/render/fullscreen.vert", "engine/render/upscale_sharpen.frag"}) {
    mean_.set_filter(GL_LINEAR, GL_LINEAR);
    spread_.set_filter(GL_LINEAR, GL_LINEAR);
    for (int i = 0; i < 2; ++i) {
        history_[i] = gpu::Texture::make_2d(GL_RGBA16F, whole);
        history_[i].set_filter(GL_LINEAR, GL_LINEAR);
        history_framebuffers_[i] = gpu::Framebuffer({&history_[i]}, nullptr);
    }
}

vec2 Upscaler::shift(std::uint64_t frame) const {
    const vec2 pixels = vec2(whole_) / vec2(drawn_);
    const auto shifts = static_cast<std::uint64_t>(std::lround(kShiftsAPixel * pixels.x * pixels.y));
    const std::uint64_t i = frame % std::clamp<std::uint64_t>(shifts, 8, 128) + 1;
    return vec2(halton(i, 2), halton(i, 3)) - 0.5f;
}

bool Upscaler::follows(const Frame& frame) const {
    if (!before_ || frame.cut || frame.origin != origin_before_ ||
        before_->orthographic != frame.through.orthographic) {
        return false;
    }
    const float angle = glm::length(frame.through.up) / glm::length(before_->up);
    return glm::dot(before_->forward, frame.through.forward) > kLeastCosine && angle < kOtherAngle &&
           angle > 1 / kOtherAngle;
}

void Upscaler::add(const Frame& frame, const RenderSettings& settings) {
    const bool with_history = settings.upscale == Upscale::temporal && follows(frame);
    const bool moving = with_history && !frame.still;
    if (with_history) {
        guide(frame, moving);
    }
    resolve(frame, with_history, moving);
    if (settings.upscale == Upscale::temporal) {
        copy(frame.gbuffer.distance(), distance_before_);
        copy(frame.gbuffer.normals(), normals_before_);
        before_ = frame.through;
        shift_before_ = frame.camera.shift;
        origin_before_ = frame.origin;
    }
    sharpen_.set("whole", 0);
    sharpen_.set("sharpness", settings.upscale_sharpness);
    history().bind(0);
    draw_fullscreen(sharpen_, final_framebuffer_, whole_);
}

void Upscaler::guide(const Frame& frame, bool moving) {
    std::vector<std::string> defines;
    if (moving) {
        defines.emplace_back("MOVING");
        if (movers_.draw(frame.gbuffer, frame.scene, frame.camera, *before_)) {
            defines.emplace_back("WITH_MOVERS");
        }
    }
    const gpu::Program& program = guide_.with(defines);
    const Input inputs[] = {{"picture", &frame.picture},
                            {"gbuffer_distance", &frame.gbuffer.distance()},
                            {"gbuffer_normals", &frame.gbuffer.normals()},
                            {"distance_before", &distance_before_},
                            {"normals_before", &normals_before_},
                            {"movers", &movers_.motion()},
                            {"history", &history()}};
    bind(program, inputs);
    frame.camera.set(program);
    program.set("shift", frame.camera.shift);
    program.set("shift_before", shift_before_);
    if (moving) {
        set_before(program, *before_);
    }
    draw_fullscreen(program, moving ? guide_framebuffer_ : still_guide_framebuffer_, drawn_);
}

void Upscaler::resolve(const Frame& frame, bool with_history, bool moving) {
    std::vector<std::string> defines;
    if (with_history) {
        defines.emplace_back("WITH_HISTORY");
    }
    if (moving) {
        defines.emplace_back("MOVING");
    }
    const gpu::Program& program = resolve_.with(defines);
    const Input inputs[] = {{"picture", &frame.picture}, {"guide_mean", &mean_},
                            {"guide_spread", &spread_},  {"guide_motion", &motion_},
                            {"history", &history()},     {"smoothed", &frame.smoothed}};
    bind(program, inputs);
    program.set("shift", frame.camera.shift);
    program.set("ratio", vec2(drawn_) / vec2(whole_));
    program.set("most_known", kMostKnown);
    latest_ = 1 - latest_;
    draw_fullscreen(program, history_framebuffers_[latest_], whole_);
}

}  // namespace lanthorn::render
