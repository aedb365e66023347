#include "tests/gpu/gi/settings_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/core/settings.h"

namespace lanthorn::gi::test {

namespace {

constexpr ivec2 kSize(64);

// Half of a number, twice the least one, the next of choices.
std::string another_value(const SettingInfo& info, const std::string& text) {
    if (info.type == SettingType::boolean) {
        return text == "true" ? "false" : "true";
    }
    if (info.type == SettingType::choice) {
        const auto at = std::ranges::find(info.choices, text) - info.choices.begin();
        return info.choices[(static_cast<std::size_t>(at) + 1) % info.choices.size()];
    }
    const double value = std::stod(text);
    const double half = info.type == SettingType::integer ? std::floor(value / 2) : value / 2;
    const double other = half >= info.lower && half != value ? half : 2 * value + 1;
    return info.value_text(std::clamp(other, info.lower, info.upper));
}

std::vector<float> still_picture(Bench& bench, FrameScene& scene, const Settings& settings, int frames) {
    bench.settings = gi_settings(settings);
    ImageF image;
    for (int i = 0; i < frames; ++i) {
        image = bench.frame(scene, kSize);
        hold_still(scene);
    }
    return image.pixels;
}

std::vector<float> fresh_picture(FrameScene scene, const Settings& settings, int frames) {
    Bench fresh(gi_settings(settings).technique);
    return still_picture(fresh, scene, settings, frames);
}

}  // namespace

std::vector<std::string> walk_settings(const FrameScene& scene, const std::vector<std::string>& base,
                                       int frames, const std::vector<std::string>& by_history) {
    SettingsSchema schema;
    declare_gi_settings(schema);
    Settings settings(schema);
    for (const std::string& assignment : base) {
        settings.set_from_text(assignment);
    }
    Bench kept(gi_settings(settings).technique);
    FrameScene still = scene;
    const std::vector<float> first = still_picture(kept, still, settings, frames);
    std::vector<std::string> altered;
    for (const SettingInfo& info : schema.all()) {
        if (info.for_measuring) {
            continue;  // work that is done beyond what is needed exchanges maps and shoots
                       // other photons, which stay
        }
        const std::string before = settings.text(info.name);
        const std::string other = another_value(info, before);
        settings.set_from_text(info.name, other);
        const std::vector<float> changed = still_picture(kept, still, settings, frames);
        const bool depends = std::ranges::find(by_history, info.name) != by_history.end();
        EXPECT_EQ(depends || changed == fresh_picture(scene, settings, frames), true)
            << info.name << ": " << before << " -> " << other << " leaves what belongs to " << before;
        if (changed != first) {
            altered.push_back(info.name);
        }
        settings.set_from_text(info.name, before);
        EXPECT_EQ(still_picture(kept, still, settings, frames) == first, true)
            << info.name << ": " << other << " -> " << before << " leaves what belongs to " << other;
    }
    return altered;
}

}  // namespace lanthorn::gi::test
