#include "engine/scene/emissive_pieces.h"

#include <algorithm>
#include <cmath>

#include "engine/scene/texture_lookup.h"
#include "lanthorn/core/colour.h"

namespace lanthorn {

namespace {

constexpr std::size_t kMostPieces = std::size_t{1} << 14;  // of a mesh
constexpr int kMostHalvings = 12;
constexpr int kLeastLooksASide = 4, kMostLooksASide = 8;  // so many squared, looks at the texture a piece
constexpr float kEven = 0.1f;                             // of the brightest there is
constexpr double kTexelsOfColours = 256;                  // that alphas of vertices are worth

using Corners = std::array<vec3, 3>;

// What a triangle shows of a texture.
class Layer {
  public:
    Layer() = default;
    Layer(const SceneAssets& assets, const TextureRef& ref, const std::array<const Vertex*, 3>& corners)
        : assets_(&assets), texture_(&assets.textures[ref.texture]) {
        for (std::size_t k = 0; k < 3; ++k) {
            const vec3 at(ref.uv_set == 0 ? corners[k]->uv0 : corners[k]->uv1, 1);
            uv_[k] = {glm::dot(ref.uv_transform[0], at), glm::dot(ref.uv_transform[1], at)};
        }
    }

    bool present() const { return texture_ != nullptr; }
    double texels() const {  // 1 or more
        const Image& image = assets_->images[texture_->image];
        const vec2 a = uv_[1] - uv_[0], b = uv_[2] - uv_[0];
        const double texels = 0.5 *
                              std::abs(static_cast<double>(a.x) * static_cast<double>(b.y) -
                                       static_cast<double>(a.y) * static_cast<double>(b.x)) *
                              image.width * image.height;
        return std::isfinite(texels) ? std::max(texels, 1.0) : 1.0;
    }
    vec4 look(const vec3& barycentric) const {
        const vec2 at = uv_[0] * barycentric.x + uv_[1] * barycentric.y + uv_[2] * barycentric.z;
        return sample_texture(*assets_, *texture_, at, true);
    }

  private:
    const SceneAssets* assets_ = nullptr;
    const Texture* texture_ = nullptr;  // null: the material has none
    std::array<vec2, 3> uv_;
};

// What of its material's emission a triangle shows.
class Shown {
  public:
    Shown(const SceneAssets& assets, const Material& material, const std::array<const Vertex*, 3>& corners)
        : material_(material) {
        if (material.emissive_texture.present()) {
            emission_ = Layer(assets, material.emissive_texture, corners);
            texels_ = emission_.texels();
        }
        if (material.alpha_mode == AlphaMode::opaque) {
            return;
        }
        if (material.base_colour_texture.present()) {
            base_ = Layer(assets, material.base_colour_texture, corners);
            texels_ = std::max(texels_, base_.texels());
        }
        for (std::size_t k = 0; k < 3; ++k) {
            alphas_[static_cast<int>(k)] = corners[k]->colour.a;
        }
        if (alphas_ != vec3(alphas_.x)) {
            texels_ = std::max(texels_, kTexelsOfColours);
        }
    }

    double texels() const { return texels_; }

    // The mean over a piece that is so large a share of the triangle.
    vec3 mean(const Corners& piece, double share) const {
        const int side = std::clamp(static_cast<int>(std::ceil(std::sqrt(share * texels_))), kLeastLooksASide,
                                    kMostLooksASide);
        vec3 sum(0);
        // The middles of side * side triangles, half of which stand on their heads.
        for (int row = 0; row < side; ++row) {
            for (int i = 0; i < 2 * row + 1; ++i) {
                const bool upright = i % 2 == 0;
                const float r = static_cast<float>(row) + (upright ? 2.0f : 1.0f) / 3;
                const int column = i / 2;
                const float c = static_cast<float>(column) + (upright ? 1.0f : 2.0f) / 3;
                const float v = r / static_cast<float>(side), w = c / static_cast<float>(side);
                sum += look(piece[0] * (1 - v) + piece[1] * (v - w) + piece[2] * w);
            }
        }
        return sum / static_cast<float>(side * side);
    }

  private:
    vec3 look(const vec3& barycentric) const {
        const vec3 emission = emission_.present() ? vec3(emission_.look(barycentric)) : vec3(1);
        if (material_.alpha_mode == AlphaMode::opaque) {
            return emission;
        }
        float alpha = glm::dot(alphas_, barycentric);
        if (base_.present()) {
            alpha *= base_.look(barycentric).a;
        }
        if (material_.alpha_mode == AlphaMode::mask) {
            return material_.base_colour.a * alpha < material_.alpha_cutoff ? vec3(0) : emission;
        }
        return emission * glm::clamp(alpha, 0.0f, 1.0f);
    }

    const Material& material_;
    Layer emission_, base_;
    vec3 alphas_{1};  // of the vertices
    double texels_ = 1;
};

std::uint8_t largest(const Image& image, bool alpha) {
    std::uint8_t most = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        most = (i % 4 == 3) == alpha ? std::max(most, image.rgba[i]) : most;
    }
    return most;
}

// 0..1: of what any surface of the material shows.
float brightest_of(const SceneAssets& assets, const Material& material) {
    const auto most = [&](const TextureRef& ref, bool alpha) {
        return static_cast<float>(largest(assets.images[assets.textures[ref.texture].image], alpha)) / 255;
    };
    float brightest = 1;
    if (material.emissive_texture.present()) {
        brightest = linear_from_srgb(most(material.emissive_texture, false));
    }
    if (material.alpha_mode == AlphaMode::blend && material.base_colour_texture.present()) {
        brightest *= most(material.base_colour_texture, true);
    }
    return brightest;
}

}  // namespace

