#include "lanthorn/render/gpu_scene.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "engine/render/scene_textures.h"
#include "engine/scene/alpha_coverage.h"
#include "lanthorn/scene/diffuse_reflectance.h"

namespace lanthorn::render {

static_assert(kNumberedMaterials == lanthorn::kNumberedMaterials);

namespace {

constexpr GLuint kInstanceBuffer = 2;  // of the vertex array
constexpr GLuint kInstanceLocation = 6, kLayerLocation = 7;

// The instance's index: advances so slowly that baseInstance alone chooses it, and gl_InstanceID is free.
void add_instance_attribute(GLuint vertex_array, const gpu::Buffer& instance_indices) {
    glEnableVertexArrayAttrib(vertex_array, kInstanceLocation);
    for (const GLuint location : {kInstanceLocation, kLayerLocation}) {
        glVertexArrayAttribIFormat(vertex_array, location, 1, GL_UNSIGNED_INT,
                                   location == kLayerLocation ? sizeof(std::uint32_t) : 0);
        glVertexArrayAttribBinding(vertex_array, location, kInstanceBuffer);
    }
    glVertexArrayVertexBuffer(vertex_array, kInstanceBuffer, instance_indices.id(), 0, sizeof(std::uint32_t));
    glVertexArrayBindingDivisor(vertex_array, kInstanceBuffer, 1u << 30);
}

MaterialData describe(const Material& m) {
    MaterialData data{};
    data.base_colour = m.base_colour;
    data.emissive = vec4(m.emissive, m.alpha_cutoff);
    data.specular_colour = vec4(m.specular_colour, m.specular);
    const MaterialReflectance reflects = MaterialReflectance::of(m);
    data.reflects = vec4(reflects.boundary, reflects.transmittance, reflects.evenly, 0);
    data.volume = vec4(m.absorption(), m.thickness);
    data.metallic = m.metallic;
    data.roughness = m.roughness;
    data.normal_scale = m.normal_scale;
    data.occlusion_strength = m.occlusion_strength;
    data.ior = m.ior;
    data.transmission = m.transmission;
    data.flags = (m.unlit ? kMaterialUnlit : 0) | (m.double_sided ? kMaterialDoubleSided : 0) |
                 (m.alpha_mode == AlphaMode::mask ? kMaterialMask : 0) |
                 (m.alpha_mode == AlphaMode::blend ? kMaterialBlend : 0) | (m.emits() ? kMaterialEmits : 0);
    if (m.specular != 1 || m.specular_colour != vec3(1) || m.specular_texture.present() ||
        m.specular_colour_texture.present()) {
        data.flags |= kMaterialSpecular;
    }
    const auto references = m.textures();
    for (std::uint32_t i = 0; i < references.size(); ++i) {
        const TextureRef& reference = *references[i];
        if (reference.present()) {
            data.flags |= 1u << i;
        }
        if (reference.uv_set == 1) {
            data.uv_sets |= 1u << i;
        }
        data.uv_transform[2 * i] = vec4(reference.uv_transform[0], 0);
        data.uv_transform[2 * i + 1] = vec4(reference.uv_transform[1], 0);
    }
    return data;
}

InstanceData describe(const Instance& instance, std::uint32_t material) {
    InstanceData data{};
    const mat3 m(instance.transform);
    // The cofactor matrix takes normals where the inverse transpose does, and exists for flattened objects
    // too.
    mat3 normal(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const float determinant = glm::dot(m[0], normal[0]);
    float largest = 0;
    for (int i = 0; i < 3; ++i) {
        const vec3 a = glm::abs(normal[i]);
        largest = std::max({largest, a.x, a.y, a.z});
    }
    if (largest > 0) {
        normal *= (determinant < 0 ? -1.0f : 1.0f) / largest;
    }
    data.object_to_render = instance.transform;
    data.normal_x = vec4(normal[0], 0);
    data.normal_y = vec4(normal[1], 0);
    data.normal_z = vec4(normal[2], 0);
    data.material = material;
    data.id = instance.id;
    data.mirror = determinant < 0 ? -1.0f : 1.0f;
    return data;
}

bool same_instance(const InstanceData& a, const InstanceData& b) {
    return a.object_to_render == b.object_to_render && a.material == b.material && a.id == b.id;
}

}  // namespace

GpuScene::GpuScene() = default;
GpuScene::~GpuScene() = default;

void GpuScene::keep_before(bool keep) {
    keeps_before_ = keep;
    geometry_.keep_before(keep);
    if (!keep) {
        placed_.clear();
    }
}

void GpuScene::update(const FrameScene& scene) {
    uploaded_ = {};
    movers_.clear();
    const bool other_assets = scene.assets->serial != serial_;
    if (other_assets) {
        follow_assets(*scene.assets);
        serial_ = scene.assets->serial;
    }
    const bool skipped = scene.frame != last_frame_ && scene.frame != last_frame_ + 1;
    last_frame_ = scene.frame;
    if (other_assets || skipped || scene.changes.geometry || scene.instances.size() != instances_.size()) {
        geometry_.update(scene);
        uploaded_.geometry = geometry_.uploaded_bytes();
        upload_instances(scene);
        list_instances();
        if (keeps_before_) {
            list_movers(scene);
        }
    }
}

// Both lists are sorted by id and mesh.
void GpuScene::list_movers(const FrameScene& scene) {
    const std::vector<Placed> before = std::exchange(placed_, {});
    placed_.reserve(scene.instances.size());
    auto old = before.begin();
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        placed_.push_back({instance.id, instance.mesh, instance.transform});
        const std::pair key(instance.id, instance.mesh);
        while (old != before.end() && std::pair(old->id, old->mesh) < key) {
            ++old;
        }
        if (old == before.end() || std::pair(old->id, old->mesh) != key) {
            continue;
        }
        if (geometry_.bent(i) || old->transform != instance.transform) {
            movers_.push_back({i, geometry_.bent(i), old->transform});
        }
    }
}

void GpuScene::draw_before(const gpu::Program& program, std::span<const DrawnInstance> instances,
                           bool bent) const {
    geometry_.bind_before(bent);
    draw_tagged(program, instances);
    geometry_.unbind_before();
}

GpuScene::MaterialState GpuScene::state_of(const Material& m, std::uint64_t version) {
    const float emissive = std::max({m.emissive.x, m.emissive.y, m.emissive.z});
    MaterialVariant variant = m.alpha_mode != AlphaMode::opaque ? kMaskedVariant : 0;
    const auto references = m.textures();
    for (std::uint32_t i = 0; i < references.size(); ++i) {
        variant |= references[i]->present() ? 1u << i : 0;
    }
    return {version, m.double_sided, m.alpha_mode, m.base_colour.a >= kSolidAlpha, variant, emissive};
}

void GpuScene::follow_assets(const SceneAssets& assets) {
    upload_materials(assets.materials);
    if (!textures_) {
        textures_ = std::make_unique<SceneTextures>();
    }
    textures_->follow(assets);
    uploaded_.images = textures_->uploaded_bytes();
}

void GpuScene::upload_materials(const AssetTable<Material>& materials) {
    const std::size_t bytes = materials.size() * sizeof(MaterialData);
    if (!material_buffer_ || material_buffer_.bytes() < bytes) {
        material_buffer_ = gpu::Buffer(bytes);
        materials_.clear();
    }
    materials_.resize(materials.size());
    for (std::size_t slot = 0; slot < materials.size(); ++slot) {
        if (!materials.has(slot) || materials_[slot].version == materials.version(slot).any) {
            continue;
        }
        const MaterialData data = describe(materials[slot]);
        material_buffer_.write_bytes(slot * sizeof(MaterialData), &data, sizeof(MaterialData));
        uploaded_.materials += sizeof(MaterialData);
        materials_[slot] = state_of(materials[slot], materials.version(slot).any);
    }
}

void GpuScene::upload_instances(const FrameScene& scene) {
    const std::size_t old_count = instances_.size();
    const std::size_t count = scene.instances.size();
    instances_.resize(count);
    bounds_.resize(count);
    deforms_.resize(count);
    const bool grown = !instance_buffer_ || instance_buffer_.bytes() < count * sizeof(InstanceData);
    if (grown) {
        instance_buffer_ = gpu::Buffer(count * sizeof(InstanceData));
        std::vector<std::uint32_t> indices(std::max<std::size_t>(count, 1));
        std::iota(indices.begin(), indices.end(), 0u);
        instance_indices_ = gpu::Buffer::from(indices);
    }
    const auto write_run = [&](std::size_t first, std::size_t end) {
        instance_buffer_.write_bytes(first * sizeof(InstanceData), instances_.data() + first,
                                     (end - first) * sizeof(InstanceData));
        uploaded_.instances += (end - first) * sizeof(InstanceData);
    };
    // Each run of altered instances is one write.
    std::size_t run = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Instance& instance = scene.instances[i];
        const InstanceData data = describe(instance, scene.mesh(instance).material);
        const bool altered = grown || i >= old_count || !same_instance(data, instances_[i]);
        instances_[i] = data;
        bounds_[i] = instance.bounds;
        deforms_[i] = instance.deformed != Instance::kNotDeformed;
        if (!altered) {
            write_run(run, i);
            run = i + 1;
        }
    }
    if (run < count) {
        write_run(run, count);
    }
    add_instance_attribute(geometry_.vertex_array(), instance_indices_);
}

