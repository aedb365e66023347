#include "lanthorn/deformation/deformation.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "engine/deformation/mesh_jobs.h"
#include "engine/deformation/serials.h"
#include "engine/scene/described.h"
#include "lanthorn/ecs/kept_query.h"
#include "lanthorn/ecs/parallel.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/components.h"

namespace lanthorn {
namespace {

using deform::BindPose;
using deform::EntityState;
using deform::Job;
using deform::MeshState;
using deform::RefineJob;
using ecs::Entity;

// Blocks that one task takes.
constexpr std::uint32_t kJobBlocks = 4;
// Refined vertices that one task takes; a multiple of kLanes.
constexpr std::uint32_t kJobRefined = 1024;

// A mesh that is computed anew, and how many jobs that takes.
struct Redone {
    const EntityState* entity;
    MeshState* mesh;
    std::uint32_t jobs = 0, refine_jobs = 0;
};

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same(const DeformedMeshes& a, const DeformedMeshes& b) {
    return a.skinned == b.skinned && a.skinned_at == b.skinned_at &&
           std::equal(a.meshes.begin(), a.meshes.end(), b.meshes.begin(), b.meshes.end(),
                      [](const DeformedMesh& x, const DeformedMesh& y) {
                          return x.version == y.version && x.vertices == y.vertices && x.refined == y.refined;
                      });
}

}  // namespace

struct Deformation::Impl {
    std::uint64_t world_id = 0;
    std::uint64_t updates = 0;
    ecs::KeptQuery<ecs::Read<MeshInstances>, ecs::Optional<ecs::Read<SkinInstance>>,
                   ecs::Optional<ecs::Read<MorphWeights>>, ecs::Optional<ecs::Read<WorldTransform>>>
        meshes_query;
    ecs::KeptQuery<ecs::Read<DeformedMeshes>> written_query;
    deform::MeshLibrary library;
    std::vector<std::unique_ptr<EntityState>> states;  // by entity index
    std::vector<EntityState*> present;                 // of this update, in the order of the query
    std::vector<Entity> gone;
    std::vector<Job> jobs;
    std::vector<RefineJob> refine_jobs;
    std::vector<Redone> redone;
    DeformedMeshes written;  // scratch
    std::vector<std::string> warnings;

