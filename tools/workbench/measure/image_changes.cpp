#include "tools/workbench/measure/image_changes.h"

#include <algorithm>
#include <cmath>

#include "gi_module/reference/camera_rays.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/core/error.h"

namespace lanthorn::workbench {

namespace {

constexpr double kFloor = 0.01;        // of the mean's square: what local error is relative to in the dark
constexpr double kUnlit = 0.01;        // of the reference
constexpr int kNeighbours = 4;         // pixels to each side that brightness is a mean of
constexpr float kSameNormal = 0.9f;    // cosine
constexpr float kSameDepth = 0.004f;   // of the distance
constexpr float kTolerance = 0.001f;   // of the scene's diagonal
constexpr float kLeastWeight = 1e-3f;  // of a neighbour that is asked at all

dvec3 colour(const ImageF& image, std::size_t pixel) {
    const auto c = static_cast<std::size_t>(image.channels);
    return {image.pixels[c * pixel], image.pixels[c * pixel + 1], image.pixels[c * pixel + 2]};
}

double mean3(const dvec3& v) {
    return (v.x + v.y + v.z) / 3;
}

struct Means {
    double image = 0, reference = 0, luminance = 0, pixels = 0;
};

Means means_of(const ImageF& image, const Truth& truth) {
    Means m;
    for (std::size_t p = 0; p < truth.mask.size(); ++p) {
        if (truth.mask[p] != 0) {
            const dvec3 r = 0.5 * (colour(truth.pair->a, p) + colour(truth.pair->b, p));
            m.image += mean3(colour(image, p));
            m.reference += mean3(r);
            m.luminance += luminance(r);
            ++m.pixels;
        }
    }
    if (m.pixels > 0) {
        m.image /= m.pixels;
        m.reference /= m.pixels;
        m.luminance /= m.pixels;
    }
    return m;
}

bool same_surface(const Surfaces& s, std::size_t p, const Surfaces& t, std::size_t q) {
    if (s.depths[p] <= 0 || t.depths[q] <= 0 || glm::dot(s.normals[p], t.normals[q]) < kSameNormal) {
        return false;
    }
    const float apart = std::abs(glm::dot(s.normals[p], t.positions[q] - s.positions[p]));
    return apart < s.tolerance + kSameDepth * s.depths[p];
}

// A mean of squares of errors, each told by two noisy estimates a and b of it. a b is e^2 - d^2 with e = (a +
// b) / 2 and d = (a - b) / 2, whose noises are not correlated: (2 e d)^2 is an estimate of its variance, at
// most too large.
struct NoisySquare {
    double sum = 0, variance = 0;