void GpuScene::list_instances() {
    for (auto& list : lists_) {
        list.clear();
    }
    variants_.clear();
    triangles_ = 0;
    max_emissive_ = 0;
    std::vector<std::uint32_t> order(instances_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) {
        return std::pair(materials_[instances_[i].material].variant, instances_[i].material);
    });
    auto list = [&](DrawSet set) -> auto& {
        return lists_[static_cast<std::size_t>(set)];
    };
    for (const std::uint32_t i : order) {
        const MaterialState& material = materials_[instances_[i].material];
        list(DrawSet::all).push_back(i);
        if (material.alpha == AlphaMode::blend) {
            list(DrawSet::blend).push_back(i);
        }
        if (material.alpha != AlphaMode::blend || material.solid_parts) {
            list(DrawSet::solid).push_back(i);
        }
        if (variants_.empty() || variants_.back() != material.variant) {  // they come in order
            variants_.push_back(material.variant);
        }
        triangles_ += geometry_.range(i).index_count / 3;
        max_emissive_ = std::max(max_emissive_, material.emissive);
    }
}

void GpuScene::set_texture_bias(float levels) const {
    if (textures_) {
        textures_->set_bias(levels);
    }
}

std::span<const std::uint32_t> GpuScene::instances(DrawSet set) const {
    return lists_[static_cast<std::size_t>(set)];
}