    void find_entities(const ecs::World& world);
    EntityState& state_of(Entity e, const MeshInstances& meshes);
    void take_morphs(EntityState& state) const;
    void take(const ecs::World& world, EntityState& state, const DetailHints* hints) const;
    void plan();
    void plan(EntityState& entity, MeshState& mesh, bool mirrored);
    void refine();
    void collect(const ecs::World& world);
    void warn(const ecs::World& world, const EntityState& entity, const MeshState* mesh,
              std::string_view problem);
    void write(const Writes& writes, ecs::Commands& commands);
    void drop_unseen(const ecs::World& world, ecs::Commands& commands);
};

EntityState& Deformation::Impl::state_of(Entity e, const MeshInstances& meshes) {
    if (e.index >= states.size()) {
        states.resize(e.index + 1);
    }
    auto& slot = states[e.index];
    if (!slot || slot->entity != e) {
        slot = std::make_unique<EntityState>();
        slot->entity = e;
    }
    if (slot->meshes.size() != meshes.meshes.size()) {
        slot->meshes.resize(meshes.meshes.size());
    }
    for (std::size_t i = 0; i < meshes.meshes.size(); ++i) {
        MeshState& mesh = slot->meshes[i];
        const auto& prepared = library.find(meshes.meshes[i]);
        mesh.index = meshes.meshes[i].slot;
        if (mesh.mesh == prepared) {
            continue;
        }
        mesh.mesh = prepared;
        mesh.output = {};
        mesh.stale = true;
    }
    return *slot;
}

void Deformation::Impl::find_entities(const ecs::World& world) {
    present.clear();
    meshes_query.in(world).each([&](Entity e, const MeshInstances& meshes, const SkinInstance* skin,
                                    const MorphWeights* weights, const WorldTransform* transform) {
        if (std::none_of(meshes.meshes.begin(), meshes.meshes.end(),
                         [&](MeshHandle mesh) { return library.find(mesh) != nullptr; })) {
            return;
        }
        EntityState& state = state_of(e, meshes);
        state.seen = updates;
        state.sources = {skin, weights, transform};
        present.push_back(&state);
    });
}

// Fills next_morphs. Runs in parallel.
void Deformation::Impl::take_morphs(EntityState& state) const {
    state.weights_problem = {};
    for (MeshState& mesh : state.meshes) {
        if (!mesh.mesh) {
            continue;
        }
        const std::string_view problem =
            deform::take_weights(state.sources.weights, mesh.mesh->pose, mesh.next_morphs);
        if (!problem.empty()) {
            state.weights_problem = problem;
        }
    }
}

// Fills next_pose and tells which outputs are stale. Runs in parallel.
void Deformation::Impl::take(const ecs::World& world, EntityState& state, const DetailHints* hints) const {
    std::size_t last_joint = 0;
    bool own_matrix = false;
    for (const MeshState& mesh : state.meshes) {
        if (!mesh.mesh) {
            continue;
        }
        const deform::SkinStream& skin = mesh.mesh->pose.skin;
        last_joint = std::max<std::size_t>(last_joint, skin.last_joint);
        own_matrix = own_matrix || skin.empty();
    }
    state.pose_problem = deform::take_pose(world, state.sources, last_joint, own_matrix, state.next_pose);
    if (!state.pose_problem.empty()) {
        state.weights_problem = {};
        return;
    }
    const bool moved = state.pose.skinned != state.next_pose.skinned ||
                       !same_bytes(state.pose.joints, state.next_pose.joints);
    std::swap(state.pose, state.next_pose);
    for (MeshState& mesh : state.meshes) {
        if (!mesh.mesh) {
            continue;
        }
        mesh.stale = mesh.stale || moved || mesh.morphs != mesh.next_morphs;
        std::swap(mesh.morphs, mesh.next_morphs);
        std::uint32_t level = 0;
        if (const deform::SubdivisionSurface* surface = surface_of(mesh)) {
            level = hints ? deform::level_for(*hints, extent_of(state, mesh), surface->finest(), mesh.level)
                          : surface->finest();
        }
        mesh.stale = mesh.stale || level != mesh.level;
        mesh.level = level;
    }
}

void Deformation::Impl::plan() {
    jobs.clear();
    refine_jobs.clear();
    redone.clear();
    for (EntityState* state : present) {
        if (!state->pose_problem.empty()) {
            continue;
        }
        const auto& joints = state->pose.joints;
        const auto mirrored =
            static_cast<std::size_t>(std::count_if(joints.begin(), joints.end(), deform::mirrors));
        for (MeshState& mesh : state->meshes) {
            if (!mesh.mesh || !mesh.stale) {
                continue;
            }
            mesh.stale = false;
            mesh.output = {};
            plan(*state, mesh,
                 mesh.mesh->pose.skin.empty() ? !joints.empty() && deform::mirrors(joints.back())
                                              : mirrored * 2 > joints.size());
        }
    }
}

void Deformation::Impl::plan(EntityState& entity, MeshState& mesh, bool mirrored) {
    const BindPose& pose = mesh.mesh->pose;
    const bool moved = moves(entity, mesh);
    if (!moved && mesh.level == 0) {
        return;
    }
    Redone& entry = redone.emplace_back(Redone{&entity, &mesh});
    const deform::RefinedSurface* refined = mesh.level > 0 ? &surface_of(mesh)->at(mesh.level) : nullptr;
    auto vertices = mesh.pool.take(refined ? refined->stencils.vertices.size() : pose.vertex_count);
    if (moved) {
        if (refined) {
            mesh.cage.resize(pose.vertex_count);
        }
        VertexFrame* const to = refined ? mesh.cage.data() : vertices->data();
        for (std::uint32_t block = 0; block < pose.block_count(); block += kJobBlocks, ++entry.jobs) {
            jobs.push_back({&entity, &mesh, to, block, std::min(block + kJobBlocks, pose.block_count()), {}});
        }
    }
    if (refined) {
        const auto count = static_cast<std::uint32_t>(vertices->size());
        for (std::uint32_t first = 0; first < count; first += kJobRefined, ++entry.refine_jobs) {
            refine_jobs.push_back({&refined->stencils,
                                   &mesh,
                                   vertices->data(),
                                   first,
                                   std::min(first + kJobRefined, count),
                                   mirrored,
                                   {}});
        }
        mesh.output.refined = mirrored ? refined->turned : refined->topology;
    } else if (mirrored) {
        mesh.output.refined = library.turned(mesh.index);
    }
    mesh.output.version = deform::next_serial();
    mesh.output.vertices = std::move(vertices);
}

void Deformation::Impl::refine() {
    ecs::detail::parallel_for(redone.size(), [&](std::size_t i) {
        if (redone[i].refine_jobs > 0) {
            gather_controls(*redone[i].entity, *redone[i].mesh);
        }
    });
    ecs::detail::parallel_for(refine_jobs.size(), [&](std::size_t i) { run(refine_jobs[i]); });
}

void Deformation::Impl::warn(const ecs::World& world, const EntityState& entity, const MeshState* mesh,
                             std::string_view problem) {
    std::string line = described(world, entity.entity) + ": ";
    if (mesh) {
        line += "mesh '" + mesh->mesh->name + "': ";
    }
    warnings.push_back(line.append(problem));
}

void Deformation::Impl::collect(const ecs::World& world) {
    std::size_t job = 0, refine_job = 0;
    for (const Redone& entry : redone) {
        bool finite = true;
        Aabb bounds;
        const auto add = [&](const deform::BoundsLanes& part) {
            bounds.add(part.box());
            finite = finite && part.finite();
        };
        for (std::uint32_t i = 0; i < entry.jobs; ++i) {
            add(jobs[job++].bounds);
        }
        if (entry.refine_jobs > 0) {
            bounds = {};
        }
        for (std::uint32_t i = 0; i < entry.refine_jobs; ++i) {
            add(refine_jobs[refine_job++].bounds);
        }
        entry.mesh->output.bounds = bounds;
        if (finite) {
            continue;
        }
        entry.mesh->output = {};
        warn(world, *entry.entity, entry.mesh, "its vertices are moved beyond all bounds; drawn as it is");
    }
    for (const EntityState* state : present) {
        if (!state->pose_problem.empty()) {
            warn(world, *state, nullptr, std::string(state->pose_problem) + "; keeps its last shape");
        }
        if (!state->weights_problem.empty()) {
            warn(world, *state, nullptr, state->weights_problem);
        }
        for (const MeshState& mesh : state->meshes) {
            const deform::SubdivisionSurface* surface = mesh.mesh ? mesh.mesh->surface.get() : nullptr;
            if (!surface) {
                continue;
            }
            if (!surface->problem().empty()) {
                warn(world, *state, &mesh, surface->problem() + "; not subdivided");
            }
            if (!surface->remark().empty()) {
                warn(world, *state, &mesh, surface->remark());
            }
        }
    }
    std::sort(warnings.begin(), warnings.end());
}

void Deformation::Impl::write(const Writes& writes, ecs::Commands& commands) {
    for (EntityState* state : present) {
        const DeformedMeshes* before = writes.try_get<DeformedMeshes>(state->entity);
        written.meshes.clear();
        for (const MeshState& mesh : state->meshes) {
            written.meshes.push_back(mesh.output);
        }
        const bool keeps = !state->pose_problem.empty() && before;
        written.skinned = keeps ? before->skinned : state->pose_problem.empty() && state->pose.skinned;
        written.skinned_at = keeps ? before->skinned_at : state->pose.at;
        if (!before) {
            commands.add(state->entity, written);
        } else if (!same(*before, written)) {
            *writes.try_get_mut<DeformedMeshes>(state->entity) = written;
        }
    }
    written.meshes.clear();
}

void Deformation::Impl::drop_unseen(const ecs::World& world, ecs::Commands& commands) {
    gone.clear();
    written_query.in(world).each([&](Entity e, const DeformedMeshes&) {
        const EntityState* state = e.index < states.size() ? states[e.index].get() : nullptr;
        if (!state || state->entity != e || state->seen != updates) {
            gone.push_back(e);
        }
    });
    for (const Entity e : gone) {
        commands.remove<DeformedMeshes>(e);
    }
    for (auto& state : states) {
        if (state && state->seen != updates) {
            state.reset();
        }
    }
}

Deformation::Deformation() : impl_(std::make_unique<Impl>()) {}
Deformation::Deformation(Deformation&&) noexcept = default;
Deformation& Deformation::operator=(Deformation&&) noexcept = default;
Deformation::~Deformation() = default;

const std::vector<std::string>& Deformation::warnings() const {
    return impl_->warnings;
}

void Deformation::update(ecs::World& world, const DetailHints* hints) {
    morph(world);
    skin(world, hints);
    subdivide();
    ecs::Commands commands(world);
    publish(world, Writes(world), commands);
    commands.apply();
}

void Deformation::morph(const ecs::World& world) {
    Impl& d = *impl_;
    if (world.id() != d.world_id) {
        *impl_ = Impl{};
        d.world_id = world.id();
    }
    ++d.updates;
    d.warnings.clear();
    if (const AssetStore* store = world.try_resource<AssetStore>()) {
        d.library.follow(store->assets());
    }
    d.find_entities(world);
    ecs::detail::parallel_for(d.present.size(), [&](std::size_t i) { d.take_morphs(*d.present[i]); });
}

void Deformation::skin(const ecs::World& world, const DetailHints* hints) {
    Impl& d = *impl_;
    ecs::detail::parallel_for(d.present.size(), [&](std::size_t i) { d.take(world, *d.present[i], hints); });
    d.plan();
    ecs::detail::parallel_for(d.jobs.size(), [&](std::size_t i) { run(d.jobs[i]); });
}

void Deformation::subdivide() {
    impl_->refine();
}

void Deformation::publish(const ecs::World& world, const Writes& writes, ecs::Commands& commands) {
    impl_->collect(world);
    impl_->write(writes, commands);
    impl_->drop_unseen(world, commands);
}

}  // namespace lanthorn