    // `spread`: |(a + b) (a - b)|.
    void add(double product, double spread) {
        sum += product;
        variance += 0.25 * spread * spread;
    }
    // The root of the mean, over `unit`, and its standard error.
    void root(double count, double unit, double& value, double& sigma) const {
        const double mean = sum / count, mean_sigma = std::sqrt(variance) / count;
        value = mean < mean_sigma ? std::nan("") : std::sqrt(mean) / unit;
        sigma = value > 0 ? mean_sigma / (2 * value * unit * unit) : 0;
    }
};

}  // namespace

Truth truth_at(const ReferencePair& pair, const Surfaces& surfaces, PixelMask mask) {
    Truth truth{&pair, std::move(mask), {}};
    truth.brightness.assign(truth.mask.size(), 0);
    const ivec2 size = surfaces.size;
    for (std::size_t p = 0; p < truth.mask.size(); ++p) {
        if (truth.mask[p] == 0) {
            continue;
        }
        const ivec2 xy(static_cast<int>(p) % size.x, static_cast<int>(p) / size.x);
        const ivec2 from = glm::max(xy - kNeighbours, ivec2(0)), to = glm::min(xy + kNeighbours, size - 1);
        double sum = 0;
        int count = 0;
        for (int y = from.y; y <= to.y; ++y) {
            for (int x = from.x; x <= to.x; ++x) {
                const auto q = static_cast<std::size_t>(y * size.x + x);
                if (q == p || same_surface(surfaces, p, surfaces, q)) {
                    sum += 0.5 * luminance(colour(pair.a, q) + colour(pair.b, q));
                    ++count;
                }
            }
        }
        truth.brightness[p] = static_cast<float>(sum / count);
    }
    return truth;
}

ImageError image_error(const ImageF& image, const Truth& truth) {
    const Means m = means_of(image, truth);
    if (m.pixels == 0 || m.reference <= 0) {
        return {};
    }
    const double floor = kFloor * m.luminance * m.luminance;
    NoisySquare whole, local;
    for (std::size_t p = 0; p < truth.mask.size(); ++p) {
        if (truth.mask[p] != 0) {
            const dvec3 off_a = colour(image, p) - colour(truth.pair->a, p);
            const dvec3 off_b = colour(image, p) - colour(truth.pair->b, p);
            const double r = truth.brightness[p];
            whole.add(mean3(off_a * off_b), mean3(glm::abs((off_a + off_b) * (off_a - off_b))));
            const double a = luminance(off_a), b = luminance(off_b), weight = 1 / (r * r + floor);
            local.add(weight * a * b, weight * std::abs((a + b) * (a - b)));
        }
    }
    ImageError error;
    whole.root(m.pixels, m.reference, error.relrmse, error.relrmse_sigma);
    local.root(m.pixels, 1, error.local, error.local_sigma);
    error.flux = m.image / m.reference;
    error.reference_mean = m.reference;
    return error;
}

ImageError noise_of(const Truth& truth) {
    const ImageF &a = truth.pair->a, &b = truth.pair->b;
    const Means m = means_of(a, truth);
    if (m.pixels == 0 || m.reference <= 0) {
        return {};
    }
    const double floor = kFloor * m.luminance * m.luminance;
    double square = 0, local = 0;
    for (std::size_t p = 0; p < truth.mask.size(); ++p) {
        if (truth.mask[p] != 0) {
            const dvec3 half = 0.5 * (colour(a, p) - colour(b, p));
            const double r = truth.brightness[p];
            square += mean3(half * half);
            local += luminance(half) * luminance(half) / (r * r + floor);
        }
    }
    ImageError noise;
    noise.relrmse = std::sqrt(square / m.pixels) / m.reference;
    noise.local = std::sqrt(local / m.pixels);
    noise.flux = 1;
    noise.reference_mean = m.reference;
    return noise;
}

std::uint64_t unlit_pixels(const ImageF& direct, const ImageF& indirect, const Truth& truth) {
    std::uint64_t count = 0;
    for (std::size_t p = 0; p < truth.mask.size(); ++p) {
        const double own = 0.5 * luminance(colour(truth.pair->a, p) + colour(truth.pair->b, p));
        const double r = std::min(own, static_cast<double>(truth.brightness[p]));
        count += truth.mask[p] != 0 && r > 0 && luminance(colour(direct, p)) <= 0 &&
                         luminance(colour(indirect, p)) < kUnlit * r
                     ? 1
                     : 0;
    }
    return count;
}

PixelMask Surfaces::seen() const {
    PixelMask mask(depths.size());
    std::ranges::transform(depths, mask.begin(), [](float depth) { return depth > 0 ? 1 : 0; });
    return mask;
}

Surfaces surfaces_of(const FrameScene& frame, const ImageF& depth, const ImageF& normal) {
    if (frame.camera.camera.orthographic) {
        throw InputError("found an orthographic camera, expected a perspective one");
    }
    Surfaces s;
    s.camera = frame.camera;
    s.size = {depth.width, depth.height};
    s.tolerance = kTolerance * frame.diagonal();
    const reference::CameraRays rays(frame.camera, s.size);
    for (int y = 0; y < depth.height; ++y) {
        for (int x = 0; x < depth.width; ++x) {
            const reference::CameraRay ray =
                rays.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            s.depths.push_back(depth.at(x, y, 0));
            s.positions.push_back(ray.origin + ray.direction * s.depths.back());
            s.normals.emplace_back(normal.at(x, y, 0), normal.at(x, y, 1), normal.at(x, y, 2));
        }
    }
    return s;
}

PixelMask near_box(const Surfaces& surfaces, const Aabb& box, float metres) {
    PixelMask mask = surfaces.seen();
    for (std::size_t p = 0; p < mask.size(); ++p) {
        const vec3& x = surfaces.positions[p];
        const float distance = glm::length(x - glm::clamp(x, box.lower, box.upper));
        mask[p] = mask[p] != 0 && distance <= metres ? 1 : 0;
    }
    return mask;
}

SamePoints::SamePoints(const Surfaces& before, const Surfaces& now)
    : mask_(before.depths.size()), places_(before.depths.size()) {
    const mat3 axes = glm::transpose(mat3(now.camera.view));  // columns: the camera's axes in render space
    const vec2 size(now.size);
    const float half = std::tan(0.5f * now.camera.camera.y_fov);
    const vec2 halves(half * size.x / size.y, half);
    for (std::size_t p = 0; p < mask_.size(); ++p) {
        if (before.depths[p] <= 0) {
            continue;
        }
        const vec3 d = before.positions[p] - now.camera.position;
        const float ahead = -glm::dot(d, axes[2]);
        if (!(ahead > 0)) {
            continue;
        }
        const vec2 across = vec2(glm::dot(d, axes[0]), -glm::dot(d, axes[1])) / (ahead * halves);
        const vec2 at = 0.5f * (across + 1.0f) * size - 0.5f;  // 0: the centre of the first pixel
        const vec2 first = glm::floor(at), part = at - first;
        Place& place = places_[p];
        float sum = 0;
        bool same = true;
        for (int k = 0; k < 4; ++k) {
            const ivec2 step(k % 2, k / 2);
            const ivec2 xy = ivec2(first) + step;
            const float weight = (step.x == 1 ? part.x : 1 - part.x) * (step.y == 1 ? part.y : 1 - part.y);
            if (weight < kLeastWeight) {
                place.weight[k] = 0;
                place.pixel[k] = 0;
                continue;
            }
            const bool inside = xy.x >= 0 && xy.y >= 0 && xy.x < now.size.x && xy.y < now.size.y;
            const std::size_t q = inside ? static_cast<std::size_t>(xy.y * now.size.x + xy.x) : 0;
            same = same && inside && same_surface(before, p, now, q);
            place.pixel[k] = static_cast<std::uint32_t>(q);
            place.weight[k] = weight;
            sum += weight;
        }
        mask_[p] = same ? 1 : 0;
        for (float& weight : place.weight) {
            weight /= sum;
        }
    }
}

ImageF SamePoints::seen_from_before(const ImageF& image) const {
    ImageF result = image;
    std::ranges::fill(result.pixels, 0.0f);
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t p = 0; p < mask_.size(); ++p) {
        if (mask_[p] != 0) {
            for (int k = 0; k < 4; ++k) {
                for (std::size_t c = 0; c < channels; ++c) {
                    result.pixels[p * channels + c] +=
                        places_[p].weight[k] * image.pixels[places_[p].pixel[k] * channels + c];
                }
            }
        }
    }
    return result;
}

MeanProduct mean_product(const ImageF& a_now, const ImageF& a_before, const ImageF& b_now,
                         const ImageF& b_before, const PixelMask& mask) {
    double sum = 0, squares = 0, n = 0;
    const std::size_t pixels = a_now.pixels.size() / static_cast<std::size_t>(a_now.channels);
    for (std::size_t p = 0; p < pixels; ++p) {
        if (mask.empty() || mask[p] != 0) {
            const double product =
                mean3((colour(a_now, p) - colour(a_before, p)) * (colour(b_now, p) - colour(b_before, p)));
            sum += product;
            squares += product * product;
            ++n;
        }
    }
    return n == 0 ? MeanProduct{}
                  : MeanProduct{sum / n, std::max(squares / n - (sum / n) * (sum / n), 0.0) / n};
}

}  // namespace lanthorn::workbench
