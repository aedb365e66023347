// The oracle of Lavignotte and Paulin 2003, sec. 4.3, by itself: resolve.comp on counts that are known on
// paper, at pixels that are not evenly spaced.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "gi_module/techniques/splat/picture_surfaces.h"
#include "lanthorn/gi/passes.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kPicture(24, 16);
constexpr float kInverseArea = 0.25f;  // 1/m^2

// What a line of pixels shows, which the picture repeats along the other axis.
struct Line {
    std::vector<float> place;       // metres
    std::vector<float> count;       // N
    std::vector<SurfaceSide> side;  // all of one surface by default
    std::size_t size() const { return place.size(); }
};

// `along_y`: the line lies along the picture's second axis.
struct Oracle {
    float least = 20, most = 500, bias = 0.3f;  // N_min, N_max, epsilon
    float bandwidth = 1e-6f;                    // metres; so little that neighbouring pixels are compared
    bool last_level = false, along_y = false;

    struct Answer {
        std::vector<bool> decided;      // by pixel of the line
        std::vector<float> irradiance;  // of it, red
        std::uint32_t bad = 0;
    };
    // Fails the test where the lines of a picture do not agree, or an open tile has no open pixel.
    Answer ask(const Line& line) const {
        context();
        const auto length = static_cast<int>(line.size());
        const ivec2 size = along_y ? ivec2(kPicture.x, length) : ivec2(length, kPicture.y);
        const ivec2 tiles = (size + 7) / 8;
        std::vector<PixelSurface> pixels;
        std::vector<vec4> sums;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const auto at = static_cast<std::size_t>(along_y ? y : x);
                const float across = static_cast<float>(along_y ? x : y);
                pixels.push_back({along_y ? vec3(across, line.place[at], 3) : vec3(line.place[at], across, 3),
                                  line.side.empty() ? 0 : line.side[at]});
                sums.emplace_back(4 * line.count[at], 0, 0, line.count[at]);
            }
        }
        const std::vector<float> areas(pixels.size(), kInverseArea), bandwidths(2, bandwidth);
        const std::vector<std::uint32_t> ones(static_cast<std::size_t>(tiles.x * tiles.y), 1);
        const auto pixel_data = gpu::Buffer::from(pixels), area_data = gpu::Buffer::from(areas),
                   bandwidth_data = gpu::Buffer::from(bandwidths), splatted = gpu::Buffer::from(ones);
        gpu::Buffer open(ones.size() * sizeof(std::uint32_t)), bad(sizeof(std::uint32_t));
        open.clear();
        bad.clear();
        const gpu::Texture counts = gpu::Texture::make_2d(GL_RGBA32F, size);
        glTextureSubImage2D(counts.id(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, sums.data());
        gpu::Texture irradiance = gpu::Texture::make_2d(GL_RGBA32F, size);
        irradiance.clear(vec4(0));
        const gpu::Texture decided = gpu::Texture::make_2d(GL_R32UI, size);
        const GLuint none = 0;
        glClearTexImage(decided.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
        const gpu::Program program({"gi_module/techniques/splat/resolve.comp"});
        program.use();
        counts.bind(0);
        gpu::BufferTexture area_texels, pixel_texels, bandwidth_texels, splatted_texels;
        area_texels.bind(1, area_data, GL_R32F);
        pixel_texels.bind(2, pixel_data, GL_RGBA32UI);
        bandwidth_texels.bind(3, bandwidth_data, GL_R32F);
        splatted_texels.bind(4, splatted, GL_R32UI);
        program.set("sums", 0);
        program.set("inverse_areas", 1);
        program.set("pixels", 2);
        program.set("bandwidths", 3);
        program.set("splatted", 4);
        program.set("image_size", size);
        program.set("tiles_across", tiles.x);
        program.set("last_level", last_level ? 1 : 0);
        program.set("least", least);
        program.set("most", most);
        program.set("bias", bias);
        irradiance.bind_image(0, GL_READ_WRITE);
        decided.bind_image(1, GL_READ_WRITE);
        open.bind_storage(0);
        bad.bind_storage(1);
        program.dispatch(size, ivec2(8));
        wait_for_shaders();

        std::vector<std::uint32_t> kept(pixels.size());
        glGetTextureImage(decided.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                          static_cast<GLsizei>(kept.size() * sizeof(std::uint32_t)), kept.data());
        const std::vector<float> light = irradiance.read_floats(4);
        const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * size.x + x); };
        Answer answer;
        answer.bad = bad.read<std::uint32_t>(1).front();
        std::vector<std::uint32_t> expected_open(ones.size(), 0);
        for (int i = 0; i < length; ++i) {
            const std::size_t first = along_y ? index(0, i) : index(i, 0);
            answer.decided.push_back(kept[first] != 0);
            answer.irradiance.push_back(light[4 * first]);
            for (int k = 0; k < (along_y ? size.x : size.y); ++k) {
                const ivec2 p = along_y ? ivec2(k, i) : ivec2(i, k);
                EXPECT_EQ(kept[index(p.x, p.y)], kept[first]) << p.x << " " << p.y;
                if (kept[first] == 0) {
                    expected_open[static_cast<std::size_t>(p.y / 8 * tiles.x + p.x / 8)] = 1;
                }
            }
        }
        EXPECT_EQ(open.read<std::uint32_t>(ones.size()), expected_open);
        return answer;
    }
};