vec3 emitted(const Material& material) {
    const bool blended = material.alpha_mode == AlphaMode::blend;
    return blended ? material.emissive * std::clamp(material.base_colour.a, 0.0f, 1.0f) : material.emissive;
}

bool gives_light(const Material& material) {
    const vec3 nits = emitted(material);
    return nits.x > 0 || nits.y > 0 || nits.z > 0;
}

bool glows_in_pieces(const Material& material) {
    return material.emissive_texture.present() || material.alpha_mode != AlphaMode::opaque;
}

// Halves a triangle down to the last piece, and puts halves that glow alike together again on the way back.
class EmissiveCut {
  public:
    EmissiveCut(const Shown& shown, const Corners& positions, float tolerance, EmissivePieces& to)
        : shown_(shown), positions_(positions), tolerance_(tolerance), to_(to) {}

    void cut(int halvings) {
        begin_ = to_.pieces_.size();
        const Range whole = cut({vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}, 1, halvings);
        to_.roots_.push_back(whole.node);
        to_.first_.push_back(static_cast<std::uint32_t>(to_.pieces_.size()));
    }

  private:
    struct Range {
        vec3 least, most, mean;
        std::uint32_t node;
    };

    // Metres, squared.
    float length(const Corners& c, std::size_t edge) const {
        const vec3 d = c[(edge + 1) % 3] - c[edge];
        const vec3 across = positions_[0] * d.x + positions_[1] * d.y + positions_[2] * d.z;
        return glm::dot(across, across);
    }

    std::uint32_t add(EmissivePieces::Node node) {
        to_.nodes_.push_back(node);
        return static_cast<std::uint32_t>(to_.nodes_.size() - 1);
    }

    std::uint32_t add_piece(const Corners& c, const vec3& mean) {
        to_.pieces_.push_back({c, mean});
        return add({EmissivePieces::kWhole, static_cast<std::uint32_t>(to_.pieces_.size() - 1 - begin_), 0});
    }

    Range cut(const Corners& c, double share, int halvings) {
        if (halvings == 0) {
            const vec3 mean = shown_.mean(c, share);
            return {mean, mean, mean, add_piece(c, mean)};
        }
        std::size_t edge = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            edge = length(c, k) > 1.0001f * length(c, edge) ? k : edge;
        }
        const vec3 a = c[edge], b = c[(edge + 1) % 3], apex = c[(edge + 2) % 3];
        const vec3 middle = (a + b) * 0.5f;
        const std::size_t pieces = to_.pieces_.size(), nodes = to_.nodes_.size();
        const Range left = cut({a, middle, apex}, share / 2, halvings - 1);
        const Range right = cut({middle, b, apex}, share / 2, halvings - 1);
        Range both{glm::min(left.least, right.least), glm::max(left.most, right.most),
                   (left.mean + right.mean) * 0.5f, 0};
        const vec3 apart = both.most - both.least;
        if (to_.pieces_.size() == pieces + 2 && std::max({apart.x, apart.y, apart.z}) <= tolerance_) {
            to_.pieces_.resize(pieces);
            to_.nodes_.resize(nodes);
            both.node = add_piece(c, both.mean);
        } else {
            both.node = add({left.node, right.node, static_cast<std::uint32_t>(edge)});
        }
        return both;
    }

    const Shown& shown_;
    Corners positions_;
    float tolerance_;
    EmissivePieces& to_;
    std::size_t begin_ = 0;  // the triangle's first piece
};

std::size_t EmissivePieces::piece_at(std::size_t t, vec3 at) const {
    const Node* node = &nodes_[roots_[t]];
    while (node->left != kWhole) {
        const auto edge = static_cast<int>(node->edge);
        const float a = at[edge], b = at[(edge + 1) % 3], apex = at[(edge + 2) % 3];
        const bool left = a >= b;
        at = left ? vec3(a - b, 2 * b, apex) : vec3(2 * a, b - a, apex);
        node = &nodes_[left ? node->left : node->right];
    }
    return node->right;
}

EmissivePieces emissive_pieces(const SceneAssets& assets, const Mesh& mesh, const Material& material) {
    const float tolerance = kEven * brightest_of(assets, material);
    const std::size_t triangles = mesh.indices.size() / 3;
    int affordable = 0;
    while (affordable < kMostHalvings && (triangles << (affordable + 1)) <= kMostPieces) {
        ++affordable;
    }
    EmissivePieces result;
    for (std::size_t t = 0; t < triangles; ++t) {
        std::array<const Vertex*, 3> vertices;
        Corners positions;
        for (std::size_t k = 0; k < 3; ++k) {
            vertices[k] = &mesh.vertices[mesh.indices[3 * t + k]];
            positions[k] = vertices[k]->position;
        }
        const Shown shown(assets, material, vertices);
        const int halvings = std::min(affordable, static_cast<int>(std::ceil(std::log2(shown.texels()))));
        EmissiveCut(shown, positions, tolerance, result).cut(halvings);
    }
    return result;
}

vec3 mean_share(const Mesh& mesh, const mat4& transform, const EmissivePieces& pieces) {
    dvec3 sum(0);
    double whole = 0;
    for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
        Corners p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = vec3(transform * vec4(mesh.vertices[mesh.indices[3 * t + k]].position, 1));
        }
        const auto area = [](const Corners& c) {
            return 0.5 * static_cast<double>(glm::length(glm::cross(c[1] - c[0], c[2] - c[0])));
        };
        whole += area(p);
        for (const EmissivePiece& piece : pieces.of(t)) {
            sum += area(piece.within(p)) * dvec3(piece.share);
        }
    }
    return whole > 0 ? vec3(sum / whole) : vec3(0);
}

}  // namespace lanthorn
