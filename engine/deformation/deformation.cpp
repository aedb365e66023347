#include "engine/deformation/deformation.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "engine/deformation/frame_pool.h"
#include "engine/deformation/mesh_library.h"
#include "engine/deformation/pose.h"
#include "engine/deformation/serials.h"
#include "engine/ecs/parallel.h"
#include "engine/ecs/query.h"
#include "engine/scene/spawn.h"

namespace lanthorn {
namespace {

using deform::BindPose;
using deform::JointMatrix;
using deform::kBlockGroups;
using deform::kBlockVertices;
using deform::VertexGroup;
using ecs::Entity;

// Blocks that one task takes.
constexpr std::uint32_t kJobBlocks = 4;

struct MeshState {
    std::uint32_t index = 0;                               // into the assets' meshes
    std::shared_ptr<const deform::PreparedMesh> mesh;      // null: does not deform
    std::vector<deform::ActiveMorph> morphs, next_morphs;  // of the output, of this frame
    deform::FramePool pool;
    DeformedMesh output;
    bool stale = true;  // the output is not this frame's
};

struct EntityState {
    Entity entity;
    std::uint64_t seen = 0;  // update
    deform::PoseSources sources;
    deform::Pose pose, next_pose;  // of the outputs, of this frame
    std::vector<MeshState> meshes;
    std::string_view pose_problem, weights_problem;
};

// Some blocks of one mesh.
struct Job {
    const EntityState* entity;
    const MeshState* mesh;
    VertexFrame* to;
    std::uint32_t first_block, end_block;
    deform::BoundsLanes bounds;
};

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

std::string described(const ecs::World& world, Entity e) {
    const Name* name = world.try_get<Name>(e);
    return name ? ecs::to_string(e) + " '" + name->value + "'" : ecs::to_string(e);
}

bool same(const DeformedMeshes& a, const DeformedMeshes& b) {
    return a.skinned == b.skinned && a.skinned_at == b.skinned_at &&
           std::equal(a.meshes.begin(), a.meshes.end(), b.meshes.begin(), b.meshes.end(),
                      [](const DeformedMesh& x, const DeformedMesh& y) {
                          return x.version == y.version && x.vertices == y.vertices && x.refined == y.refined;
                      });
}

void run(Job& job) {
    const BindPose& pose = job.mesh->mesh->pose;
    const std::span<const VertexGroup> all(pose.groups);
    VertexGroup morphed[kBlockGroups];
    for (std::uint32_t block = job.first_block; block < job.end_block; ++block) {
        const std::uint32_t first = block * kBlockGroups;
        auto groups = all.subspan(first, std::min<std::size_t>(kBlockGroups, all.size() - first));
        if (!job.mesh->morphs.empty()) {
            std::copy(groups.begin(), groups.end(), morphed);
            deform::add_morphs(pose, block, job.mesh->morphs, {morphed, groups.size()});
            groups = {morphed, groups.size()};
        }
        VertexFrame* const to = job.to + std::size_t{block} * kBlockVertices;
        const deform::Pose& joints = job.entity->pose;
        if (!joints.skinned) {
            deform::copy_groups(pose, first, groups, to, job.bounds);
        } else if (pose.skin.empty()) {
            deform::move_groups(pose, joints.joints.back(), first, groups, to, job.bounds);
        } else {
            deform::skin_groups(pose, joints.joints, first, groups, to, job.bounds);
        }
    }
}

}  // namespace

struct Deformation::Impl {
    using Meshes = ecs::detail::QueryState<ecs::Read<MeshInstances>, ecs::Optional<ecs::Read<SkinInstance>>,
                                           ecs::Optional<ecs::Read<MorphWeights>>,
                                           ecs::Optional<ecs::Read<WorldTransform>>>;
    using MeshQuery =
        ecs::Query<ecs::Read<MeshInstances>, ecs::Optional<ecs::Read<SkinInstance>>,
                   ecs::Optional<ecs::Read<MorphWeights>>, ecs::Optional<ecs::Read<WorldTransform>>>;
    using Written = ecs::detail::QueryState<ecs::Read<DeformedMeshes>>;
    using WrittenQuery = ecs::Query<ecs::Read<DeformedMeshes>>;

