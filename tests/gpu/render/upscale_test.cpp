// Up-scaled pictures where it is hard: what blinks, jumps, spins and uncovers, cuts, other sizes, and a
// history that is no number.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <vector>

#include "engine/render/upscaler.h"
#include "tests/gpu/render/scenes.h"

namespace lanthorn {
namespace {

using render::Upscale;
using testing::SceneBuilder;

constexpr ivec2 kDrawn(80, 48), kWhole(160, 96);
constexpr std::uint32_t kBoard = 0, kMover = 1;  // instances

// A chequered board, unlit as all is here so that only motion tells, and a light square in front of it.
SceneBuilder board() {
    SceneBuilder b;
    Image squares{"squares", 16, 16, {}};
    for (std::uint32_t i = 0; i < 256; ++i) {
        const std::uint8_t grey = (i % 16 + i / 16) % 2 == 0 ? 60 : 90;
        squares.rgba.insert(squares.rgba.end(), {grey, grey, 100, 255});
    }
    Material material;
    material.unlit = true;
    Sampler sampler;
    sampler.mag = Filter::nearest;
    material.base_colour_texture.texture = b.add_image(squares, sampler);
    b.add_quad(b.add_material(material), vec3(0), vec3(2, 0, 0), vec3(0, 1.2, 0));
    Material light;
    light.unlit = true;
    light.double_sided = true;
    light.base_colour = vec4(0.9f, 0.7f, 0.3f, 1);
    b.add_quad(b.add_material(light), vec3(0, 0, 0.3f), vec3(0.3f, 0, 0), vec3(0, 0.3f, 0));
    b.look(vec3(0, 0, 3), vec3(0), 0.7f);
    return b;
}

// Frames of a scene that changes from one to the next.
class Show {
  public:
    explicit Show(const SceneBuilder& builder, Upscale upscale = Upscale::temporal, ivec2 drawn = kDrawn,
                  ivec2 whole = kWhole)
        : drawn_(drawn), whole_(whole), scene_(builder.build()) {
        renderer.settings.upscale = upscale;
        renderer.settings.upscale_sharpness = 0;
        renderer.settings.antialias = true;  // as the first frame of an up-scaled picture has it
        renderer.settings.tone_map = render::ToneMap::none;
        testing::context();
    }

    FrameScene& scene() { return scene_; }
    void move(std::uint32_t instance, const mat4& to) {
        scene_.instances[instance].transform = to;
        scene_.instances[instance].bounds = Aabb(vec3(-10), vec3(10));
        scene_.changes.geometry = true;
        scene_.changes.moved.push_back(instance);
    }
    void set_size(ivec2 drawn, ivec2 whole) {
        drawn_ = drawn;
        whole_ = whole;
    }
    ImageF draw() {
        gpu::PassTimer timer(false, true);
        renderer.begin(scene_, drawn_, timer, whole_);
        renderer.draw_light_maps(scene_, timer);
        renderer.draw_gbuffer(scene_, timer);
        renderer.draw_direct(scene_, {}, timer);
        renderer.compose(scene_, {}, timer);
        renderer.upscale(scene_, timer);
        ++scene_.frame;
        scene_.changes = {};
        scene_.changes.assets = scene_.changes.geometry = scene_.changes.lights = scene_.changes.camera =
            false;
        return renderer.read(render::Aov::final);
    }

    render::FrameRenderer renderer;

  private:
    ivec2 drawn_, whole_;
    FrameScene scene_;
};

double difference(const ImageF& a, const ImageF& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        sum += std::abs(static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]));
    }
    return sum / static_cast<double>(a.pixels.size());
}

mat4 at(float x) {
    return glm::translate(mat4(1), vec3(x, 0, 0));
}

// Two shows of the same, up-scaled and drawn in full.
struct Beside {
    explicit Beside(const SceneBuilder& builder)
        : found(builder), full(builder, Upscale::none, kWhole, kWhole), once(builder, Upscale::spatial) {}
    template <class Change>
    void change(const Change& change) {
        change(found);
        change(full);
        change(once);
    }
    double draw() {
        now = found.draw();
        truth = full.draw();
        alone = once.draw();
        return difference(now, truth);
    }
    // Of a frame by itself.
    double single() const { return difference(alone, truth); }

    Show found, full, once;
    ImageF now, truth, alone;
};

// Means of squares of `side` pixels.
ImageF averaged(const ImageF& fine, int side) {
    ImageF result{fine.width / side, fine.height / side, 3, {}, {}};
    for (int i = 0; i < result.width * result.height * 3; ++i) {
        const int x = i / 3 % result.width, y = i / 3 / result.width;
        float sum = 0;
        for (int k = 0; k < side * side; ++k) {
            sum += fine.at(x * side + k % side, y * side + k / side, i % 3);
        }
        result.pixels.push_back(sum / static_cast<float>(side * side));
    }
    return result;
}

