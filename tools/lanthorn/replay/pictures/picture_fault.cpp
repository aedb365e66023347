#include "tools/lanthorn/replay/pictures/picture_fault.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "lanthorn/core/error.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/hierarchy.h"

namespace lanthorn::tools {

namespace {

constexpr float kBrighter = 1.01f;
constexpr double kHigher = 0.1;  // metres

ecs::Entity brightest_lamp(const ecs::World& world) {
    ecs::Entity brightest = ecs::kNullEntity;
    float most = 0;
    world.query<ecs::Read<LightComponent>>().each([&](ecs::Entity e, const LightComponent& c) {
        const vec3 flux = c.light.colour * c.light.intensity;
        if (flux.x + flux.y + flux.z > most) {
            most = flux.x + flux.y + flux.z;
            brightest = e;
        }
    });
    return brightest;
}

void halve(ImageF& image) {
    const ImageF before = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            for (int c = 0; c < image.channels; ++c) {
                image.at(x, y, c) = before.at(x & ~1, y & ~1, c);
            }
        }
    }
}

}  // namespace

PictureFault parse_picture_fault(std::string_view text) {
    const auto* const found = std::ranges::find(kPictureFaults, text);
    if (found == std::end(kPictureFaults)) {
        throw InputError(fmt::format("--picture-fault: found '{}', expected one of {}", text,
                                     fmt::join(kPictureFaults, ", ")));
    }
    return static_cast<PictureFault>(found - std::begin(kPictureFaults));
}

bool make_fault(PictureFault fault, App& app) {
    ecs::World& world = app.world();
    if (fault == PictureFault::indirect) {
        world.resource_mut<gi::GiSettings>().technique = gi::TechniqueKind::none;
        return true;
    }
    if (fault != PictureFault::lamp && fault != PictureFault::off && fault != PictureFault::moved) {
        return true;  // of the picture
    }
    const ecs::Entity lamp = brightest_lamp(world);
    if (lamp == ecs::kNullEntity) {
        return false;
    }
    if (fault == PictureFault::moved) {
        LocalTransform* const place = world.try_get_mut<LocalTransform>(lamp);
        if (place == nullptr) {
            return false;
        }
        place->value.translation.y += kHigher;
        return true;
    }
    world.get_mut<LightComponent>(lamp).light.intensity *= fault == PictureFault::off ? 0 : kBrighter;
    return true;
}

void make_fault(PictureFault fault, MarkPicture& picture) {
    switch (fault) {
        case PictureFault::nan:
            picture.radiance.pixels[picture.radiance.pixels.size() / 2] =
                std::numeric_limits<float>::quiet_NaN();
            break;
        case PictureFault::half:
            halve(picture.shown);
            halve(picture.radiance);
            break;
        case PictureFault::black:
            std::ranges::fill(picture.shown.pixels, 0.0f);
            std::ranges::fill(picture.radiance.pixels, 0.0f);
            break;
        default:
            break;
    }
}

}  // namespace lanthorn::tools