// Pixels between 1 and 2 cm apart, one after the other in no order, as on a surface that is seen at an angle.
Line irregular(const std::function<float(float)>& count, std::size_t pixels = 24) {
    Line line;
    float x = -0.15f;
    for (std::size_t i = 0; i < pixels; ++i) {
        line.place.push_back(x);
        line.count.push_back(count(x));
        x += 0.01f * (1 + std::fmod(0.618034f * static_cast<float>(i * i + 1), 1.0f));
    }
    return line;
}

std::size_t decided(const Oracle::Answer& answer) {
    return static_cast<std::size_t>(std::ranges::count(answer.decided, true));
}

class OracleAlong : public ::testing::TestWithParam<bool> {};

TEST_P(OracleAlong, KeepsWhatIsConstant) {
    Oracle oracle;
    oracle.along_y = GetParam();
    oracle.bias = 0;
    const Line line = irregular([](float) { return 100.0f; });
    const Oracle::Answer answer = oracle.ask(line);
    EXPECT_EQ(decided(answer), line.size());
    for (const float lux : answer.irradiance) {
        EXPECT_FLOAT_EQ(lux, 4 * 100 * kInverseArea);  // eq. 7
    }
}

// Where the pixels' distances did not count, second differences of this line would be up to 4 % of N.
TEST_P(OracleAlong, KeepsWhatIsLinearInSpace) {
    Oracle oracle;
    oracle.along_y = GetParam();
    oracle.bias = 1e-4f;
    const Line line = irregular([](float x) { return 200 + 800 * x; });
    float uneven = 0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        uneven = std::max(
            uneven, std::abs(line.count[i + 1] - 2 * line.count[i] + line.count[i - 1]) / line.count[i]);
    }
    EXPECT_GT(uneven, 100 * oracle.bias);
    EXPECT_EQ(decided(oracle.ask(line)), line.size());
}

// N = a + b x^2: their formula gives b (x2 - x0)^2 / 2 at any three places; at the ends those next to them.
TEST_P(OracleAlong, AsksForLessWhereAParabolaBendsTooMuch) {
    constexpr float kBend = 8000;
    Oracle oracle;
    oracle.along_y = GetParam();
    const Line line = irregular([](float x) { return 100 + kBend * x * x; });
    for (const float bias : {0.01f, 0.03f, 0.05f, 0.07f, 0.1f}) {
        oracle.bias = bias;
        const Oracle::Answer answer = oracle.ask(line);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::size_t middle = std::clamp<std::size_t>(i, 1, line.size() - 2);
            const float level =
                0.5f * kBend * std::pow(line.place[middle + 1] - line.place[middle - 1], 2.0f);
            const bool keeps = level <= bias * line.count[i];
            ASSERT_GT(std::abs(level / (bias * line.count[i]) - 1), 1e-3f) << "too close to tell";
            EXPECT_EQ(answer.decided[i], keeps) << i << " at " << bias;
            EXPECT_EQ(answer.irradiance[i], keeps ? 4 * line.count[i] * kInverseArea : 0);
            kept += keeps ? 1 : 0;
        }
        EXPECT_EQ(decided(answer), kept);
        if (bias == 0.03f) {  // some of each
            EXPECT_GT(kept, 3u);
            EXPECT_LT(kept, line.size() - 3);
        }
    }
}

