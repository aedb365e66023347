#include "gi_module/techniques/emc/caustics/caustic_maps.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

static_assert(sizeof(CausticPhoton) == 64);

float surface_of(const Aabb& box) {
    const vec3 s = box.upper - box.lower;
    return s.x * s.y + s.y * s.z + s.z * s.x;
}

}  // namespace

void CausticMaps::follow(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                         const CausticTargets& targets) {
    if (!program_) {
        program_ =
            gpu::Program({"gi_module/techniques/emc/caustics/caustic_maps.comp"},
                         {"MAX_MAPS " + std::to_string(static_cast<std::size_t>(kMaxMaps) + kMostCasters)});
        renderer_.emplace(MapUse::caster);
        bad_values_ = gpu::Buffer::from(std::vector<std::uint32_t>{0});
    }
    const FrameScene& scene = inputs.scene;
    targets_.clear();
    std::vector<std::size_t> glass;  // targets that light goes through
    for (const CausticTarget& target : targets.targets) {
        targets_.push_back({vec4(target.bounds.lower, -1), vec4(target.bounds.upper, 0)});
    }
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const std::uint32_t of = targets.of_instance[i];
        if (of != CausticTargets::kNone && scene.material(scene.instances[i]).transmission > 0 &&
            std::ranges::find(glass, of) == glass.end()) {
            glass.push_back(of);
        }
    }
    std::ranges::stable_sort(glass, [&](std::size_t a, std::size_t b) {
        return surface_of(targets.targets[a].bounds) > surface_of(targets.targets[b].bounds);
    });
    glass.resize(std::min(glass.size(), kMostCasters));

    const int environment = maps.slots();
    const int slots = environment + static_cast<int>(glass.size());
    const CubeMaps& drawn = maps.drawn();
    if (all_.slots() != slots || all_.resolution() != drawn.resolution()) {
        all_ = CubeMaps(slots, drawn.resolution(), MapUse::caster);
    }
    centres_.clear();
    for (const vec3& centre : maps.centres()) {
        centres_.emplace_back(centre, 0);
    }
    for (int layer = 0; layer < 6 * environment; ++layer) {
        all_.copy(layer, drawn);
    }
    LayerList list;
    for (std::size_t g = 0; g < glass.size(); ++g) {
        const int slot = environment + static_cast<int>(g);
        const vec3 centre = targets.targets[glass[g]].bounds.centre();
        targets_[glass[g]].lower.w = static_cast<float>(slot);
        centres_.emplace_back(centre, 0);
        for (int face = 0; face < 6; ++face) {
            all_.clear(6 * slot + face);
        }
        for (const std::uint32_t i : inputs.gpu_scene.instances(render::DrawSet::all)) {
            for (int face = 0; face < 6 && targets.of_instance[i] == glass[g]; ++face) {
                list.add(i, 0, centre, 6 * slot + face);
            }
        }
    }
    renderer_->draw(all_, inputs.gpu_scene, list, scene.diagonal());
    targets_buffer_ = gpu::Buffer::from(targets_);
}

std::vector<PhotonHit> CausticMaps::trace(const render::LightInputs& inputs, const EnvironmentMaps& maps,
                                          const GiSettings& settings,
                                          std::span<const CausticPhoton> photons) {
    if (photons.empty()) {
        return {};
    }
    const gpu::Buffer flown = gpu::Buffer::from(std::vector<CausticPhoton>(photons.begin(), photons.end()));
    const gpu::Buffer landed(photons.size() * sizeof(PhotonHit));
    inputs.gpu_scene.bind_materials();
    program_.use();
    maps.bind(program_, 0, 1, settings, inputs.scene);
    program_.set("map_centres", std::span<const vec4>(centres_));
    all_.planes().bind(0);
    all_.albedo().bind(1);
    program_.set("photon_count", static_cast<int>(photons.size()));
    program_.set("target_count", static_cast<int>(targets_.size()));
    program_.set("seed", settings.seed);
    flown.bind_storage(0);
    landed.bind_storage(1);
    targets_buffer_.bind_storage(2);
    bad_values_.bind_storage(5);
    program_.dispatch(static_cast<int>(photons.size()), 64);
    wait_for_shaders();
    std::vector<PhotonHit> hits = landed.read<PhotonHit>(photons.size());
    std::erase_if(hits, [](const PhotonHit& hit) { return hit.radius == 0; });
    return hits;
}

std::uint64_t CausticMaps::take_bad_values() {
    const std::uint32_t count = bad_values_.read<std::uint32_t>(1).front();
    bad_values_.clear();
    return count;
}

}  // namespace lanthorn::gi
