#include "lanthorn/render/gbuffer.h"

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "engine/render/scene_textures.h"
#include "lanthorn/render/picture_only.h"

namespace lanthorn::render {

using gpu::Texture;

GBuffer::GBuffer(ivec2 size, DrawSet of)
    : size_(size),
      of_(of),
      distance_(Texture::make_2d(GL_R32F, size)),
      normals_(Texture::make_2d(GL_RGBA16_SNORM, size)),
      albedo_(Texture::make_2d(GL_RGBA16, size)),
      material_(Texture::make_2d(GL_RGBA8, size)),
      emissive_(Texture::make_2d(GL_RGBA16F, size)),
      depth_(Texture::make_2d(GL_DEPTH_COMPONENT32F, size)),
      framebuffer_({&distance_, &normals_, &albedo_, &material_, &emissive_}, &depth_),
      program_("engine/render/gbuffer.vert", "engine/render/gbuffer.frag",
               of == DrawSet::blend ? std::vector<std::string>{"BLENDED"} : std::vector<std::string>()) {}

void GBuffer::draw_all(const GpuScene& gpu_scene, const CameraUniforms& camera, const GBuffer* behind,
                       const Looks* looks) {
    // Half floats hold emission as a share of the scene's brightest, so that any unit of light fits.
    emissive_scale_ = gpu_scene.max_emissive() > 0 ? gpu_scene.max_emissive() : 1.0f;
    framebuffer_.bind(size_);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    const vec4 zero(0);
    const float far_depth = 0;
    for (GLint i = 0; i < 5; ++i) {
        glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, i, &zero.x);
    }
    glClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &far_depth);
    program_.prepare(gpu_scene.variants());
    camera.set(program_);
    program_.set("emissive_scale", emissive_scale_);
    if (behind != nullptr) {
        constexpr GLuint kUnit = static_cast<GLuint>(kMaterialTextures);
        behind->distance().bind(kUnit);
        program_.set("distance_behind", static_cast<int>(kUnit));
    }
    gpu_scene.find_visible(of_, camera.frustum(), visible_);
    const float pixel = 2 * glm::length(camera.up) / static_cast<float>(size_.y);
    const TexelSize texel{camera.position, camera.orthographic ? 0 : pixel, camera.orthographic ? pixel : 0};
    drawn_.clear();
    for (const std::uint32_t i : visible_) {
        drawn_.push_back({i, gpu_scene.picture_level(i, texel)});
    }
    const auto looked = [&](const DrawnInstance& drawn) {
        return looks != nullptr && looks->find(gpu_scene.id(drawn.instance)) != nullptr;
    };
    const auto first = std::stable_partition(drawn_.begin(), drawn_.end(), std::not_fn(looked));
    const auto plain = static_cast<std::size_t>(first - drawn_.begin());
    const std::span<DrawnInstance> others = std::span(drawn_).first(plain);
    gpu_scene.sort_near_first(others, camera.position);
    gpu_scene.draw(program_, others);
    if (plain < drawn_.size()) {
        draw_looked(gpu_scene, camera, plain, *looks);
    }
    glDisable(GL_DEPTH_TEST);
}

void GBuffer::draw_looked(const GpuScene& gpu_scene, const CameraUniforms& camera, std::size_t first,
                          const Looks& looks) {
    const auto look = [&](const DrawnInstance& drawn) -> const Look& {
        return *looks.find(gpu_scene.id(drawn.instance));
    };
    const auto by_look = [&](const DrawnInstance& drawn) {
        return std::tuple(look(drawn).shown, look(drawn).rim);
    };
    const std::span<DrawnInstance> rest = std::span(drawn_).subspan(first);
    std::ranges::stable_sort(rest, {}, by_look);
    if (!looked_) {
        looked_.emplace("engine/render/gbuffer.vert", "engine/render/gbuffer.frag",
                        std::vector<std::string>{"WITH_LOOK"});
    }
    looked_->prepare(gpu_scene.variants());
    camera.set(*looked_);
    looked_->set("emissive_scale", emissive_scale_);
    for (std::size_t begin = 0, end = 0; begin < rest.size(); begin = end) {
        const Look& one = look(rest[begin]);
        end = begin;
        while (end < rest.size() && by_look(rest[end]) == by_look(rest[begin])) {
            ++end;
        }
        looked_->set("look_shown", one.shown);
        looked_->set("look_rim", one.rim ? 1.0f : 0.0f);
        gpu_scene.draw(*looked_, rest.subspan(begin, end - begin));
    }
}

}  // namespace lanthorn::render