// 60 photons more from one pixel to the next: the two beside the step see it, those further off see none.
TEST_P(OracleAlong, AsksForLessBesideAStep) {
    Oracle oracle;
    oracle.along_y = GetParam();
    oracle.bias = 0.2f;
    Line line = irregular([](float) { return 100.0f; });
    std::fill(line.count.begin() + 12, line.count.end(), 160.0f);
    const Oracle::Answer answer = oracle.ask(line);
    for (std::size_t i = 0; i < line.size(); ++i) {
        EXPECT_EQ(answer.decided[i], i != 11 && i != 12) << i;
    }
    // Between two surfaces a step is none: each is looked at by itself.
    line.side.assign(line.size(), 0);
    std::fill(line.side.begin() + 12, line.side.end(), 1);
    EXPECT_EQ(decided(oracle.ask(line)), line.size());
}

// N_min and N_max go before the second difference.
TEST_P(OracleAlong, KeepsFewPhotonsAndNeverMany) {
    Oracle oracle;
    oracle.along_y = GetParam();
    Line line = irregular([](float) { return 2.0f; });
    std::fill(line.count.begin() + 12, line.count.end(), 19.0f);
    EXPECT_EQ(decided(oracle.ask(line)), line.size());  // below N_min, whatever the step
    std::ranges::fill(line.count, 500.0f);
    EXPECT_EQ(decided(oracle.ask(line)), 0u);  // N_max, though constant
    std::ranges::fill(line.count, 499.0f);
    EXPECT_EQ(decided(oracle.ask(line)), line.size());
    oracle.last_level = true;  // and in the last round nothing is left open
    std::ranges::fill(line.count, 5000.0f);
    EXPECT_EQ(decided(oracle.ask(line)), line.size());
}

// Half a bandwidth apart: on pixels 1 cm apart of h = 8 cm those four away are compared.
TEST_P(OracleAlong, ComparesHalfABandwidthApart) {
    constexpr float kBend = 8000;
    Oracle oracle;
    oracle.along_y = GetParam();
    oracle.bandwidth = 0.0801f;
    Line line;
    for (int i = 0; i < 24; ++i) {
        line.place.push_back(0.01f * static_cast<float>(i));
        line.count.push_back(100 + kBend * line.place.back() * line.place.back());
    }
    const float level = 0.5f * kBend * 0.08f * 0.08f;
    for (const float share : {0.98f, 1.02f}) {
        oracle.bias = share * level / line.count[12];
        EXPECT_EQ(oracle.ask(line).decided[12], share > 1);
    }
}

INSTANTIATE_TEST_SUITE_P(Axes, OracleAlong, ::testing::Bool());

// Pixels that show one point, a picture of one pixel, sums that are no numbers.
TEST(Oracle, EndsAreNoHarm) {
    Oracle oracle;
    Line line = irregular([](float) { return 100.0f; });
    std::ranges::fill(line.place, 0.5f);
    EXPECT_EQ(decided(oracle.ask(line)), line.size());
    const Line one = irregular([](float) { return 100.0f; }, 1);
    EXPECT_EQ(decided(oracle.ask(one)), 1u);
    line.count[3] = std::numeric_limits<float>::quiet_NaN();
    oracle.last_level = true;
    const Oracle::Answer answer = oracle.ask(line);
    EXPECT_EQ(answer.bad, static_cast<std::uint32_t>(kPicture.y));
    EXPECT_EQ(answer.irradiance[3], 0);
    EXPECT_EQ(decided(answer), line.size());
}

}  // namespace
}  // namespace lanthorn::gi::test