void GpuScene::bind() const {
    instance_buffer_.bind_storage(kInstancesBinding);
    material_buffer_.bind_storage(kMaterialsBinding);
}

std::uint32_t GpuScene::level(std::uint32_t instance, const TexelSize& texel) const {
    const std::span<const SceneGeometry::Level> levels = geometry_.levels(instance);
    if (!levels_used_ || levels.empty()) {
        return 0;
    }
    const float may_be_off = kTexelsOff * texel_share(instance, texel);
    if (may_be_off > 1) {
        return kTooSmall;
    }
    std::uint32_t level = 0;
    while (level < levels.size() && levels[level].error <= may_be_off) {
        ++level;
    }
    return level;
}

std::uint32_t GpuScene::picture_level(std::uint32_t instance, const TexelSize& pixel) const {
    const std::span<const SceneGeometry::Level> levels = geometry_.levels(instance);
    if (!levels_used_ || levels.empty() || !deforms_[instance] ||
        materials_[instances_[instance].material].variant != 0) {
        return 0;
    }
    const float share = texel_share(instance, pixel);
    std::uint32_t level = 0;
    while (level < levels.size() && levels[level].error <= kPixelsOff * share &&
           levels[level].edge <= kPixelsLong * share) {
        ++level;
    }
    return level;
}

float GpuScene::texel_share(std::uint32_t instance, const TexelSize& texel) const {
    const Aabb& box = bounds_[instance];
    const float distance = glm::distance(texel.eye, glm::clamp(texel.eye, box.lower, box.upper));
    return (texel.spread * distance + texel.width) / box.diagonal();
}

SceneGeometry::Range GpuScene::range(const DrawnInstance& drawn) const {
    SceneGeometry::Range range = geometry_.range(drawn.instance);
    if (drawn.index_count > 0) {
        range.first_index = drawn.first_index;
        range.index_count = drawn.index_count;
    } else if (drawn.level > 0) {
        const SceneGeometry::Level& level = geometry_.levels(drawn.instance)[drawn.level - 1];
        range.first_index = level.first_index;
        range.index_count = level.index_count;
    }
    return range;
}

