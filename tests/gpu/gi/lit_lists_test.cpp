// What is listed, counted and linked of the lit texels follows what shows something else: after any change
// the lists hold what lists made from nothing do, and photons bring, bit for bit, the same irradiance.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gi_module/techniques/emc/emc_technique.h"
#include "gi_module/techniques/emc/lit_maps/lit_photons.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gather_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(16);
constexpr std::uint32_t kBlock = 1;
constexpr int kLooks = 70;                          // more than lists are kept for: LitLists::kWhole
constexpr std::uint32_t kUnlitPoint = 0x3f808000u;  // lit_points.glsl

struct Moment {
    FrameScene scene;
    GiSettings settings;
    Instance gone{};  // the block, while it is no more
};

struct Step {
    std::string what;
    std::function<void(Moment&, int)> change;  // of the n-th of its frames
    int frames = 1;
};

void nothing(Moment&, int) {}

void put_block(Moment& m, const vec3& at) {
    move_instance(m.scene, kBlock, glm::translate(mat4(1), at));
}

void slide(Moment& m, int n) {
    put_block(m, vec3(-0.5f + 0.04f * static_cast<float>(n), 0, 0));
}

void turn(Moment& m, int n) {
    move_instance(m.scene, kBlock, glm::rotate(mat4(1), 0.1f * static_cast<float>(n), vec3(0, 1, 0)));
}

void change_lamps(Moment& m, int) {
    for (LightInstance& light : m.scene.lights) {
        light.light.intensity *= 1.5f;
        light.position.y -= 0.05f;
    }
    m.scene.changes.lights = true;
}

void remove_block(Moment& m, int) {
    m.gone = m.scene.instances[kBlock];
    m.scene.instances.erase(m.scene.instances.begin() + kBlock);
    m.scene.changes.geometry = true;
    m.scene.changes.dirty.add(m.gone.bounds);
}

void bring_back(Moment& m, int) {
    m.scene.instances.insert(m.scene.instances.begin() + kBlock, m.gone);
    m.scene.changes.arrived = {kBlock};
    put_block(m, vec3(0.4f, 0, -0.3f));
}

void go_to_and_fro(Moment& m, int n) {
    const float way = 0.03f * static_cast<float>(n % 40 < 20 ? n % 20 : 20 - n % 20);
    put_block(m, vec3(way, 0, 0.5f * way));
}

std::vector<Step> steps() {
    return {
        {"nothing moves", nothing, 2},
        {"a block slides", slide, 6},
        {"it stands", nothing, 2},
        {"it leaps", [](Moment& m, int) { put_block(m, vec3(1, 0, 0.4f)); }},
        {"it turns", turn, 3},
        {"it goes far away", [](Moment& m, int) { put_block(m, vec3(50, 0, 0)); }},
        {"it comes back", [](Moment& m, int) { put_block(m, vec3(0)); }},
        {"it is no more", remove_block},
        {"nothing is left to move", nothing},
        {"it appears", bring_back},
        {"all lamps change", change_lamps},
        {"all lamps change while it slides",
         [](Moment& m, int n) {
             change_lamps(m, n);
             slide(m, n);
         },
         2},
        {"the scene grows while it slides",
         [](Moment& m, int n) {
             m.scene.bounds.add(vec3(0, -0.1f * static_cast<float>(n + 1), 0));
             slide(m, n);
         },
         3},
        {"fewer texels, while it slides",
         [](Moment& m, int n) {
             m.settings.edit<EmcSettings>().gather_texels = 16;
             slide(m, n);
         },
         3},
        {"more again",
         [](Moment& m, int n) {
             m.settings.edit<EmcSettings>().gather_texels = 32;
             slide(m, n);
         }},
        {"it goes to and fro", go_to_and_fro, kLooks},
        {"everything stands", nothing, 2},
    };
}

Moment with_three_maps(int candidates) {
    Moment moment;
    moment.scene = room_with_block();
    auto& emc = moment.settings.edit<EmcSettings>();
    emc.final_stage = EmcFinal::gather;
    emc.rays = EmcRays::maps;
    emc.count = 3;
    emc.candidates = candidates;
    emc.resolution = 64;
    emc.gather_texels = 32;
    emc.gather_photons = 400;
    return moment;
}

