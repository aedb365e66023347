// Several views of one world: each shows what an App of its own would show.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>

#include "engine/gpu/memory.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/scene/view.h"
#include "tests/support/repository.h"

namespace lanthorn::gi {
namespace {

constexpr ivec2 kSize(48, 36);
constexpr int kFrames = 5;

struct Picture {
    std::vector<float> final, indirect;
    bool operator==(const Picture&) const = default;
};

Settings settings_of(const char* preset, const char* technique = "emc") {
    static const SettingsSchema* const schema = [] {
        auto* declared = new SettingsSchema;
        declare_settings(*declared);
        return declared;
    }();
    Settings result(*schema);
    result.apply_preset(preset);
    result.set_from_text("gi.technique", technique);
    return result;
}

// A level that lives: its clip plays, its bodies move.
struct Level {
    App app;

    explicit Level(const char* file, const Settings& settings = settings_of("low")) {
        add_scene_plugins(app);
        add_picture_plugins(app, settings, true);
        const std::string path = support::repository_file(std::string("assets/") + file);
        spawn_scene(app, import_gltf(path), BadExtras::skip);
        play_clip(app.world(), "", file);
        app.view() = {.size = kSize, .camera = named("camera")};
    }
    ecs::Entity named(const char* name) { return find_by_name(app.world(), name); }
    const render::FrameRenderer& of(ViewId id) { return app.world().resource<Renderer>().of(id); }
    Picture picture(ViewId id = ViewId::first) {
        return {of(id).read(render::Aov::final).pixels, of(id).read(render::Aov::indirect).pixels};
    }
    void frame() { app.frame(1.0 / 60); }
    std::vector<gpu::PassTimer::Span> spans() { return app.world().resource<Renderer>().timer->end_frame(); }
};

std::string error_of(const std::function<void()>& what) {
    try {
        what();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

struct Alike {
    const char *level, *technique;
};

std::ostream& operator<<(std::ostream& out, const Alike& alike) {
    return out << alike.level << ", " << alike.technique;
}

class ViewsAlike : public testing::TestWithParam<Alike> {
  protected:
    std::unique_ptr<gpu::Context> context_ = gpu::create_headless_context();
};

TEST_P(ViewsAlike, ShowWhatOneShows) {
    const Settings settings = settings_of("low", GetParam().technique);
    Level one(GetParam().level, settings), two(GetParam().level, settings);
    const ViewId second = two.app.add_view({.size = kSize, .camera = two.named("camera")});
    for (int i = 0; i < kFrames; ++i) {
        one.frame();
        two.frame();
        const Picture expected = one.picture();
        EXPECT_TRUE(two.picture() == expected) << "the first, frame " << i;
        EXPECT_TRUE(two.picture(second) == expected) << "the second, frame " << i;
        EXPECT_GT(std::ranges::max(expected.indirect), 1);
    }
}

INSTANTIATE_TEST_SUITE_P(Techniques, ViewsAlike,
                         testing::Values(Alike{"lantern-room.glb", "emc"}, Alike{"puppet.glb", "emc"},
                                         Alike{"puppet.glb", "coarse-path"}, Alike{"puppet.glb", "drm"},
                                         Alike{"puppet.glb", "vertex-map"}, Alike{"puppet.glb", "splat"}));

class Views : public testing::Test {
  protected:
    std::unique_ptr<gpu::Context> context_ = gpu::create_headless_context();
};

// Other cameras, sizes, presets (light maps of other sizes among them) and techniques; one looks from far
// away.
TEST_F(Views, EachShowsWhatAnAppOfItsOwnShows) {
    const char* const file = "two-rooms.glb";
    const Settings path = settings_of("medium", "coarse-path");
    Level both(file), first(file), second(file, path);
    both.app.view().camera = first.app.view().camera = first.named("lit");
    const View dark{.size = {64, 80}, .camera = second.named("dark")};
    second.app.view() = dark;
    const ViewId added = both.app.add_view(dark);
    apply_settings(both.app, path, added);
    CameraView far_away = frame_all(Aabb());
    far_away.position += vec3(2e5f, 0, 0);
    const ViewId third = both.app.add_view({.size = {32, 32}, .placed = far_away});
    apply_settings(both.app, settings_of("low", "none"), third);
    for (int i = 0; i < kFrames; ++i) {
        for (Level* level : {&both, &first, &second}) {
            level->app.world().get_mut<LocalTransform>(dark.camera).value.translation.x += 0.02 * (i / 2);
            level->frame();
        }
        EXPECT_TRUE(both.picture() == first.picture()) << "frame " << i;
        EXPECT_TRUE(both.picture(added) == second.picture()) << "frame " << i;
        EXPECT_GT(std::ranges::max(both.picture(added).indirect), 1);
        EXPECT_GT(std::ranges::max(both.picture().indirect), 1);
    }
    EXPECT_NE(both.of(ViewId::first).light_maps().resolution(), both.of(added).light_maps().resolution());
    EXPECT_EQ(&both.of(ViewId::first).light_maps(), &both.of(third).light_maps()) << "asks the same of them";
    EXPECT_EQ(plan_table(technique_of(both.app, added).statistics(false).plan),
              plan_table(technique_of(second.app, ViewId::first).statistics(false).plan));
}

TEST_F(Views, ShareWhatBelongsToTheScene) {
    Level level("puppet.glb");
    const ViewId second = level.app.add_view({.size = {40, 30}, .name = "second"});
    Level alone("puppet.glb");
    int drawn = 0, drawn_alone = 0;
    for (int i = 0; i < kFrames; ++i) {
        level.frame();
        alone.frame();
        drawn += level.of(second).light_maps().layers_drawn();
        drawn_alone += alone.of(ViewId::first).light_maps().layers_drawn();
        int light_maps = 0, uploads = 0, gbuffers = 0, named = 0;
        for (const auto& span : level.spans()) {
            light_maps += span.name == "light_maps" ? 1 : 0;
            uploads += span.name == "upload" ? 1 : 0;
            gbuffers += span.name == "gbuffer" ? 1 : 0;
            named += span.name == "view 'second'" ? 1 : 0;
        }
        EXPECT_EQ(light_maps, 1);
        EXPECT_EQ(uploads, 1);
        EXPECT_EQ(gbuffers, 2);
        EXPECT_EQ(named, 7) << "gi.plan and six passes";
    }
    EXPECT_EQ(&level.of(ViewId::first).light_maps(), &level.of(second).light_maps());
    EXPECT_EQ(&level.of(ViewId::first).gpu_scene(), &level.of(second).gpu_scene());
    EXPECT_GT(drawn_alone, 0);
    EXPECT_EQ(drawn, drawn_alone);
}

// One that comes later shows what an App of its own shows that begins then; one that is resized goes on.
TEST_F(Views, ComeAndAreResized) {
    Level level("two-rooms.glb"), late("two-rooms.glb");
    level.frame();
    level.frame();
    late.app.skip_to(level.app.time().moment);
    const View dark{.size = {50, 50}, .camera = level.named("dark")};
    late.app.view() = dark;
    const ViewId added = level.app.add_view(dark);
    for (const ivec2 size : {ivec2(50), ivec2(50), ivec2(30, 60), ivec2(30, 60)}) {
        level.app.view(added).size = late.app.view().size = size;
        level.frame();
        late.frame();
        EXPECT_EQ(level.of(added).size(), size);
        EXPECT_TRUE(level.picture(added) == late.picture());
        EXPECT_GT(std::ranges::max(late.picture().indirect), 1);
    }
}

TEST_F(Views, AreNotDrawnWithoutASize) {
    Level level("two-rooms.glb"), fresh("two-rooms.glb");
    const ViewId second = level.app.add_view({.size = kSize, .camera = level.named("dark")});
    fresh.app.add_view({.size = kSize, .camera = level.named("dark")});
    level.frame();
    for (const ViewId id : {ViewId::first, second}) {
        const ViewId other = id == second ? ViewId::first : second;
        level.app.view(id).size.x = 0;
        level.frame();
        level.frame();
        EXPECT_EQ(error_of([&] { level.of(id); }),
                  "renderer: view " + std::to_string(static_cast<int>(id)) +
                      " is asked for, expected one that the last frame drew");
        EXPECT_NO_THROW(level.of(other));
        level.app.view(id).size = kSize;
    }
    level.app.view().size = level.app.view(second).size = ivec2(0);
    level.frame();
    EXPECT_TRUE(level.app.world().resource<Renderer>().views.empty());
    level.app.view().size = level.app.view(second).size = kSize;
    level.frame();
    fresh.app.skip_to(level.app.time().moment);
    fresh.app.show();
    EXPECT_TRUE(level.picture(second) == fresh.picture(second)) << "begins anew";
    EXPECT_EQ(level.picture().indirect, fresh.picture().indirect) << "the first too, but for its exposure";
}

// As if the frames in which it rested had not been; what moved meanwhile is followed, what came is not.
class ViewsRest : public Views, public testing::WithParamInterface<const char*> {};

TEST_P(ViewsRest, AndGoOn) {
    const Settings settings = settings_of("low", GetParam());
    Level rests("two-rooms.glb"), draws("two-rooms.glb");
    const View dark{.size = kSize, .camera = rests.named("dark")};
    const ViewId second = rests.app.add_view(dark);
    draws.app.add_view(dark);
    for (Level* level : {&rests, &draws}) {
        apply_settings(level->app, settings_of("low", "none"), ViewId::first);
        apply_settings(level->app, settings, second);
    }
    const auto frames = [&](Level& level, int count) {
        for (int i = 0; i < count; ++i) {
            level.frame();
        }
    };
    frames(rests, 6);
    frames(draws, 6);
    const Technique* const before = &technique_of(rests.app, second);
    rests.app.view(second).rests = true;
    frames(rests, 4);
    EXPECT_NE(error_of([&] { rests.of(second); }), "") << "it is not drawn";
    EXPECT_EQ(&technique_of(rests.app, second), before);
    rests.app.view(second).rests = false;
    frames(rests, 3);
    frames(draws, 3);
    EXPECT_EQ(rests.picture(second).indirect, draws.picture(second).indirect);

    // A lamp that is moved, and a thing.
    const auto lamps = rests.app.world().query<ecs::With<LightComponent>>().entities();
    const auto things = rests.app.world().query<ecs::With<MeshInstances>>().entities();
    ASSERT_FALSE(lamps.empty());
    ASSERT_FALSE(things.empty());
    rests.app.view(second).rests = true;
    frames(rests, 2);
    for (Level* level : {&rests, &draws}) {
        for (const ecs::Entity moved : {lamps.front(), things.front()}) {
            level->app.world().get_mut<LocalTransform>(moved).value.translation.y += 0.1;
        }
    }
    frames(rests, 3);
    const std::vector<float> old = draws.picture(second).indirect;
    rests.app.view(second).rests = false;
    frames(rests, 24);
    frames(draws, 24);
    EXPECT_EQ(&technique_of(rests.app, second), before);
    const std::vector<float> found = rests.picture(second).indirect;
    const std::vector<float> expected = draws.picture(second).indirect;
    double off = 0, moved_by = 0, sum = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto square = [](double x) { return x * x; };
        off += square(static_cast<double>(found[i]) - static_cast<double>(expected[i]));
        moved_by += square(static_cast<double>(old[i]) - static_cast<double>(expected[i]));
        sum += square(expected[i]);
    }
    EXPECT_GT(moved_by, 0);
    EXPECT_LT(off, 0.1 * moved_by) << "of " << sum;

    rests.app.view(second).rests = true;
    frames(rests, 1);
    const std::string path = support::repository_file("assets/lantern-room.glb");
    spawn_scene(rests.app, import_gltf(path), BadExtras::skip);
    rests.app.view(second).rests = false;
    frames(rests, 1);
    EXPECT_NE(&technique_of(rests.app, second), before) << "other things";
}

INSTANTIATE_TEST_SUITE_P(Techniques, ViewsRest, testing::Values("emc", "coarse-path", "path"));

TEST_F(Views, CanHaveTheExposureOfAnother) {
    Level level("two-rooms.glb");
    level.app.view().camera = level.named("lit");
    const ViewId dark = level.app.add_view({.size = kSize, .camera = level.named("dark")});
    level.frame();
    EXPECT_GT(level.of(dark).exposure(), 1.5f * level.of(ViewId::first).exposure());
    const std::vector<float> bright = level.picture(dark).final;
    level.app.view(dark).exposed_as = ViewId::first;
    level.frame();
    EXPECT_EQ(level.of(dark).exposure(), level.of(ViewId::first).exposure());
    const auto sum = [](const std::vector<float>& values) {
        return std::accumulate(values.begin(), values.end(), 0.0);
    };
    EXPECT_LT(sum(level.picture(dark).final), 0.8 * sum(bright));
    level.app.view(dark).exposed_as = ViewId{99};
    level.frame();
    EXPECT_GT(level.of(dark).exposure(), level.of(ViewId::first).exposure()) << "its own again";
}

TEST_F(Views, FreeWhatTheyHeld) {
    Level level("two-rooms.glb");
    level.frame();
    level.frame();
    const std::size_t before = gpu::allocated_bytes();
    const ViewId shares = level.app.add_view({.size = {200, 200}, .camera = level.named("dark")});
    level.frame();
    const std::size_t with_one = gpu::allocated_bytes();
    EXPECT_GT(with_one, before + 200 * 200 * 60);
    const ViewId apart = level.app.add_view({.size = {20, 20}});
    apply_settings(level.app, settings_of("high"), apart);
    level.frame();
    EXPECT_GT(gpu::allocated_bytes(), with_one);
    level.app.remove_view(apart);
    level.frame();
    EXPECT_EQ(gpu::allocated_bytes(), with_one) << "its technique and light maps";
    level.app.remove_view(shares);
    level.frame();
    EXPECT_EQ(gpu::allocated_bytes(), before);
    EXPECT_EQ(level.app.views(), std::vector{ViewId::first});
}

TEST_F(Views, SayWhatIsWrongOfWhichView) {
    Level level("two-rooms.glb");
    const ecs::Entity camera = level.app.world().create(CameraComponent{}, LocalTransform{});
    const ViewId left = level.app.add_view({.size = kSize, .camera = camera, .name = "left"});
    level.frame();
    level.app.world().destroy(camera);
    const std::string expected = "view 'left': its camera, " + ecs::to_string(camera) +
                                 ", has been destroyed; expected an entity with a camera, or none";
    EXPECT_EQ(error_of([&] { level.frame(); }), expected);
    level.app.view(left).camera = level.named("lit-table");
    EXPECT_NE(error_of([&] { level.frame(); }).find("view 'left': its camera, entity "), std::string::npos);
    level.app.view(left).size = ivec2(0);
    EXPECT_NO_THROW(level.frame()) << "what is not drawn needs no camera";
    level.app.view(left) = {.size = kSize, .name = "left"};
    GiSettings settings;
    settings.technique = static_cast<TechniqueKind>(77);
    set_gi_settings(level.app, settings, left);
    EXPECT_EQ(error_of([&] { level.frame(); }),
              fmt::format("view 'left': found technique 77, expected one of {} (0 to {})",
                          fmt::join(technique_names(), ", "), techniques().size() - 1));
    set_gi_settings(level.app, GiSettings{}, left);
    level.frame();
    level.frame();

    // After frames that failed, both show what they show in an App in which none did.
    Level fresh("two-rooms.glb");
    const ViewId right = fresh.app.add_view({.size = kSize});
    set_gi_settings(fresh.app, GiSettings{}, right);
    fresh.app.skip_to(level.app.time().moment);
    fresh.app.show();
    fresh.app.show();
    EXPECT_EQ(level.picture(left).indirect, fresh.picture(right).indirect);
    EXPECT_EQ(level.picture().indirect, fresh.picture().indirect);

    for (const ViewId id : {ViewId::first, ViewId(9)}) {
        EXPECT_EQ(error_of([&] { level.app.remove_view(id); }),
                  "app: view " + std::to_string(static_cast<int>(id)) +
                      " is to be removed, expected one that was added and not removed");
    }
    level.app.remove_view(left);
    EXPECT_EQ(error_of([&] { level.app.view(left); }),
              "app: there is no view 1, expected one that was added and not removed");
    EXPECT_NE(level.app.add_view({}), left) << "its number is not given again";
}

TEST_F(Views, ArePresentedInPanes) {
    Level level("cornell.glb");
    level.app.add<PresentPlugin>();
    const ViewId inset = level.app.add_view({.size = {20, 10}});
    constexpr ivec2 kWindow(100, 80);
    gpu::Texture window = gpu::Texture::make_2d(GL_RGBA8, kWindow);
    const gpu::Framebuffer framebuffer({&window}, nullptr);
    PresentTarget& target = level.app.world().resource_mut<PresentTarget>();
    target = {framebuffer.id(), kWindow, {{ViewId::first, ivec2(0), kSize}, {inset, {70, 60}, {20, 10}}}};
    level.frame();
    const std::vector<float> shown = window.read_floats(3);
    const std::vector<float> large = level.of(ViewId::first).final().read_floats(3);
    const std::vector<float> small = level.of(inset).final().read_floats(3);
    int wrong = 0;
    for (int y = 0; y < kWindow.y; ++y) {
        for (int x = 0; x < kWindow.x; ++x) {
            const ivec2 in(x - 70, y - 60);
            const bool in_small = in.x >= 0 && in.y >= 0 && in.x < 20 && in.y < 10;
            for (int c = 0; c < 3; ++c) {
                const float expected = in_small                     ? small[(in.y * 20 + in.x) * 3 + c]
                                       : x < kSize.x && y < kSize.y ? large[(y * kSize.x + x) * 3 + c]
                                                                    : 0;
                wrong += shown[(y * kWindow.x + x) * 3 + c] == expected ? 0 : 1;
            }
        }
    }
    EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace lanthorn::gi