// Against the means of what is within each pixel, which a picture of full size has only a sample of.
TEST(Upscale, AtRestComesNearerToAllThatIsInAPixelThanFullSizeDoes) {
    constexpr int kFine = 4;
    Beside beside(board());
    Show fine(board(), Upscale::none, kFine * kWhole, kFine * kWhole);
    const auto turn = [](Show& s) { s.move(kMover, glm::rotate(mat4(1), 0.3f, vec3(0, 0, 1))); };
    beside.change(turn);
    turn(fine);
    for (int frame = 0; frame < 16; ++frame) {
        beside.draw();
    }
    const ImageF truth = averaged(fine.draw(), kFine);
    const double error = difference(beside.now, truth), single = difference(beside.alone, truth);
    const double full = difference(beside.truth, truth);
    std::printf("at rest: mean difference %.4f, of a frame alone %.4f, of full size %.4f\n", error, single,
                full);
    EXPECT_LT(error, 0.5 * single);
    EXPECT_LT(error, full);
}

// Errors where the mover was, by how many frames ago.
TEST(Upscale, LeavesNoGhostOfWhatSlides) {
    constexpr int kAges = 12, kSlides = 24;
    Beside beside(board());
    std::vector<int> uncovered(static_cast<std::size_t>(kWhole.x) * kWhole.y, -1);
    std::vector<double> sums(kAges + 1, 0), singles(kAges + 1, 0), counts(kAges + 1, 0);
    double elsewhere = 0, pixels_elsewhere = 0;
    for (int frame = 0; frame < kSlides; ++frame) {
        beside.change([&](Show& s) { s.move(kMover, at(-0.9f + 0.06f * static_cast<float>(frame))); });
        beside.draw();
        for (std::size_t i = 0; i < uncovered.size(); ++i) {
            const bool covers = beside.truth.pixels[3 * i] > 0.6f;
            uncovered[i] = covers ? 0 : uncovered[i] >= 0 ? uncovered[i] + 1 : -1;
            const double off = std::abs(static_cast<double>(beside.now.pixels[3 * i]) -
                                        static_cast<double>(beside.truth.pixels[3 * i]));
            const double alone = std::abs(static_cast<double>(beside.alone.pixels[3 * i]) -
                                          static_cast<double>(beside.truth.pixels[3 * i]));
            if (uncovered[i] > 0 && uncovered[i] <= kAges) {
                sums[static_cast<std::size_t>(uncovered[i])] += off;
                singles[static_cast<std::size_t>(uncovered[i])] += alone;
                counts[static_cast<std::size_t>(uncovered[i])] += 1;
            } else if (uncovered[i] < 0 && frame >= 8) {
                elsewhere += off;
                pixels_elsewhere += 1;
            }
        }
    }
    elsewhere /= pixels_elsewhere;
    std::printf("ghost: elsewhere %.4f; by age", elsewhere);
    for (std::size_t age = 1; age <= kAges; ++age) {
        std::printf(" %.4f (%.4f alone)", sums[age] / counts[age], singles[age] / counts[age]);
    }
    std::printf("\n");
    for (std::size_t age = 1; age <= kAges; ++age) {
        EXPECT_LT(sums[age], 1.25 * singles[age]) << age;
        if (age >= 8) {
            EXPECT_LT(sums[age] / counts[age], 1.25 * elsewhere + 0.002) << age;
        }
    }
}

TEST(Upscale, TakesWhatBlinksJumpsAndSpinsAsItIs) {
    struct Hardship {
        const char* name;
        mat4 (*place)(int frame);
    };
    const Hardship hardships[] = {
        {"blinks", [](int frame) { return frame % 2 == 0 ? at(0) : at(100); }},
        {"jumps", [](int frame) { return at(0.5f * static_cast<float>(frame * 7 % 5 - 2)); }},
        {"spins",
         [](int frame) { return glm::rotate(mat4(1), kPi * static_cast<float>(frame), vec3(0, 1, 0)); }},
        {"grows", [](int frame) { return glm::scale(mat4(1), vec3(0.1f * static_cast<float>(frame))); }}};
    for (const Hardship& hardship : hardships) {
        Beside beside(board());
        double worst = 0;
        for (int frame = 0; frame < 12; ++frame) {
            beside.change([&](Show& s) { s.move(kMover, hardship.place(frame)); });
            const double error = beside.draw();
            worst = std::max(worst, error / beside.single());
        }
        std::printf("%s: worst frame errs %.2f times a frame alone\n", hardship.name, worst);
        EXPECT_LT(worst, 1.1) << hardship.name;
    }
}