struct Followed {
    LitLists lists;
    LitPhotons photons;

    void follow(const EnvironmentMaps& maps, const LitTexels& texels, const render::LightInputs& inputs,
                const GiSettings& settings, bool all) {
        lists.follow(texels, maps, settings, inputs.scene, all, 2);
        const LitPhotons::Texels at{maps, texels, lists};
        photons.look(at, settings, inputs.scene, all);
        photons.trace(at, inputs, settings, 2, true, true, true, nullptr);
    }
};

struct Shown {
    const EnvironmentMaps& maps;
    render::LightInputs inputs;
};

// A frame of it; what `movers` sweep is of that frame.
Shown show(Bench& bench, const Moment& now, SweptBoxes& movers) {
    bench.settings = now.settings;
    bench.show(now.scene, kSize);
    const EnvironmentMaps& maps = dynamic_cast<const EmcTechnique&>(bench.technique()).maps();
    const Renderer& renderer = bench.app.world().resource<Renderer>();
    const render::LightInputs inputs = renderer.frame->light_inputs(now.scene, *renderer.timer);
    inputs.gpu_scene.bind_materials();
    movers.follow(now.scene, maps.extent(now.scene));
    return {maps, inputs};
}

// Places on the list that are lit, in order.
std::vector<std::uint32_t> lit_places(const LitLists& lists, const std::vector<vec4>& points) {
    std::vector<std::uint32_t> places = lists.lit().read();
    std::erase_if(places,
                  [&](std::uint32_t p) { return std::bit_cast<std::uint32_t>(points[p].w) == kUnlitPoint; });
    std::ranges::sort(places);
    return places;
}

