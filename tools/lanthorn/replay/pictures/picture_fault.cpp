#include "tools/lanthorn/replay/pictures/picture_fault.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "lanthorn/core/error.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::tools {

namespace {

constexpr float kBrighter = 1.01f, kTenth = 1.1f;
constexpr double kHigher = 0.1;  // metres

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

void of_picture(PictureFault fault, MarkPicture& picture) {
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

MarkPicture without_shadow(const MarkArtist& artist, const MarkedMoment& at, const MarkView& view,
                           ecs::Entity mover) {
    MarkPicture picture = artist.draw(at, view);
    const MarkPicture other = artist.draw(at, view, [&](App& app) {
        hide(app.world(), mover);
        auto& settings = app.world().resource_mut<render::RenderSettings>();
        settings.exposure_mode = render::ExposureMode::manual;
        settings.exposure_compensation = 0;
        settings.exposure_ev100 =
            static_cast<float>(render::ev100_of_exposure(static_cast<double>(picture.exposure)));
    });
    const ImageF depth = picture.depth;
    for (int y = 0; y < depth.height; ++y) {
        for (int x = 0; x < depth.width; ++x) {
            for (int c = 0; c < 3 && !sees_other(depth, other.depth, x, y); ++c) {
                picture.shown.at(x, y, c) = other.shown.at(x, y, c);
                picture.radiance.at(x, y, c) = other.radiance.at(x, y, c);
            }
        }
    }
    return picture;
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

std::string fault_words(PictureFault fault, const FaultTargets& targets) {
    const auto of = [](const std::string& name, const char* what) {
        return name.empty() ? "" : name + " " + what;
    };
    switch (fault) {
        case PictureFault::lamp:
            return of(targets.lamp_name, "is 1 % brighter");
        case PictureFault::off:
            return of(targets.lamp_name, "is off");
        case PictureFault::moved:
            return of(targets.lamp_name, "is 10 cm higher");
        case PictureFault::shadow:
            return of(targets.mover_name, "casts no shadow");
        case PictureFault::indirect:
            return "no indirect light";
        case PictureFault::nan:
            return "one pixel is no number";
        case PictureFault::half:
            return "half the resolution";
        case PictureFault::black:
            return "nothing is drawn";
        case PictureFault::tenth:
            break;
    }
    return of(targets.lamp_name, "and all other lamps are 10 % brighter");
}

void make_fault(PictureFault fault, const FaultTargets& targets, App& app) {
    ecs::World& world = app.world();
    const auto lamp = [&]() -> Light& { return world.get_mut<LightComponent>(targets.lamp).light; };
    if (fault == PictureFault::indirect) {
        world.resource_mut<gi::GiSettings>().technique = gi::TechniqueKind::none;
    } else if (fault == PictureFault::tenth) {
        world.query<ecs::Write<LightComponent>>().each(
            [](LightComponent& one) { one.light.intensity *= kTenth; });
    } else if (targets.lamp == ecs::kNullEntity) {
        return;
    } else if (fault == PictureFault::moved) {
        world.get_mut<LocalTransform>(targets.lamp).value.translation.y += kHigher;
    } else if (fault == PictureFault::lamp) {
        lamp().intensity *= kBrighter;
    } else if (fault == PictureFault::off) {
        lamp().intensity = 0;
    }
}

MarkPicture draw_with_fault(const MarkArtist& artist, const MarkedMoment& at, const MarkView& view,
                            PictureFault fault, const FaultTargets& targets) {
    if (fault == PictureFault::shadow && targets.mover != ecs::kNullEntity) {
        return without_shadow(artist, at, view, targets.mover);
    }
    MarkPicture picture = artist.draw(at, view, [&](App& app) { make_fault(fault, targets, app); });
    of_picture(fault, picture);
    return picture;
}

}  // namespace lanthorn::tools
