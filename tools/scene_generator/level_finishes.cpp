#include "tools/scene_generator/level_finishes.h"

#include <cmath>

#include "lanthorn/core/colour.h"
#include "tools/scene_generator/uniform.h"

namespace lanthorn::scene_generator {

namespace {

constexpr int kPixels = 128, kCoarse = 64;  // a texture of 128 x 128 is 49 kB of the level's file

// Smooth noise that repeats after 1, `cells` bumps a side; about 0.5.
double bumps(std::uint64_t seed, int cells, double x, double y) {
    const double u = x * cells, v = y * cells;
    const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
    const auto at = [&](int a, int c) {
        const int wrapped = (a % cells + cells) % cells + cells * ((c % cells + cells) % cells);
        return uniform(seed, static_cast<std::uint64_t>(wrapped));
    };
    const auto ease = [](double t) { return t * t * (3 - 2 * t); };
    const double s = ease(u - i), t = ease(v - j);
    return glm::mix(glm::mix(at(i, j), at(i + 1, j), s), glm::mix(at(i, j + 1), at(i + 1, j + 1), s), t);
}

double rough(std::uint64_t seed, int cells, double x, double y) {
    return 0.55 * bumps(seed, cells, x, y) + 0.3 * bumps(seed + 1, 2 * cells, x, y) +
           0.15 * bumps(seed + 2, 4 * cells, x, y);
}

// Linear to sRGB, in few steps: a file of fewer bytes.
dvec3 encoded(const dvec3& linear) {
    dvec3 result;
    for (int c = 0; c < 3; ++c) {
        result[c] = std::round(64 * srgb_from_linear(glm::clamp(linear[c], 0.0, 1.0))) / 64;
    }
    return result;
}

// Blocks in rows: how far a place is from the edge of its block, in blocks' heights, and which block it is.
struct Block {
    double edge;
    std::uint64_t number;
};
Block block_at(double x, double y, int rows, int columns, double aspect) {
    const double v = y * rows;
    const int row = static_cast<int>(v);
    const double u =
        x * columns + (row % 2 == 0 ? 0 : 0.5) + 0.16 * uniform(5, static_cast<std::uint64_t>(row));
    const int column = static_cast<int>(u) % columns;
    const double across = std::min(v - row, row + 1 - v);
    const double along = aspect * std::min(u - std::floor(u), std::floor(u) + 1 - u);
    return {std::min(across, along), static_cast<std::uint64_t>(row * columns + column)};
}

std::uint32_t blocks(Builder& b, const std::string& name, const vec3& stone, int rows, int columns,
                     double metres, double joint, double depth) {
    const std::uint32_t material = b.matte(name, vec3(1), 0.5f);
    const double aspect = static_cast<double>(rows) / columns;
    b.texture(material, kPixels, metres, [=](double x, double y) {
        const Block block = block_at(x, y, rows, columns, aspect);
        const double tone = 0.78 + 0.3 * uniform(31, block.number) + 0.3 * (rough(41, 8, x, y) - 0.5);
        const dvec3 tint(1, 0.98 + 0.05 * uniform(32, block.number), 0.94 + 0.1 * uniform(33, block.number));
        return encoded(dvec3(stone) * tint * (block.edge < joint ? 0.55 : tone));
    });
    relief(b, material, kPixels, metres, [=](double x, double y) {
        const Block block = block_at(x, y, rows, columns, aspect);
        const double bevel = glm::smoothstep(0.3 * joint, 2.5 * joint, block.edge);
        return depth * (bevel + 0.25 * rough(41, 8, x, y) + 0.15 * uniform(34, block.number));
    });
    return material;
}

}  // namespace

void relief(Builder& b, std::uint32_t material, int pixels, double metres,
            const std::function<double(double, double)>& height) {
    Image image;
    image.name = b.scene.materials[material].name + "-relief";
    image.width = image.height = static_cast<std::uint32_t>(pixels);
    const double step = 1.0 / pixels;
    const auto wrapped = [&](double x, double y) { return height(x - std::floor(x), y - std::floor(y)); };
    for (int row = 0; row < pixels; ++row) {
        for (int column = 0; column < pixels; ++column) {
            const double x = (column + 0.5) * step, y = (row + 0.5) * step;
            const double across = (wrapped(x + step, y) - wrapped(x - step, y)) / (2 * step * metres);
            const double down = (wrapped(x, y + step) - wrapped(x, y - step)) / (2 * step * metres);
            // Green is up (glTF 2.0, 3.9.3), rows go down.
            const dvec3 n = glm::normalize(dvec3(-across, down, 1));
            for (int c = 0; c < 3; ++c) {
                const double coarse = std::round(48 * n[c]) / 48;
                image.rgba.push_back(
                    static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * glm::clamp(coarse, -1.0, 1.0))));
            }
            image.rgba.push_back(255);
        }
    }
    b.scene.images.push_back(std::move(image));
    b.scene.textures.push_back({static_cast<std::uint32_t>(b.scene.images.size() - 1), {}});
    TextureRef& reference = b.scene.materials[material].normal_texture;
    reference.texture = static_cast<std::uint32_t>(b.scene.textures.size() - 1);
    const auto scale = static_cast<float>(1 / metres);
    reference.uv_transform = {vec3(scale, 0, 0), vec3(0, scale, 0)};
}

