#include "tools/lanthorn/replay/pictures/fault_targets.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lanthorn/core/colour.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/hierarchy.h"

namespace lanthorn::tools {

namespace {

constexpr ivec2 kTargetsSize{96, 54};
// Of all light in the picture: less is not there.
constexpr double kLeast = 1e-3;

struct Seen {
    ImageF radiance, depth;
};

// Direct light at a mark, drawn again after every change of its world.
class DirectLight {
  public:
    DirectLight(const MarkArtist& artist, const MarkedMoment& at, MarkView view) : artist_(artist), at_(at) {
        view.size = kTargetsSize;
        level_ = artist.open(at, view, &moved_);
        level_->app().world().resource_mut<gi::GiSettings>().technique = gi::TechniqueKind::none;
    }
    ecs::World& world() { return level_->app().world(); }
    const std::vector<ecs::Entity>& moved() const { return moved_; }
    Seen draw() {
        artist_.show(level_->app(), at_, 1);
        const render::FrameRenderer& frame = *world().resource<Renderer>().frame;
        return {frame.read(render::Aov::radiance), frame.read(render::Aov::depth)};
    }

  private:
    const MarkArtist& artist_;
    const MarkedMoment& at_;
    std::vector<ecs::Entity> moved_;
    std::unique_ptr<ReplayedLevel> level_;
};

float luminance_at(const ImageF& image, int x, int y) {
    return luminance(vec3(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)));
}

// The light that differs where the same is seen, over all light.
double difference(const Seen& whole, const Seen& other) {
    double sum = 0, all = 0;
    for (int y = 0; y < kTargetsSize.y; ++y) {
        for (int x = 0; x < kTargetsSize.x; ++x) {
            const float before = luminance_at(whole.radiance, x, y);
            all += before;
            if (!sees_other(whole.depth, other.depth, x, y)) {
                sum += std::abs(luminance_at(other.radiance, x, y) - before);
            }
        }
    }
    return all > 0 ? sum / all : 0;
}

std::string name_of(const ecs::World& world, ecs::Entity e) {
    const Name* name = world.try_get<Name>(e);
    return name != nullptr && !name->value.empty() ? name->value : to_string(e);
}

// The one that makes the largest difference; null: none makes any.
class Largest {
  public:
    void add(ecs::Entity e, double difference) {
        if (difference > most_) {
            most_ = difference;
            entity_ = e;
        }
    }
    ecs::Entity entity() const { return entity_; }

  private:
    double most_ = kLeast;
    ecs::Entity entity_ = ecs::kNullEntity;
};

}  // namespace

bool sees_other(const ImageF& a, const ImageF& b, int x, int y) {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, a.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, a.width - 1); ++u) {
            if (a.at(u, v, 0) != b.at(u, v, 0)) {
                return true;
            }
        }
    }
    return false;
}

Hidden hide(ecs::World& world, ecs::Entity root) {
    Hidden hidden;
    std::vector<ecs::Entity> all = descendants(world, root);
    all.push_back(root);
    for (const ecs::Entity e : all) {
        if (const MeshInstances* meshes = world.try_get<MeshInstances>(e)) {
            hidden.emplace_back(e, *meshes);
            world.remove<MeshInstances>(e);
        }
    }
    return hidden;
}

FaultTargets fault_targets(const MarkArtist& artist, const MarkedMoment& at, const MarkView& view) {
    DirectLight light(artist, at, view);
    ecs::World& world = light.world();
    const Seen whole = light.draw();
    std::vector<ecs::Entity> lamps;
    std::as_const(world).query<ecs::Read<LightComponent>>().each([&](ecs::Entity e, const LightComponent& c) {
        if (c.light.intensity > 0) {
            lamps.push_back(e);
        }
    });
    Largest lamp, mover;
    for (const ecs::Entity e : lamps) {
        const float before = world.get<LightComponent>(e).light.intensity;
        world.get_mut<LightComponent>(e).light.intensity = 0;
        lamp.add(e, difference(whole, light.draw()));
        world.get_mut<LightComponent>(e).light.intensity = before;
    }
    for (const ecs::Entity e : light.moved()) {
        const Hidden hidden = hide(world, e);
        mover.add(e, difference(whole, light.draw()));
        for (const auto& [one, meshes] : hidden) {
            world.insert(one, MeshInstances(meshes));
        }
    }
    FaultTargets targets{lamp.entity(), mover.entity(), "", ""};
    if (targets.lamp != ecs::kNullEntity) {
        targets.lamp_name = name_of(world, targets.lamp);
    }
    if (targets.mover != ecs::kNullEntity) {
        targets.mover_name = name_of(world, targets.mover);
    }
    return targets;
}

}  // namespace lanthorn::tools
