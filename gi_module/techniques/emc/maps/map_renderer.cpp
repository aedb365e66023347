#include "gi_module/techniques/emc/maps/map_renderer.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::gi {

namespace {

// Of the scene's diagonal or, in a larger world, of so many metres.
constexpr float kNearPlane = 1e-5f;
constexpr float kLarge = 32;
// Cells in which a blended surface is open or solid, of the same length: several texels of a near map.
constexpr float kScreenCell = 1.0f / 64;

float power_of_two(float least) {
    return std::exp2(std::ceil(std::log2(std::max(least, 1e-30f))));
}

}  // namespace

CubeMaps::CubeMaps(int slots, int resolution, MapUse use)
    : slots_(slots),
      resolution_(resolution),
      use_(use),
      planes_(gpu::Texture::make_2d_array(use == MapUse::coverage ? GL_RGBA32F : GL_RG32UI, ivec2(resolution),
                                          6 * slots)),
      depth_(gpu::Texture::make_2d_array(GL_DEPTH_COMPONENT32F, ivec2(resolution), 6 * slots)) {
    if (use != MapUse::coverage) {
        albedo_ = gpu::Texture::make_2d_array(GL_RGBA16F, ivec2(resolution), 6 * slots);
        framebuffer_ = gpu::Framebuffer({&planes_, &albedo_}, &depth_);
    } else {
        framebuffer_ = gpu::Framebuffer({&planes_}, &depth_);
    }
}

void CubeMaps::clear(int layer) {
    const vec4 nothing(0.0f);  // zero bits, as floats and as integers
    const bool tracing = use_ != MapUse::coverage;
    const float far_depth = 0.0f;
    glClearTexSubImage(planes_.id(), 0, 0, 0, layer, resolution_, resolution_, 1,
                       tracing ? GL_RG_INTEGER : GL_RGBA, tracing ? GL_UNSIGNED_INT : GL_FLOAT, &nothing.x);
    glClearTexSubImage(depth_.id(), 0, 0, 0, layer, resolution_, resolution_, 1, GL_DEPTH_COMPONENT, GL_FLOAT,
                       &far_depth);
}

void CubeMaps::copy(int layer, const CubeMaps& from, int layer_of_it) {
    const auto copy_texture = [&](const gpu::Texture& source, const gpu::Texture& target) {
        glCopyImageSubData(source.id(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer_of_it, target.id(),
                           GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, resolution_, resolution_, 1);
    };
    copy_texture(from.planes_, planes_);
    copy_texture(from.depth_, depth_);
    if (use_ != MapUse::coverage) {
        copy_texture(from.albedo_, albedo_);
    }
}

void LayerList::clear() {
    runs_.clear();
    layers_.clear();
    indices_.clear();
}

void LayerList::add(std::uint32_t instance, std::uint32_t level, const vec3& centre, int layer) {
    if (runs_.empty() || runs_.back().instance != instance || runs_.back().level != level) {
        runs_.push_back({instance, level, 0, static_cast<std::uint32_t>(layers_.size())});
    }
    ++runs_.back().layers;
    layers_.emplace_back(centre, static_cast<float>(layer));
}

void LayerList::begin_some(std::uint32_t instance, const vec3& centre, int layer) {
    runs_.push_back({instance, 0, 1, static_cast<std::uint32_t>(layers_.size()),
                     static_cast<std::uint32_t>(indices_.size()), 0});
    layers_.emplace_back(centre, static_cast<float>(layer));
}

void LayerList::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    indices_.insert(indices_.end(), {a, b, c});
    runs_.back().index_count += 3;
}

MapRenderer::MapRenderer(MapUse use)
    : program_({"gi_module/techniques/emc/maps/environment_map.vert",
                "gi_module/techniques/emc/maps/environment_map.frag"},
               {use == MapUse::coverage ? "TRACING 0" : "TRACING 1",
                use == MapUse::caster ? "CASTER 1" : "CASTER 0"}) {}

void MapRenderer::draw(const CubeMaps& maps, const render::GpuScene& scene, const LayerList& list,
                       float scene_diagonal) {
    if (list.empty()) {
        return;
    }
    maps.bind_for_drawing();
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    program_.use();
    program_.set("near_plane", kNearPlane * std::min(scene_diagonal, kLarge));
    program_.set("screen_cell", power_of_two(kScreenCell * std::min(scene_diagonal, kLarge)));
    layers_.hold(std::span<const vec4>(list.layers_)).bind_storage(8);
    scene.draw_tagged(program_, list.runs_, render::Culling::none, list.indices_);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace lanthorn::gi
