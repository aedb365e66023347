// What `lanthorn measure costs` makes of its measurements.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>

#include "lanthorn/scene/asset_store.h"
#include "lanthorn/workbench/frame_meter.h"
#include "tools/lanthorn/measure/costs_report.h"
#include "tools/workbench/measure/light_costs.h"

namespace lanthorn::tools {
namespace costs_test {

const std::vector<RuleSwitch> kRules = {{"gi.plan.light", "light that holds"},
                                        {"render.shadow.kept", "shadow maps that hold"}};

// A frame of two passes and `outside` milliseconds beside them.
FrameCosts frames(double gather, double direct, double outside) {
    FrameCosts costs;
    costs.frames = 12;
    costs.passes = {{"gather", {gather, gather + 1, 2 * gather, true}},
                    {"direct", {direct, direct, direct, false}}};
    costs.whole = gather + direct + outside;
    costs.whole_mean = costs.whole + 1;
    costs.whole_clock = 2 * costs.whole;
    costs.outside = outside;
    costs.plan = {{"gather", 12, "4 rays a point", "the camera has moved"},
                  {"lit_maps", 3, "2 of 2", "they hold <still>"},
                  {"caustic_photons", 0, "", "no specular surface"}};
    return costs;
}

// The same without a rule: `more` milliseconds of gather, and lit maps in every frame.
FrameCosts without_light(double more) {
    FrameCosts costs = frames(10 + more, 4, 1);
    costs.plan[0].size = "8 rays a point";
    costs.plan[1].ran = 12;
    return costs;
}

MotionCosts measured() {
    return motion_costs({frames(10, 4, 1), frames(12, 4, 1), frames(11, 4, 1)},
                        {{without_light(5), without_light(9), without_light(6)},
                         {frames(11, 4, 1), frames(11, 4, 1), frames(11, 6, 1)}},
                        kRules);
}

SceneCosts scene() {
    SceneCosts costs;
    costs.name = "a & <b>";
    costs.motions = {measured()};
    MotionCosts lacking;
    lacking.planned.motion = Motion::lamp;
    lacking.planned.lacking = "no lamp has room to move";
    costs.motions.push_back(lacking);
    SceneMemory& memory = costs.motions.front().planned.memory;
    memory.meshes = {{"wall \x01\"1\"", "12 triangles", 3'000'000, 4'000'000}};
    memory.parts = {{"meshes", "vertices", 3'000'000}, {"the rest", "others", 1'500'000}};
    memory.gpu = 4'500'000;
    costs.light_motions = {Motion::rest};
    costs.lights = {{"ceiling", "lamp", 0.75, 120, {LightCost::Ms{1.5, 0.25, 2.5}}},
                    {"candle", "glowing surface", 0.25, 40, {std::nullopt}}};
    return costs;
}

const CostsHead kHead{{64, 48},        20, 12, 3, "emc", "low", {"gi.photons=1000"}, "llvmpipe", "0.1.0",
                      time_words(true)};

TEST(Costs, ARuleSavesWhatFramesWithoutItTakeMore) {
    const MotionCosts costs = measured();
    EXPECT_DOUBLE_EQ(costs.planned.whole, 16) << "the median of 15, 17 and 16";
    EXPECT_DOUBLE_EQ(costs.planned.passes.at("gather").ms, 11);
    EXPECT_DOUBLE_EQ(costs.noise, 2);
    ASSERT_EQ(costs.rules.size(), 2u);
    EXPECT_DOUBLE_EQ(costs.rules[0].ms, 5) << "the median of 20, 24 and 21, less 16";
    EXPECT_DOUBLE_EQ(costs.rules[0].clock, 10);
    EXPECT_EQ(costs.rules[0].lines, std::vector<std::string>{"lit_maps"});
    EXPECT_EQ(costs.rules[0].smaller, std::vector<std::string>{"gather"});
    EXPECT_DOUBLE_EQ(costs.rules[1].ms, 0);
    EXPECT_TRUE(costs.rules[1].lines.empty());
    EXPECT_TRUE(costs.rules[1].smaller.empty());
}

TEST(Costs, EveryLineThatSomeFrameLeavesOutIsNamedWithItsRules) {
    const MotionCosts costs = measured();
    ASSERT_EQ(costs.left_out.size(), 2u);
    EXPECT_EQ(costs.left_out[0].pass, "lit_maps");
    EXPECT_EQ(costs.left_out[0].ran, 3);
    EXPECT_EQ(costs.left_out[0].rules, std::vector<std::string>{"gi.plan.light"});
    EXPECT_EQ(costs.left_out[0].ms, 5);
    EXPECT_EQ(costs.left_out[1].pass, "caustic_photons");
    EXPECT_FALSE(costs.left_out[1].ms);
    EXPECT_EQ(costs.left_out[1].why, "no specular surface");
    EXPECT_TRUE(costs.left_out[1].rules.empty());
}

TEST(Costs, PassesAndTheRestAreTheWhole) {
    FrameCosts costs = frames(10, 4, 1);
    costs.whole = 15.5;  // medians do not add up
    double sum = costs.passes_ms();
    for (const RestLine& line : rest_lines(costs)) {
        sum += line.ms;
    }
    EXPECT_DOUBLE_EQ(sum, costs.whole);
    EXPECT_DOUBLE_EQ(rest_lines(costs).back().ms, 0.5);
    EXPECT_EQ(ordered_passes(costs).front().first, "gather");
}

TEST(Costs, TheJsonSumsUp) {
    const auto json = costs_json({scene()}, kHead);
    const auto& one = json.at("scenes").at(0);
    const auto& rest = one.at("motions").at(0);
    double passes = 0, parts = 0;
    for (const auto& pass : rest.at("passes")) {
        passes += pass.at("ms").get<double>();
    }
    EXPECT_DOUBLE_EQ(passes + rest.at("rest_ms").get<double>(), rest.at("whole").at("ms").get<double>());
    for (const auto& part : one.at("memory").at("parts")) {
        parts += part.at("gpu_mb").get<double>();
    }
    EXPECT_DOUBLE_EQ(parts, one.at("memory").at("gpu_mb").get<double>());
    EXPECT_EQ(one.at("motions").at(1).at("lacking"), "no lamp has room to move");
    EXPECT_EQ(one.at("lights").at(0).at("motions").at("rest").at("ms"), 1.5);
    EXPECT_TRUE(one.at("lights").at(1).at("motions").at("rest").is_null()) << "it was not muted";
    EXPECT_EQ(rest.at("left_out").at("rules").at(0).at("lines").at(0), "lit_maps");
}

TEST(Costs, TheTablesNameWhatIsInThem) {
    const std::string text = costs_text(scene(), kHead);
    for (const char* words : {"indirect: gather", "sum of the passes", "rest: outside of passes", "ceiling",
                              "75.0 %", "not muted", "mesh wall", "gi.plan.light", "no specular surface",
                              "no lamp has room to move", "no rule", "3 of 12"}) {
        EXPECT_NE(text.find(words), std::string::npos) << words << '\n' << text;
    }
}

// As XML: every tag is closed in its turn, attributes are quoted, & begins an entity, no control characters.
void expect_well_formed(std::string_view page) {
    std::vector<std::string> open;
    page.remove_prefix(page.find('>') + 1);  // the type of document
    bool in_style = false;
    for (std::size_t i = 0; i < page.size(); ++i) {
        const char c = page[i];
        ASSERT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 32) << i;
        if (c == '&') {
            const std::size_t end = page.find(';', i);
            ASSERT_LT(end - i, 7u) << page.substr(i, 20);
        }
        if (c != '<') {
            ASSERT_TRUE(in_style || c != '>' || open.empty() || page.substr(i - 1, 1) != " ") << i;
            continue;
        }
        const std::size_t end = page.find('>', i);
        ASSERT_NE(end, std::string_view::npos);
        std::string_view tag = page.substr(i + 1, end - i - 1);
        EXPECT_EQ(std::ranges::count(tag, '"') % 2, 0) << tag;
        const std::string name(tag.substr(tag.front() == '/' ? 1 : 0,
                                          tag.find_first_of(" /", 1) - (tag.front() == '/' ? 1 : 0)));
        if (tag.front() == '/') {
            ASSERT_FALSE(open.empty()) << tag;
            ASSERT_EQ(open.back(), name);
            open.pop_back();
        } else if (tag.back() != '/') {
            open.push_back(name);
        }
        in_style = !open.empty() && open.back() == "style";
        i = end;
    }
    EXPECT_TRUE(open.empty()) << open.back();
}

TEST(Costs, ThePageIsWellFormedWhateverThingsAreCalled) {
    const std::string page = costs_html({scene(), scene()}, kHead);
    expect_well_formed(page);
    EXPECT_NE(page.find("a &amp; &lt;b&gt;"), std::string::npos);
    EXPECT_NE(page.find("they hold &lt;still&gt;"), std::string::npos);
    EXPECT_EQ(page.find('\x01'), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos) << "it needs no network";
}

TEST(Costs, MeshesAndImagesByHand) {
    FrameScene frame;
    auto assets = std::make_shared<SceneAssets>();
    Mesh mesh;
    mesh.name = "quad";
    mesh.vertices.resize(4);
    mesh.indices = {0, 1, 2, 0, 2, 3};
    assets->meshes.push_back(mesh);
    for (const char* name : {"both", "colour", "unused"}) {
        assets->images.push_back({name, 4, 2, std::vector<std::uint8_t>(32)});
    }
    assets->textures.push_back({0, {}});
    assets->textures.push_back({1, {}});
    Material material;
    material.base_colour_texture.texture = 0;
    material.normal_texture.texture = 0;
    material.emissive_texture.texture = 1;
    assets->materials.push_back(material);
    frame.assets = assets;
    const std::vector<AssetBytes> meshes = mesh_bytes(frame), images = image_bytes(*assets);
    ASSERT_EQ(meshes.size(), 1u);
    EXPECT_EQ(meshes[0], (AssetBytes{"quad", "2 triangles", 4 * 72 + 6 * 4, 4 * sizeof(Vertex) + 6 * 4}));
    constexpr std::uint64_t kMipmaps = 4 * (8 + 2 + 1);  // 4x2, 2x1, 1x1
    ASSERT_EQ(images.size(), 3u);
    EXPECT_EQ(images[0], (AssetBytes{"both", "4x2, as colour and as data", 2 * kMipmaps, 32}));
    EXPECT_EQ(images[1], (AssetBytes{"colour", "4x2", kMipmaps, 32}));
    EXPECT_EQ(images[2], (AssetBytes{"unused", "4x2, unused", 0, 32}));
}

TEST(LightCosts, EachLightIsOutInItsTurnAndAllShineAgain) {
    ecs::World world;
    const auto lamp = [&](const char* name) {
        const ecs::Entity e = world.create();
        world.insert(e, LightComponent{{}});
        world.insert(e, Name{name});
        return e;
    };
    const ecs::Entity first = lamp("first"), second = lamp("second");
    AssetStore& store = asset_store(world);
    Material glow;
    glow.name = "glow";
    glow.emissive = vec3(5);
    const MaterialHandle material = store.add(glow);
    Mesh mesh;
    mesh.vertices.resize(3);
    mesh.indices = {0, 1, 2};
    mesh.material = material.slot;
    const MeshHandle triangle = store.add(mesh);
    for (int i = 0; i < 2; ++i) {
        world.insert(world.create(), MeshInstances{{triangle}});
    }
    auto image = std::make_shared<SkyImage>();
    image->width = image->height = 1;
    image->radiance = {vec3(1)};
    world.insert_resource(Backdrop{{.image = image, .light = nullptr}});

    std::vector<std::string> seen;  // a letter a light, by frame
    LightCosts costs(world, all_lamps(world), [&] {
        std::string lit;
        lit += world.try_get<LightComponent>(first) != nullptr ? "1" : "-";
        lit += world.try_get<LightComponent>(second) != nullptr ? "2" : "-";
        lit += store.get(material).emits() ? "g" : "-";
        lit += world.resource<Backdrop>().sky.image ? "s" : "-";
        seen.push_back(lit);
    });
    const int all = LightCosts::all_frames(4, {});
    while (costs.step()) {
    }
    EXPECT_EQ(costs.frames(), all);
    ASSERT_EQ(static_cast<int>(seen.size()), all);
    std::vector<std::string> rounds;
    for (const std::string& lit : seen) {
        if (rounds.empty() || rounds.back() != lit) {
            rounds.push_back(lit);
        }
    }
    EXPECT_EQ(rounds, (std::vector<std::string>{"12gs", "-2gs", "12gs", "1-gs", "12gs", "12-s", "12gs",
                                                "12g-", "12gs"}));
    ASSERT_EQ(costs.costs().size(), 4u);
    EXPECT_EQ(costs.costs()[0].lamp.name, "first");
    EXPECT_EQ(costs.costs()[2].lamp.name, "glow");
    EXPECT_EQ(costs.costs()[2].lamp.entities.size(), 2u) << "one lamp, as both show one material";
    EXPECT_EQ(costs.costs()[3].lamp.kind, reference::LightKind::sky);
    EXPECT_FALSE(costs.step());
    EXPECT_EQ(costs.frames(), all);
}

// A frame spins for 8 ms of processor time more with the lamp than without it.
TEST(LightCosts, SaysHowSureItIs) {
    ecs::World world;
    const ecs::Entity lamp = world.create();
    world.insert(lamp, LightComponent{{}});
    LightCosts costs(world, punctual_lamps(world),
                     [&] {
                         const double until =
                             workbench::processor_ms() + (world.has<LightComponent>(lamp) ? 10 : 2);
                         while (workbench::processor_ms() < until) {
                         }
                     },
                     {1, 5});
    while (costs.step()) {
    }
    ASSERT_EQ(costs.costs().size(), 1u);
    const LightCosts::Cost& cost = costs.costs().front();
    EXPECT_GT(cost.cpu_noise, 0);
    EXPECT_NEAR(cost.cpu_ms, 8, 4 * cost.cpu_noise + 0.1);
    EXPECT_LT(cost.cpu_noise, 4);
}

TEST(LightCosts, WithoutALightThereIsNothingToMeasure) {
    ecs::World world;
    LightCosts costs(world, all_lamps(world), [] { FAIL() << "no frame is drawn"; });
    EXPECT_FALSE(costs.step());
    EXPECT_EQ(LightCosts::all_frames(0, {}), 0);
}

}  // namespace costs_test
}  // namespace lanthorn::tools