std::uint32_t painted_plaster(Builder& b, const std::string& name, const vec3& mean) {
    const std::uint32_t material = b.matte(name, vec3(1), 0.5f);
    b.texture(material, kCoarse, 2.4,
              [=](double x, double y) { return encoded(dvec3(mean) * (0.75 + 0.5 * rough(71, 5, x, y))); });
    relief(b, material, kCoarse, 2.4, [](double x, double y) { return 0.03 * rough(72, 6, x, y); });
    return material;
}

std::uint32_t painted_stone(Builder& b, const std::string& name, const vec3& mean) {
    return blocks(b, name, mean, 4, 2, 1.6, 0.03, 0.012);
}

Finishes finishes(Builder& b, const vec3& stone) {
    Finishes made{};
    made.ashlar = blocks(b, "ashlar", stone, 4, 2, 1.6, 0.035, 0.012);
    made.flags = blocks(b, "flagstones", 0.8f * stone, 3, 3, 1.8, 0.03, 0.01);
    made.plaster = painted_plaster(b, "plaster", {0.6f, 0.54f, 0.45f});
    made.oak = b.matte("oak", vec3(1), 0.5f);
    const auto board = [](double y) { return static_cast<std::uint64_t>(5 * y); };
    const auto grain = [](double x, double y) {
        return bumps(81, 4, 0.25 * std::round(4 * y) + 0.5 * x, 9 * y) * 0.6 +
               bumps(82, 48, 0.125 * x, y) * 0.4;
    };
    b.texture(made.oak, kPixels, 0.9, [=](double x, double y) {
        const double across = 5 * y - static_cast<double>(board(y));
        const double tone = (0.7 + 0.35 * uniform(83, board(y))) * (0.7 + 0.6 * grain(x, y));
        return encoded(dvec3(0.26, 0.155, 0.085) * (across < 0.05 ? 0.4 : tone));
    });
    relief(b, made.oak, kCoarse, 0.9, [=](double x, double y) {
        const double across = 5 * y - static_cast<double>(board(y));
        return 0.004 * glm::smoothstep(0.02, 0.1, std::min(across, 1 - across)) + 0.0015 * grain(x, y);
    });
    made.iron = b.matte("iron", {0.05f, 0.05f, 0.055f}, 0.5f);
    made.brass = b.matte("brass", {0.5f, 0.33f, 0.12f}, 0.5f);
    made.trim = b.matte("trim", 1.1f * stone, 0.5f);
    made.slate = b.matte("slate", {0.05f, 0.053f, 0.06f}, 0.5f);
    return made;
}

}  // namespace lanthorn::scene_generator