TEST(Upscale, CameraThatJumpsOrSpinsHasNoPast) {
    for (const bool spins : {false, true}) {
        Beside beside(board());
        double worst = 0;
        for (int frame = 0; frame < 10; ++frame) {
            beside.change([&](Show& s) {
                SceneBuilder other = board();
                const float side = frame % 2 == 0 ? 1.0f : -1.0f;
                if (spins) {  // round the board: its back side is culled, nothing is seen
                    other.look(vec3(0.4f, 0, 3 * side), vec3(0), 0.7f);
                } else {
                    other.look(vec3(1.2f * side, 0.3f, 2), vec3(0), 0.7f);
                }
                s.scene().camera = other.build().camera;
                s.scene().changes.camera = true;
            });
            const double error = beside.draw();
            worst = std::max(worst, error - 1.1 * beside.single());
        }
        EXPECT_LE(worst, 0.001) << (spins ? "spins" : "jumps");
    }
}

TEST(Upscale, FollowsACameraThatWalks) {
    Beside beside(board());
    double error = 0, single = 0;
    for (int frame = 0; frame < 20; ++frame) {
        beside.change([&](Show& s) {
            SceneBuilder other = board();
            const float x = 0.02f * static_cast<float>(frame);
            other.look(vec3(x, 0.1f, 3 - x), vec3(x, 0, 0), 0.7f);
            s.scene().camera = other.build().camera;
            s.scene().changes.camera = true;
        });
        const double now = beside.draw();
        if (frame >= 12) {
            error += now;
            single += beside.single();
        }
    }
    std::printf("walk: %.4f, of frames alone %.4f\n", error / 8, single / 8);
    EXPECT_LT(error, 0.9 * single);
}

TEST(Upscale, ANumberThatIsNoneIsGoneInOneFrame) {
    for (const bool moves : {false, true}) {
        Show show(board());
        for (int frame = 0; frame < 6; ++frame) {
            show.draw();
        }
        const gpu::Texture& history = show.renderer.upscaled_history();
        const float bad = std::numeric_limits<float>::quiet_NaN();
        const std::vector<float> square(4 * 6 * 5, bad);
        glTextureSubImage2D(history.id(), 0, 70, 40, 6, 5, GL_RGBA, GL_FLOAT, square.data());
        if (moves) {
            show.move(kMover, at(0.02f));
        }
        const ImageF after = show.draw();
        for (const float value : show.renderer.upscaled_history().read_floats(4)) {
            ASSERT_TRUE(std::isfinite(value));
        }
        const ImageF next = show.draw();
        EXPECT_LT(difference(after, next), 0.01);
    }
}

TEST(Upscale, TakesAnySize) {
    struct Sizes {
        ivec2 drawn, whole;
    };
    for (const Sizes& sizes : {Sizes{{1, 1}, {1, 1}}, Sizes{{1, 1}, {3, 2}}, Sizes{{7, 5}, {64, 40}},
                               Sizes{{80, 48}, {81, 48}}, Sizes{{31, 17}, {97, 61}}}) {
        Show show(board(), Upscale::temporal, sizes.drawn, sizes.whole);
        ImageF last;
        for (int frame = 0; frame < 3; ++frame) {
            last = show.draw();
        }
        EXPECT_EQ(ivec2(last.width, last.height), sizes.whole);
        for (const float value : last.pixels) {
            ASSERT_TRUE(value >= 0 && value <= 1);
        }
    }
}

TEST(Upscale, OfAnotherSizeBeginsAnew) {
    Show show(board());
    for (int frame = 0; frame < 8; ++frame) {
        show.draw();
    }
    show.set_size(kDrawn + 9, kWhole);
    Show fresh(board(), Upscale::temporal, kDrawn + 9, kWhole);
    EXPECT_EQ(show.draw().pixels, fresh.draw().pixels);
}

TEST(Upscale, IsNotThereWhereAllIsDrawnOrNothingIsAsked) {
    Show plain(board(), Upscale::none, kWhole, kWhole);
    Show all(board(), Upscale::temporal, kWhole, kWhole);
    Show unasked(board(), Upscale::none, kDrawn, kWhole);
    Show small(board(), Upscale::none, kDrawn, ivec2(0));
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_EQ(plain.draw().pixels, all.draw().pixels);
        EXPECT_EQ(unasked.draw().pixels, small.draw().pixels);
    }
}

TEST(Upscale, IsTheSameEachTime) {
    Show a(board()), b(board());
    for (int frame = 0; frame < 5; ++frame) {
        for (Show* show : {&a, &b}) {
            show->move(kMover, at(0.05f * static_cast<float>(frame)));
        }
        EXPECT_EQ(a.draw().pixels, b.draw().pixels);
    }
}

}  // namespace
}  // namespace lanthorn