// By place of a coarse texel: its point, and what photons bring there.
std::vector<vec4> by_place(const Followed& followed, int faces) {
    const auto places =
        static_cast<std::size_t>(faces * followed.lists.resolution() * followed.lists.resolution());
    const auto index = followed.lists.index().read<std::uint32_t>(places);
    const auto points = followed.lists.coarse().points().read<vec4>(places);
    const auto irradiance = followed.photons.irradiance().read<vec4>(places);
    std::vector<vec4> result;
    for (const std::uint32_t number : index) {
        result.push_back(number > 0 ? points[number - 1] : vec4(0));
        result.push_back(number > 0 ? irradiance[number - 1] : vec4(0));
    }
    return result;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(LitLists, WhatFollowsIsWhatIsMadeFromNothing) {
    Moment now = with_three_maps(6);
    now.settings.edit<EmcSettings>().update_interval = 1000;  // no map is exchanged
    Bench bench;
    LitTexels texels;
    SweptBoxes movers;
    gpu::Buffer radiosity, first;
    Followed some, every;
    std::uint64_t version = 0;
    int frame = 0, in_a_row = 0, most_in_a_row = 0;  // looks of some texels alone
    for (const Step& step : steps()) {
        for (int n = 0; n < step.frames; ++n, ++frame) {
            SCOPED_TRACE(step.what + ", frame " + std::to_string(n));
            if (frame > 0) {
                hold_still(now.scene);
            }
            step.change(now, n);
            const auto [maps, inputs] = show(bench, now, movers);
            const bool other = texels.resize(maps, now.settings);
            const bool all = std::exchange(version, maps.version()) != maps.version() || other;
            if (other) {
                radiosity = gpu::Buffer(static_cast<std::size_t>(texels.shaded_places()) * sizeof(vec4));
                first = gpu::Buffer(radiosity.bytes());
            }
            texels.look(maps, now.settings, now.scene, movers, all, ivec2(-1), radiosity, first);
            some.follow(maps, texels, inputs, now.settings, all);
            every.follow(maps, texels, inputs, now.settings, true);
            in_a_row = all ? 0 : in_a_row + 1;
            most_in_a_row = std::max(most_in_a_row, in_a_row);
            const auto points = texels.points().read<vec4>(static_cast<std::size_t>(texels.places()));
            const std::vector<std::uint32_t> lit = lit_places(every.lists, points);
            ASSERT_GT(lit.size(), 500u);
            ASSERT_EQ(lit_places(some.lists, points) == lit, true);
            ASSERT_EQ(every.lists.lit().count(), lit.size());
            ASSERT_EQ(every.lists.lit_count(), lit.size());
            ASSERT_EQ(some.lists.lit_count(), lit.size());
            ASSERT_EQ(same_bits(by_place(some, texels.faces()), by_place(every, texels.faces())), true);
            const auto fits = some.lists.fits().read<std::uint32_t>(points.size());
            const auto expected = every.lists.fits().read<std::uint32_t>(points.size());
            ASSERT_EQ(std::ranges::all_of(lit, [&](std::uint32_t p) { return fits[p] == expected[p]; }),
                      true);
        }
    }
    EXPECT_GE(most_in_a_row, kLooks);
}

// What texels find that look where things have moved and, after an exchange, at what the two maps show.
TEST(LitLists, AnExchangeOfOneMapIsLookedAtWhereItIsSeen) {
    Moment now = with_three_maps(12);
    Bench bench;
    struct Looked {
        LitTexels texels;
        gpu::Buffer radiosity, first;
        Followed followed;
    };
    Looked some, every;
    SweptBoxes movers;
    std::uint64_t version = 0;
    int exchanges = 0, looked_at = 0;
    for (int n = 0; n < 80; ++n) {
        SCOPED_TRACE(n);
        if (n > 0) {
            hold_still(now.scene);
        }
        const float turn = 0.16f * static_cast<float>(n);
        put_block(now, vec3(std::sin(turn), 0, 0.6f * std::cos(turn)));
        const auto [maps, inputs] = show(bench, now, movers);
        const std::uint64_t before = std::exchange(version, maps.version());
        const std::optional<ivec2> exchanged = maps.exchanged_since(before);
        exchanges += exchanged.has_value() ? 1 : 0;
        for (Looked* looked : {&some, &every}) {
            if (looked->texels.resize(maps, now.settings)) {
                const auto places = static_cast<std::size_t>(looked->texels.shaded_places());
                looked->radiosity = gpu::Buffer(places * sizeof(vec4));
                looked->first = gpu::Buffer(looked->radiosity.bytes());
            }
            const bool all = looked == &every || n == 0 || (before != version && !exchanged);
            looked->texels.look(maps, now.settings, now.scene, movers, all, exchanged.value_or(ivec2(-1)),
                                looked->radiosity, looked->first);
            looked->followed.follow(maps, looked->texels, inputs, now.settings, all);
        }
        if (exchanged) {
            looked_at = std::max(looked_at, static_cast<int>(some.texels.looked_at().count()));
            EXPECT_LT(some.texels.looked_at().count(), every.texels.looked_at().count());
        }
        const auto places = static_cast<std::size_t>(some.texels.places());
        const auto found = some.texels.points().read<vec4>(places);
        const auto expected = every.texels.points().read<vec4>(places);
        const auto is_lit = [](const vec4& point) {
            return std::bit_cast<std::uint32_t>(point.w) != kUnlitPoint;
        };
        int others = 0;
        for (std::size_t i = 0; i < places; ++i) {
            others += is_lit(found[i]) != is_lit(expected[i]) ||
                              (is_lit(found[i]) && std::memcmp(&found[i], &expected[i], sizeof(vec4)) != 0)
                          ? 1
                          : 0;
        }
        ASSERT_EQ(others, 0);
        // Areas of photons hang on maps that show a texel about as sharply, which only a whole look asks.
        const std::vector<vec4> light = by_place(some.followed, some.texels.faces());
        const std::vector<vec4> whole = by_place(every.followed, every.texels.faces());
        double apart = 0, sum = 0;
        for (std::size_t i = 1; i < light.size(); i += 2) {
            apart += std::abs(static_cast<double>(light[i].g) - static_cast<double>(whole[i].g));
            sum += static_cast<double>(whole[i].g);
        }
        EXPECT_LT(apart, 0.01 * sum);
    }
    EXPECT_GE(exchanges, 2);
    EXPECT_GT(looked_at, 0);
}

}  // namespace
}  // namespace lanthorn::gi::test
