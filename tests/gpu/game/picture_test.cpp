// The game's picture: the same as that of `lanthorn render`, of the settings asked for, with figures that
// walk.
#include <gtest/gtest.h>

#include <numeric>

#include "game/presentation/playthrough.h"
#include "game/presentation/quality.h"
#include "game/presentation/tour.h"
#include "game/rules/components.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/light_sensor.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/repository.h"
#include "tools/scene_generator/puppet_figure.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::game {
namespace {

constexpr ivec2 kSize(96, 64);

gpu::Context& context() {
    static const std::unique_ptr<gpu::Context> the_context = gpu::create_headless_context();
    return *the_context;
}

Options options_with(std::vector<std::string> set) {
    Options options;
    options.threads = 2;
    options.set = std::move(set);
    return options;
}

void add_pictures(App& app, const Options& options, ivec2 size = kSize) {
    Quality(options, options.seed).draw(app);
    app.view().size = size;
}

std::vector<float> picture(const App& app, render::Aov aov = render::Aov::final) {
    return app.world().resource<Renderer>().frame->read(aov).pixels;
}

double mean(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// The lantern room with a figure that walks in a circle in its lit half.
SceneData room_with_puppet() {
    scene_generator::Builder b;
    b.scene = scene_generator::lantern_room();
    b.scene.source = "room-with-puppet.glb";
    AnimationClip walk;
    walk.name = "walk";
    scene_generator::PuppetWalk round;
    round.centre = {-1.6, 0, -0.6};
    round.radius = 0.6;
    scene_generator::add_puppet(b, "puppet", scene_generator::add_puppet_meshes(b), round, walk);
    b.scene.animations.push_back(std::move(walk));
    return b.scene;
}

TEST(Picture, HasTheSameBitsInTheGameAndInLanthornRender) {
    context();
    const SceneData scene = room_with_puppet();
    const Options options = options_with({});
    Playthrough playthrough(options, scene);
    session::Session& session = playthrough.session();
    add_pictures(session.app(), options);
    ShownScene shown(scene, {.camera = "player-eyes"});
    add_pictures(shown.app(), options);
    for (const double moment : {0.0, 0.25, 0.51}) {
        session.app().show_at(moment);
        shown.show_at(moment);
        for (const render::Aov aov : {render::Aov::final, render::Aov::indirect}) {
            EXPECT_EQ(picture(session.app(), aov), picture(shown.app(), aov)) << moment;
        }
    }
    EXPECT_GT(mean(picture(session.app())), 0.05);
}

TEST(Picture, IsDrawnWithItsSettings) {
    context();
    const SceneData scene = import_gltf(support::repository_file("assets/lantern-room.glb"));
    std::vector<double> brightness;
    for (const char* compensation : {"render.exposure.compensation=0", "render.exposure.compensation=1"}) {
        Options options = options_with({"gi.technique=none", compensation});
        options.preset = "low";
        Playthrough playthrough(options, scene);
        session::Session& session = playthrough.session();
        add_pictures(session.app(), options);
        session.app().show();
        brightness.push_back(mean(picture(session.app())));
        EXPECT_EQ(session.app().world().resource<Renderer>().frame->light_maps().resolution(), 256);
    }
    EXPECT_GT(brightness[1], 1.1 * brightness[0]);
}

TEST(Picture, ShowsAFigureThatWalks) {
    context();
    const Options options = options_with({"gi.technique=none"});
    Playthrough playthrough(options, room_with_puppet());
    session::Session& session = playthrough.session();
    App& app = session.app();
    add_pictures(app, options);
    app.show();
    const auto joints = [&] {
        std::vector<dvec3> places;
        app.world().query<ecs::Read<SkinInstance>>().each([&](const SkinInstance& skin) {
            for (const ecs::Entity joint : skin.joints) {
                places.emplace_back(app.world().get<WorldTransform>(joint).matrix[3]);
            }
        });
        return places;
    };
    const std::vector<dvec3> stood = joints();
    const std::vector<float> before = picture(app);
    ASSERT_GT(stood.size(), 10u);
    app.frame(0.5);
    while (session.steps() < 30) {
        app.frame(0.1);
    }
    const std::vector<dvec3> walked = joints();
    std::size_t moved = 0;
    for (std::size_t i = 0; i < stood.size(); ++i) {
        moved += glm::distance(stood[i], walked[i]) > 0.01 ? 1 : 0;
    }
    EXPECT_EQ(moved, stood.size());
    EXPECT_NE(picture(app), before);
}

// The tour, with a frame every fourth step: the sensor reads what the lantern throws on the far wall.
TEST(Picture, TheFarRoomIsLitInTheTour) {
    context();
    Options options = options_with({});
    options.preset = "low";
    options.headless = true;
    Playthrough playthrough(options, import_gltf(support::repository_file("assets/lantern-room.glb")));
    session::Session& session = playthrough.session();
    App& app = session.app();
    add_pictures(app, options, {32, 24});
    const ecs::Entity sensor = find_by_name(app.world(), "far_sensor");
    float before_door = 0;
    while (!session.done()) {
        app.step();
        if (session.steps() % 4 == 0) {
            app.show();
        }
        if (session.steps() == Tour::kDoorStep) {
            before_door = app.world().get<LightSensor>(sensor).lux;
        }
    }
    EXPECT_LT(before_door, 0.2f);
    EXPECT_GT(app.world().get<LightSensor>(sensor).readings, 10u);
    EXPECT_TRUE(app.world().get<Goal>(sensor).reached) << app.world().get<LightSensor>(sensor).lux;
}

}  // namespace
}  // namespace lanthorn::game