    std::uint64_t world_id = 0;
    std::uint64_t updates = 0;
    Meshes meshes_query;
    Written written_query;
    deform::MeshLibrary library;
    std::vector<std::unique_ptr<EntityState>> states;  // by entity index
    std::vector<EntityState*> present;                 // of this update, in the order of the query
    std::vector<Entity> gone;
    std::vector<Job> jobs;
    std::vector<std::pair<MeshState*, std::uint32_t>> redone;  // and how many jobs it has
    DeformedMeshes written;                                    // scratch
    std::vector<std::string> warnings;

    void find_entities(ecs::World& world);
    EntityState& state_of(Entity e, const MeshInstances& meshes);
    void take(const ecs::World& world, EntityState& state) const;
    void plan();
    void collect(const ecs::World& world);
    void write(ecs::World& world);
    void drop_unseen(ecs::World& world);
};

EntityState& Deformation::Impl::state_of(Entity e, const MeshInstances& meshes) {
    if (e.index >= states.size()) states.resize(e.index + 1);
    auto& slot = states[e.index];
    if (!slot || slot->entity != e) {
        slot = std::make_unique<EntityState>();
        slot->entity = e;
    }
    if (slot->meshes.size() != meshes.meshes.size()) slot->meshes.resize(meshes.meshes.size());
    for (std::size_t i = 0; i < meshes.meshes.size(); ++i) {
        MeshState& mesh = slot->meshes[i];
        const auto& prepared = library.find(meshes.meshes[i]);
        mesh.index = meshes.meshes[i];
        if (mesh.mesh == prepared) continue;
        mesh.mesh = prepared;
        mesh.output = {};
        mesh.stale = true;
    }
    return *slot;
}

void Deformation::Impl::find_entities(ecs::World& world) {
    present.clear();
    meshes_query.update(world);
    MeshQuery(world, meshes_query, 0, world.now())
        .each([&](Entity e, const MeshInstances& meshes, const SkinInstance* skin,
                  const MorphWeights* weights, const WorldTransform* transform) {
            if (std::none_of(meshes.meshes.begin(), meshes.meshes.end(),
                             [&](std::uint32_t mesh) { return library.find(mesh) != nullptr; })) {
                return;
            }
            EntityState& state = state_of(e, meshes);
            state.seen = updates;
            state.sources = {skin, weights, transform};
            present.push_back(&state);
        });
}

// Fills next_pose and next_morphs and tells which outputs are stale. Runs in parallel.
void Deformation::Impl::take(const ecs::World& world, EntityState& state) const {
    std::size_t last_joint = 0;
    bool own_matrix = false;
    for (const MeshState& mesh : state.meshes) {
        if (!mesh.mesh) continue;
        const deform::SkinStream& skin = mesh.mesh->pose.skin;
        last_joint = std::max<std::size_t>(last_joint, skin.last_joint);
        own_matrix = own_matrix || skin.empty();
    }
    state.weights_problem = {};
    state.pose_problem = deform::take_pose(world, state.sources, last_joint, own_matrix, state.next_pose);
    if (!state.pose_problem.empty()) return;
    const bool moved = state.pose.skinned != state.next_pose.skinned ||
                       !same_bytes(state.pose.joints, state.next_pose.joints);
    std::swap(state.pose, state.next_pose);
    for (MeshState& mesh : state.meshes) {
        if (!mesh.mesh) continue;
        const std::string_view problem =
            deform::take_weights(state.sources.weights, mesh.mesh->pose, mesh.next_morphs);
        if (!problem.empty()) state.weights_problem = problem;
        mesh.stale = mesh.stale || moved || mesh.morphs != mesh.next_morphs;
        std::swap(mesh.morphs, mesh.next_morphs);
    }
}

void Deformation::Impl::plan() {
    jobs.clear();
    redone.clear();
    for (EntityState* state : present) {
        if (!state->pose_problem.empty()) continue;
        const auto& joints = state->pose.joints;
        const auto mirrored =
            static_cast<std::size_t>(std::count_if(joints.begin(), joints.end(), deform::mirrors));
        for (MeshState& mesh : state->meshes) {
            if (!mesh.mesh || !mesh.stale) continue;
            mesh.stale = false;
            mesh.output = {};
            const BindPose& pose = mesh.mesh->pose;
            if (!state->pose.skinned && pose.morphs.empty()) continue;
            auto vertices = mesh.pool.take(pose.vertex_count);
            const std::size_t first_job = jobs.size();
            for (std::uint32_t block = 0; block < pose.block_count(); block += kJobBlocks) {
                jobs.push_back({state,
                                &mesh,
                                vertices->data(),
                                block,
                                std::min(block + kJobBlocks, pose.block_count()),
                                {}});
            }
            mesh.output.version = deform::next_serial();
            mesh.output.vertices = std::move(vertices);
            const bool turned = pose.skin.empty() ? !joints.empty() && deform::mirrors(joints.back())
                                                  : mirrored * 2 > joints.size();
            if (turned) mesh.output.refined = library.turned(mesh.index);
            redone.emplace_back(&mesh, static_cast<std::uint32_t>(jobs.size() - first_job));
        }
    }
}

void Deformation::Impl::collect(const ecs::World& world) {
    std::size_t job = 0;
    for (auto& [mesh, count] : redone) {
        bool finite = true;
        for (std::uint32_t i = 0; i < count; ++i, ++job) {
            mesh->output.bounds.add(jobs[job].bounds.box());
            finite = finite && jobs[job].bounds.finite();
        }
        if (finite) continue;
        mesh->output = {};
        warnings.push_back(described(world, jobs[job - 1].entity->entity) + ": mesh '" + mesh->mesh->name +
                           "': its vertices are moved beyond all bounds; drawn as it is");
    }
    for (const EntityState* state : present) {
        if (!state->pose_problem.empty()) {
            warnings.push_back(described(world, state->entity) + ": " + std::string(state->pose_problem) +
                               "; keeps its last shape");
        }
        if (!state->weights_problem.empty()) {
            warnings.push_back(described(world, state->entity) + ": " + std::string(state->weights_problem));
        }
    }
    std::sort(warnings.begin(), warnings.end());
}

void Deformation::Impl::write(ecs::World& world) {
    for (EntityState* state : present) {
        const DeformedMeshes* before = world.try_get<DeformedMeshes>(state->entity);
        written.meshes.clear();
        for (const MeshState& mesh : state->meshes) written.meshes.push_back(mesh.output);
        const bool keeps = !state->pose_problem.empty() && before;
        written.skinned = keeps ? before->skinned : state->pose_problem.empty() && state->pose.skinned;
        written.skinned_at = keeps ? before->skinned_at : state->pose.at;
        if (!before) {
            world.add(state->entity, written);
        } else if (!same(*before, written)) {
            world.get_mut<DeformedMeshes>(state->entity) = written;
        }
    }
    written.meshes.clear();
}

void Deformation::Impl::drop_unseen(ecs::World& world) {
    gone.clear();
    written_query.update(world);
    WrittenQuery(world, written_query, 0, world.now()).each([&](Entity e, const DeformedMeshes&) {
        const EntityState* state = e.index < states.size() ? states[e.index].get() : nullptr;
        if (!state || state->entity != e || state->seen != updates) gone.push_back(e);
    });
    for (const Entity e : gone) world.remove<DeformedMeshes>(e);
    for (auto& state : states) {
        if (state && state->seen != updates) state.reset();
    }
}

Deformation::Deformation() : impl_(std::make_unique<Impl>()) {}
Deformation::Deformation(Deformation&&) noexcept = default;
Deformation& Deformation::operator=(Deformation&&) noexcept = default;
Deformation::~Deformation() = default;

const std::vector<std::string>& Deformation::warnings() const {
    return impl_->warnings;
}

void Deformation::update(ecs::World& world) {
    Impl& d = *impl_;
    if (world.id() != d.world_id) {
        *impl_ = Impl{};
        d.world_id = world.id();
    }
    ++d.updates;
    d.warnings.clear();
    const SharedAssets* assets = world.try_resource<SharedAssets>();
    d.library.follow(assets ? *assets : nullptr);
    d.find_entities(world);
    ecs::detail::parallel_for(d.present.size(), [&](std::size_t i) { d.take(world, *d.present[i]); });
    d.plan();
    ecs::detail::parallel_for(d.jobs.size(), [&](std::size_t i) { run(d.jobs[i]); });
    d.collect(world);
    d.write(world);
    d.drop_unseen(world);
}

}  // namespace lanthorn
