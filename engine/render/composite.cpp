#include "lanthorn/render/composite.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/render/bloom.h"
#include "engine/render/fullscreen.h"
#include "engine/render/fxaa.h"

namespace lanthorn::render {

namespace {

// composite_state.glsl
struct State {
    float exposure = 0;
    float average_luminance = 0;
    std::uint32_t nan_count = 0;
    std::uint32_t reserved = 0;
    vec4 around{0};
};
static_assert(sizeof(State) == 32 && offsetof(State, average_luminance) == 4 &&
              offsetof(State, nan_count) == 8 && offsetof(State, around) == 16);
constexpr GLuint kStateBinding = 4;

}  // namespace

Composite::Composite(ivec2 size, const gpu::Texture& depth)
    : size_(size),
      radiance_(gpu::Texture::make_2d(GL_RGBA32F, size)),
      final_(gpu::Texture::make_2d(GL_RGBA8, size)),
      radiance_framebuffer_({&radiance_}, &depth),
      final_framebuffer_({&final_}, nullptr),
      state_(sizeof(State)) {}

Composite::~Composite() = default;

void Composite::display(const RenderSettings& settings, bool reset_exposure, gpu::PassTimer* timer,
                        const Shown& as) {
    const bool rims = as.fuzzy != nullptr && settings.rim > 0;
    state_.bind_storage(kStateBinding);
    expose(settings, reset_exposure, rims);
    if (as.exposed != nullptr) {
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glCopyNamedBufferSubData(as.exposed->state_.id(), state_.id(), offsetof(State, exposure),
                                 offsetof(State, exposure), sizeof(State::exposure));
    }
    const bool blooms = settings.bloom_share > 0;
    const bool compute = in_compute(settings.pixel_stage);
    std::vector<std::string> defines;
    for (const auto& [there, define] : {std::pair(blooms, "WITH_BLOOM"), std::pair(rims, "WITH_RIM"),
                                        std::pair(settings.shoulder > 0, "WITH_SHOULDER")}) {
        if (there) {
            defines.emplace_back(define);
        }
    }
    const gpu::Program& program = (compute ? compute_display_ : display_).with(defines);
    if (blooms) {
        std::optional<gpu::PassTimer::Scope> pass;
        if (timer != nullptr) {
            pass.emplace(*timer, "bloom");
        }
        if (!bloom_) {
            bloom_ = std::make_unique<Bloom>(size_);
        }
        bloom_->scatter(radiance_, settings.bloom_spread);
        program.set("scattered", 1);
        program.set("scattered_share", settings.bloom_share);
        bloom_->scattered().bind(1);
    }
    if (rims) {
        as.fuzzy->gbuffer.distance().bind(2);
        as.fuzzy->gbuffer.normals().bind(3);
        as.fuzzy->gbuffer.material().bind(4);
        program.set("gbuffer_distance", 2);
        program.set("gbuffer_normals", 3);
        program.set("gbuffer_material", 4);
        program.set("rim_depth", settings.rim);
        as.fuzzy->camera.set(program);
    }
    if (settings.shoulder > 0) {
        program.set("shoulder", settings.shoulder);
    }
    program.set("radiance", 0);
    program.set("tone_map", static_cast<int>(settings.tone_map));
    radiance_.bind(0);
    if (compute) {
        compute_fullscreen(program, final_, size_);
    } else {
        draw_fullscreen(program, final_framebuffer_, size_);
    }
    smoothed_ = settings.antialias;
    if (smoothed_) {
        if (!fxaa_) {
            fxaa_ = std::make_unique<Fxaa>(size_);
        }
        fxaa_->smooth(final_);
    }
}

const gpu::Texture& Composite::unsmoothed() const {
    return smoothed_ ? fxaa_->source() : final_;
}

void Composite::combine(const GBuffer& gbuffer, const Parts& parts, const SkyTexture& sky,
                        const CameraUniforms& camera, PixelStage stage) {
    struct Input {
        const char* name;
        const gpu::Texture* texture;
    };
    const Input inputs[] = {{"gbuffer_distance", &gbuffer.distance()},
                            {"gbuffer_normals", &gbuffer.normals()},
                            {"gbuffer_albedo", &gbuffer.albedo()},
                            {"gbuffer_material", &gbuffer.material()},
                            {"gbuffer_emissive", &gbuffer.emissive()},
                            {"direct_radiance", parts.direct},
                            {"indirect_irradiance", parts.indirect_irradiance},
                            {"indirect_specular", parts.indirect_specular}};
    std::vector<std::string> defines;
    for (const auto& [there, define] : {std::pair(!sky.empty(), "WITH_SKY"),
                                        std::pair(parts.indirect_irradiance != nullptr, "WITH_IRRADIANCE"),
                                        std::pair(parts.indirect_specular != nullptr, "WITH_SPECULAR")}) {
        if (there) {
            defines.emplace_back(define);
        }
    }
    const bool compute = in_compute(stage);
    const gpu::Program& program = (compute ? compute_combine_ : combine_).with(defines);
    state_.bind_storage(kStateBinding);
    GLuint unit = 0;
    for (const Input& input : inputs) {
        (input.texture != nullptr ? input.texture : parts.direct)->bind(unit);
        program.set(input.name, static_cast<int>(unit++));
    }
    if (!sky.empty()) {
        sky.bind(program, unit++);
    }
    brdf_table_.bind(program, unit++);
    camera.set(program);
    program.set("emissive_scale", gbuffer.emissive_scale());
    if (compute) {
        compute_fullscreen(program, radiance_, size_);
    } else {
        draw_fullscreen(program, radiance_framebuffer_, size_);
    }
}

void Composite::take(const gpu::Texture& radiance) {
    glCopyImageSubData(radiance.id(), GL_TEXTURE_2D, 0, 0, 0, 0, radiance_.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       size_.x, size_.y, 1);
}

void Composite::expose(const RenderSettings& settings, bool reset, bool around) {
    const gpu::Program& program =
        expose_.with(around ? std::vector<std::string>{"WITH_AROUND"} : std::vector<std::string>());
    program.set("radiance", 0);
    program.set("manual", settings.exposure_mode == ExposureMode::manual ? 1 : 0);
    program.set("manual_exposure", exposure_of_ev100(settings.exposure_ev100));
    program.set("compensation", std::exp2(settings.exposure_compensation));
    program.set("darkest", settings.exposure_darkest);
    program.set("rate", reset ? 1.0f : settings.exposure_glide);
    radiance_.bind(0);
    program.use();
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

float Composite::exposure() const {
    return state_.read<State>(1).front().exposure;
}

std::uint32_t Composite::nan_count() const {
    return state_.read<State>(1).front().nan_count;
}

}  // namespace lanthorn::render
