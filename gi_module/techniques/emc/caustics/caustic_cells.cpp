#include "gi_module/techniques/emc/caustics/caustic_cells.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "gi_module/shared/rays/packed_normal.h"

namespace lanthorn::gi {

namespace {

constexpr int kMostSizes = 12;

// One hit in so many knows the irradiance; its disc, in splats.
constexpr std::size_t kSampled = 4;
constexpr float kGoodFor = 0.8f;
constexpr float kLeastTurn = 0.25f;  // caustic_kernel.glsl

// caustic_cells.glsl has the same.
std::uint32_t hash(const glm::ivec3& cell, int size) {
    auto x = static_cast<std::uint32_t>(cell.x) * 73856093u ^ static_cast<std::uint32_t>(cell.y) * 19349663u ^
             static_cast<std::uint32_t>(cell.z) * 83492791u ^ static_cast<std::uint32_t>(size) * 2654435769u;
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    return x;
}

// caustic_kernel.glsl.
vec3 irradiance(const PhotonHit& hit, const vec3& normal, const vec3& x, const vec3& n, float thin) {
    const float h2 = hit.radius * hit.radius;
    const vec3 d = hit.position - x;
    const float u = glm::dot(d, d) / h2;
    const float turn = glm::dot(normal, n);
    const bool inside =
        u < 1 && std::abs(0.5f * glm::dot(d, n + normal)) < 0.25f * hit.radius + thin && turn > kLeastTurn;
    return inside ? hit.power * ((1 - u) * (2 / kPi) / h2 * turn) : vec3(0);
}

}  // namespace

CausticCellTable CausticCellTable::of(std::span<const PhotonHit> hits) {
    CausticCellTable table;
    float widest = 0, narrowest = std::numeric_limits<float>::max();
    for (const PhotonHit& hit : hits) {
        widest = std::max(widest, hit.radius);
        narrowest = hit.radius > 0 ? std::min(narrowest, hit.radius) : narrowest;
    }
    if (!(widest > 0)) {
        return table;
    }
    // The widest splat's cell has its radius.
    table.sizes = std::clamp(1 + static_cast<int>(std::ceil(std::log2(widest / narrowest))), 1, kMostSizes);
    table.finest = widest * std::exp2(static_cast<float>(1 - table.sizes));
    table.slots = static_cast<std::uint32_t>(std::bit_ceil(std::max<std::size_t>(4 * hits.size(), 1024)));
    struct Entry {
        std::uint32_t slot, photon;
    };
    std::vector<Entry> entries;  // in order of photons
    entries.reserve(8 * hits.size());
    constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
    // By slot its newest photon, of which two cells may share the slot; where its list begins, and how long
    // it is.
    std::vector<std::uint32_t> newest(table.slots, kNone);
    table.words.assign(std::size_t{2} * table.slots, 0);
    for (std::uint32_t i = 0; i < hits.size(); ++i) {
        const PhotonHit& hit = hits[i];
        if (!(hit.radius > 0)) {
            continue;
        }
        const int size = std::clamp(static_cast<int>(std::ceil(std::log2(hit.radius / table.finest) - 1e-3f)),
                                    0, table.sizes - 1);
        const float side = table.finest * std::exp2(static_cast<float>(size));
        const float reach = hit.radius * 1.001f;
        const glm::ivec3 lower(glm::floor((hit.position - reach) / side));
        const glm::ivec3 upper(glm::floor((hit.position + reach) / side));
        for (int z = lower.z; z <= upper.z; ++z) {
            for (int y = lower.y; y <= upper.y; ++y) {
                for (int x = lower.x; x <= upper.x; ++x) {
                    const vec3 corner = vec3(x, y, z) * side;
                    const vec3 away =
                        glm::max(glm::max(corner - hit.position, hit.position - corner - side), vec3(0));
                    const std::uint32_t slot = hash({x, y, z}, size) & (table.slots - 1);
                    if (glm::dot(away, away) <= reach * reach && std::exchange(newest[slot], i) != i) {
                        entries.push_back({slot, i});
                        ++table.words[2 * std::size_t{slot} + 1];
                    }
                }
            }
        }
    }
    auto end = static_cast<std::uint32_t>(table.words.size());
    std::vector<std::uint32_t> next(table.slots);
    for (std::size_t slot = 0; slot < table.slots; ++slot) {
        const std::uint32_t count = table.words[2 * slot + 1];
        table.words[2 * slot] = count > 0 ? end : 0;
        next[slot] = end;
        end += count;
    }
    table.words.resize(end);
    for (const Entry& entry : entries) {
        table.words[next[entry.slot]++] = entry.photon;
    }
    return table;
}

std::uint32_t CausticCellTable::slot_of(const vec3& place, int size) const {
    const float side = finest * std::exp2(static_cast<float>(size));
    return hash(glm::ivec3(glm::floor(place / side)), size) & (slots - 1);
}

bool CausticCellTable::is_own(float radius, int size) const {
    const float side = finest * std::exp2(static_cast<float>(size));
    return radius <= 1.001f * side && (size == 0 || radius > 0.499f * side);
}

std::vector<PhotonHit> caustic_samples(std::span<const PhotonHit> hits, float thin) {
    const CausticCellTable table = CausticCellTable::of(hits);
    std::vector<vec3> normals;
    normals.reserve(hits.size());
    for (const PhotonHit& hit : hits) {
        normals.push_back(unpack_normal(hit.normal));
    }
    std::vector<PhotonHit> samples;
    for (std::size_t s = 0; s < hits.size(); s += kSampled) {
        PhotonHit sample = hits[s];
        sample.radius *= kGoodFor;
        sample.power = vec3(0);
        table.near(sample.position, [&](std::uint32_t i, int size) {
            if (table.is_own(hits[i].radius, size)) {
                sample.power += irradiance(hits[i], normals[i], sample.position, normals[s], thin);
            }
        });
        samples.push_back(sample);
    }
    return samples;
}

void CausticCells::sort(const CausticPhotons& photons, float thin) {
    if (photons.version() == version_) {
        return;
    }
    version_ = photons.version();
    const std::span<const PhotonHit> hits = photons.hits();
    std::vector<PhotonHit> samples = caustic_samples(hits.first(photons.straight_hits()), thin);
    straight_ = static_cast<int>(samples.size());
    const std::vector<PhotonHit> scattered = caustic_samples(hits.subspan(photons.straight_hits()), thin);
    samples.insert(samples.end(), scattered.begin(), scattered.end());
    table_ = CausticCellTable::of(samples);
    words_ = gpu::Buffer::from(table_.words);
    samples_ = gpu::Buffer::from(samples);
    table_.words = {};
}

void CausticCells::bind(const gpu::Program& program, GLuint first_unit) {
    words_view_.bind(first_unit, words_, GL_R32UI);
    samples_view_.bind(first_unit + 1, samples_, GL_RGBA32F);
    program.set("caustic_words", static_cast<int>(first_unit));
    program.set("caustic_samples", static_cast<int>(first_unit + 1));
    program.set("caustic_straight", straight_);
    program.set("caustic_slots", table_.slots);
    program.set("caustic_finest", table_.finest);
    program.set("caustic_sizes", table_.slots > 0 ? table_.sizes : 0);
}

}  // namespace lanthorn::gi
