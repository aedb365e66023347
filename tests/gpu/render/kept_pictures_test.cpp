// G-buffer and direct light of a view in which nothing has changed are kept, and nothing shows it.
#include <gtest/gtest.h>

#include <functional>

#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace kept_pictures_test {

constexpr ivec2 kSize(64, 48);

SceneChanges nothing() {
    SceneChanges none;
    none.assets = none.geometry = none.lights = none.camera = false;
    return none;
}

// Triangles that a frame's G-buffer is drawn of.
GLuint triangles_of(render::FrameRenderer& renderer, const FrameScene& scene) {
    gpu::PassTimer timer(false, true);
    renderer.begin(scene, kSize, timer);
    renderer.draw_light_maps(scene, timer);
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_PRIMITIVES_GENERATED, query);
    renderer.draw_gbuffer(scene, timer);
    glEndQuery(GL_PRIMITIVES_GENERATED);
    GLuint triangles = 0;
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles);
    glDeleteQueries(1, &query);
    renderer.draw_direct(scene, {}, timer);
    renderer.compose(scene, {}, timer);
    return triangles;
}

class KeptPictures : public ::testing::Test {
  protected:
    KeptPictures() {
        testing::context();
        drawing_.settings.still_kept = false;
    }

    // A frame of a renderer that keeps and of one that draws: the same pictures. What the first has drawn.
    GLuint frame() {
        const GLuint drawn = triangles_of(keeping_, scene_);
        triangles_of(drawing_, scene_);
        for (const render::Aov aov : {render::Aov::direct, render::Aov::normal, render::Aov::depth,
                                      render::Aov::albedo, render::Aov::final}) {
            EXPECT_EQ(keeping_.read(aov).pixels, drawing_.read(aov).pixels) << static_cast<int>(aov);
        }
        return drawn;
    }
    GLuint next_frame() {
        ++scene_.frame;
        return frame();
    }

    testing::SceneBuilder builder_ = testing::small_room(1, false);
    FrameScene scene_ = builder_.build();
    render::FrameRenderer keeping_, drawing_;
};

TEST_F(KeptPictures, WhileNothingChangesNothingIsDrawn) {
    EXPECT_GT(frame(), 0u);
    scene_.changes = nothing();
    EXPECT_EQ(next_frame(), 0u);
    EXPECT_EQ(next_frame(), 0u);
}

TEST_F(KeptPictures, WhatChangesIsDrawn) {
    const std::vector<std::function<void()>> changes = {
        [&] {
            scene_.lights[0].light.intensity *= 2;
            scene_.changes.lights = true;
        },
        [&] {
            scene_.camera.camera.y_fov *= 0.8f;
            scene_.changes.camera = true;
        },
        [&] { keeping_.settings.area_lights_max = drawing_.settings.area_lights_max = 2; },
    };
    frame();
    ImageF before = keeping_.read(render::Aov::direct);
    for (std::size_t i = 0; i < changes.size(); ++i) {
        scene_.changes = nothing();
        next_frame();
        changes[i]();
        // Light alone leaves the G-buffer as it is.
        EXPECT_EQ(next_frame() > 0, i > 0) << i;
        if (i < 2) {
            EXPECT_NE(keeping_.read(render::Aov::direct).pixels, before.pixels) << i;
        }
        before = keeping_.read(render::Aov::direct);
    }
}

// Of frames that another view alone has drawn, changes are not known.
TEST_F(KeptPictures, AFrameThatWasLeftOutIsDrawn) {
    frame();
    scene_.changes = nothing();
    ++scene_.frame;
    EXPECT_GT(next_frame(), 0u);
    EXPECT_EQ(next_frame(), 0u);
    keeping_.restart();
    EXPECT_GT(next_frame(), 0u);
}

}  // namespace kept_pictures_test
}  // namespace lanthorn