template <class DrawnOf, class ProgramOf>
void GpuScene::draw_list(std::size_t count, bool tagged, Culling culling, const DrawnOf& drawn,
                         const ProgramOf& program_of) const {
    if (count == 0) {
        return;
    }
    bind();
    glBindVertexArray(geometry_.vertex_array());
    const gpu::Program* program = nullptr;
    std::uint32_t material = ~0u;
    float mirror = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const DrawnInstance now = drawn(k);
        const InstanceData& instance = instances_[now.instance];
        if (instance.material != material) {
            material = instance.material;
            const MaterialState& state = materials_[material];
            const gpu::Program& wanted = program_of(state.variant);
            if (&wanted != program) {
                program = &wanted;
                program->use();
            }
            textures_->bind(material);
            if (culling == Culling::by_material && !state.double_sided) {
                glEnable(GL_CULL_FACE);
            } else {
                glDisable(GL_CULL_FACE);
            }
        }
        if (instance.mirror != mirror) {
            mirror = instance.mirror;
            glFrontFace(mirror < 0 ? GL_CW : GL_CCW);
        }
        const SceneGeometry::Range mesh = range(now);
        const std::size_t offset = std::size_t{mesh.first_index} * sizeof(std::uint32_t);
        glDrawElementsInstancedBaseVertexBaseInstance(
            GL_TRIANGLES, static_cast<GLsizei>(mesh.index_count), GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(offset),  // NOLINT(performance-no-int-to-ptr)
            now.layers, mesh.base_vertex, tagged ? static_cast<GLuint>(k) : now.instance);
    }
    glDisable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    SceneTextures::unbind();
}

void GpuScene::find_visible(DrawSet set, const Frustum& frustum, std::vector<std::uint32_t>& visible) const {
    visible.clear();
    std::ranges::copy_if(instances(set), std::back_inserter(visible),
                         [&](std::uint32_t i) { return frustum.touches(bounds_[i]); });
}

void GpuScene::sort_near_first(std::span<DrawnInstance> instances, const vec3& eye) const {
    std::ranges::stable_sort(instances, {}, [&](const DrawnInstance& drawn) {
        const Aabb& box = bounds_[drawn.instance];
        return glm::distance(glm::clamp(eye, box.lower, box.upper), eye);
    });
}

void GpuScene::draw(const gpu::Program& program, DrawSet set, int layers, Culling culling) const {
    draw(program, instances(set), layers, culling);
}

void GpuScene::draw(const gpu::Program& program, std::span<const std::uint32_t> instances, int layers,
                    Culling culling) const {
    draw_list(
        instances.size(), false, culling,
        [&](std::size_t k) -> DrawnInstance {
            return {instances[k], 0, layers};
        },
        [&](MaterialVariant) -> const gpu::Program& { return program; });
}

void GpuScene::draw(const SceneProgram& program, DrawSet set, int layers, Culling culling) const {
    draw(program, instances(set), layers, culling);
}

void GpuScene::draw(const SceneProgram& program, std::span<const std::uint32_t> instances, int layers,
                    Culling culling) const {
    draw_list(
        instances.size(), false, culling,
        [&](std::size_t k) -> DrawnInstance {
            return {instances[k], 0, layers};
        },
        [&](MaterialVariant variant) -> const gpu::Program& { return program.variant(variant); });
}

void GpuScene::draw(const SceneProgram& program, std::span<const DrawnInstance> instances,
                    Culling culling) const {
    draw_list(
        instances.size(), false, culling, [&](std::size_t k) { return instances[k]; },
        [&](MaterialVariant variant) -> const gpu::Program& { return program.variant(variant); });
}

void GpuScene::draw_tagged(const gpu::Program& program, std::span<const DrawnInstance> instances,
                           Culling culling, std::span<const std::uint32_t> indices) const {
    if (instances.empty()) {
        return;
    }
    std::vector<uvec2> tags;
    tags.reserve(instances.size());
    for (const DrawnInstance& drawn : instances) {
        tags.emplace_back(drawn.instance, drawn.first_layer);
    }
    const gpu::Buffer& buffer = tags_.hold(std::span<const uvec2>(tags));
    const GLuint vertex_array = geometry_.vertex_array();
    glVertexArrayVertexBuffer(vertex_array, kInstanceBuffer, buffer.id(), 0, sizeof(uvec2));
    glEnableVertexArrayAttrib(vertex_array, kLayerLocation);
    if (!indices.empty()) {
        glVertexArrayElementBuffer(vertex_array, some_.hold(indices).id());
    }
    draw_list(
        instances.size(), true, culling, [&](std::size_t k) { return instances[k]; },
        [&](MaterialVariant) -> const gpu::Program& { return program; });
    glVertexArrayElementBuffer(vertex_array, geometry_.indices().id());
    glDisableVertexArrayAttrib(vertex_array, kLayerLocation);
    glVertexArrayVertexBuffer(vertex_array, kInstanceBuffer, instance_indices_.id(), 0,
                              sizeof(std::uint32_t));
}

}  // namespace lanthorn::render
