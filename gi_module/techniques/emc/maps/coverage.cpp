#include "gi_module/techniques/emc/maps/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

#include "gi_module/shared/cube_direction.h"

namespace lanthorn::gi {

namespace {

// Of a viewer, each of so many pixels: coverage.comp.
constexpr int kPixels = 8;
constexpr int kSums = 6 * kCoverageResolution * kCoverageResolution / kPixels;
constexpr int kInvocations = 64;  // a work group
constexpr int kLeaves = 8;        // that are added up as a tree
static_assert(kSums % kInvocations == 0 && kSums % kLeaves == 0);

void write(gpu::Buffer& buffer, const std::vector<int>& numbers) {
    if (buffer.bytes() < numbers.size() * sizeof(int) || !buffer) {
        buffer = gpu::Buffer(2 * numbers.size() * sizeof(int));
    }
    buffer.write(0, std::span<const int>(numbers));
}

vec4 added(const vec4& a, const vec4& b) {
    return {vec3(a) + vec3(b), std::min(a.w, b.w)};
}

vec4 added_as_a_tree(std::span<const vec4, kLeaves> leaves) {
    std::array<vec4, kLeaves> sums{};
    std::ranges::copy(leaves, sums.begin());
    for (std::size_t width = kLeaves / 2; width > 0; width /= 2) {
        for (std::size_t i = 0; i < width; ++i) {
            sums[i] = added(sums[i], sums[i + width]);
        }
    }
    return sums[0];
}

// What each viewer's invocations have found.
std::vector<Coverage> added_up(const std::vector<vec4>& sums) {
    std::vector<Coverage> result(sums.size() / kSums);
    for (std::size_t v = 0; v < result.size(); ++v) {
        double backs = 0;
        double hits = 0;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = v * kSums; i < (v + 1) * kSums; i += kLeaves) {
            const vec4 s = added_as_a_tree(std::span<const vec4, kLeaves>(&sums[i], kLeaves));
            result[v].area += s.x;
            backs += s.y;
            hits += s.z;
            nearest = s.z > 0 ? std::min(nearest, static_cast<double>(s.w)) : nearest;
        }
        result[v].back_share = hits > 0 ? backs / hits : 0;
        result[v].seen_share = hits / (4.0 * kPi);
        result[v].min_distance = nearest;
    }
    return result;
}

}  // namespace

CoverageMeter::CoverageMeter()
    : program_({"gi_module/techniques/emc/maps/coverage.comp"}),
      places_program_({"gi_module/techniques/emc/maps/coverage_places.comp"}) {}

void CoverageMeter::place(const std::vector<vec3>& centres) {
    const int count = static_cast<int>(centres.size());
    if (!maps_ || maps_->maps().slots() != count) {
        maps_.emplace(MapUse::coverage, count, kCoverageResolution);
        placed_.clear();
        // No more room than so many need.
        viewers_ = gpu::Buffer();
        selected_ = gpu::Buffer();
        partial_ = gpu::Buffer();
    }
    if (placed_ != centres) {
        std::vector<vec4> padded;
        for (int i = 0; i < count; ++i) {
            maps_->place(i, centres[static_cast<std::size_t>(i)]);
            padded.emplace_back(centres[static_cast<std::size_t>(i)], 0.0f);
        }
        centres_ = gpu::Buffer::from(padded);
        placed_ = centres;
    }
}

void CoverageMeter::move(int candidate, const vec3& centre) {
    const auto i = static_cast<std::size_t>(candidate);
    if (placed_[i] != centre) {
        placed_[i] = centre;
        maps_->place(candidate, centre);
        const vec4 padded(centre, 0.0f);
        centres_.write_bytes(i * sizeof(vec4), &padded, sizeof(padded));
    }
}

void CoverageMeter::draw(const FrameScene& scene, const render::GpuScene& gpu_scene,
                         const std::vector<int>& candidates, int look) {
    maps_->update(scene, gpu_scene, candidates, look, sight_);
}

std::vector<Sight> CoverageMeter::sights() const {
    const std::vector<float> planes = maps_->maps().planes().read_floats(4);
    constexpr std::size_t kSide = kCoverageResolution, kTexels = 6 * kSide * kSide;
    std::vector<Sight> result(placed_.size());
    for (std::size_t i = 0; i < kTexels * placed_.size(); ++i) {
        const float distance = std::abs(planes[4 * i + 3]);
        if (distance > 0) {
            const vec2 uv = (vec2(i % kSide, i / kSide % kSide) + 0.5f) / static_cast<float>(kSide);
            const vec3 d = cube_direction(static_cast<int>(i / (kSide * kSide) % 6), 2.0f * uv - 1.0f);
            const float l = glm::length(d);
            result[i / kTexels].push_back(
                {d / l, distance, 4 / (static_cast<float>(kSide * kSide) * l * l * l)});
        }
    }
    return result;
}

void CoverageMeter::use(const gpu::Program& program) const {
    program.use();
    program.set("candidate_planes", 0);
    program.set("resolution", kCoverageResolution);
    maps_->maps().planes().bind(0);
    centres_.bind_storage(0);
}

std::vector<std::vector<bool>> CoverageMeter::sees(const std::vector<int>& viewers,
                                                   const std::vector<UnseenPlace>& places) {
    std::vector<vec4> rays;
    for (const UnseenPlace& p : places) {
        rays.emplace_back(p.place, 0.0f);
        rays.emplace_back(p.start, 0.0f);
    }
    const gpu::Buffer viewer_buffer = gpu::Buffer::from(viewers);
    const gpu::Buffer place_buffer = gpu::Buffer::from(rays);
    const gpu::Buffer seen(viewers.size() * places.size() * sizeof(std::uint32_t));
    use(places_program_);
    places_program_.set("place_count", static_cast<int>(places.size()));
    viewer_buffer.bind_storage(1);
    place_buffer.bind_storage(2);
    seen.bind_storage(3);
    glDispatchCompute((static_cast<GLuint>(places.size()) + 63) / 64, static_cast<GLuint>(viewers.size()), 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    const std::vector<std::uint32_t> flags = seen.read<std::uint32_t>(viewers.size() * places.size());
    std::vector<std::vector<bool>> result;
    for (auto of = flags.begin(); of != flags.end(); of += static_cast<std::ptrdiff_t>(places.size())) {
        result.emplace_back(of, of + static_cast<std::ptrdiff_t>(places.size()));
    }
    return result;
}

void CoverageMeter::sum(const std::vector<int>& viewers, const std::vector<int>& selected) {
    write(viewers_, viewers);
    write(selected_, selected);
    const std::size_t bytes = viewers.size() * kSums * sizeof(vec4);
    if (partial_.bytes() < bytes) {
        partial_ = gpu::Buffer(bytes);
    }
    use(program_);
    program_.set("selected_count", static_cast<int>(selected.size()));
    program_.set("reach", std::isfinite(reach_) ? reach_ : std::numeric_limits<float>::max());
    viewers_.bind_storage(1);
    selected_.bind_storage(2);
    partial_.bind_storage(3);
    glDispatchCompute(kSums / kInvocations, static_cast<GLuint>(viewers.size()), 1);
}

std::vector<Coverage> CoverageMeter::measure(const std::vector<int>& viewers,
                                             const std::vector<int>& selected) {
    sum(viewers, selected);
    return added_up(partial_.read<vec4>(viewers.size() * kSums));
}

void CoverageMeter::ask(const std::vector<int>& viewers, const std::vector<int>& selected) {
    sum(viewers, selected);
    answers_.begin(partial_, viewers.size() * kSums * sizeof(vec4), 0);
}

std::vector<Coverage> CoverageMeter::take() {
    const std::optional<gpu::ReadBack::Arrived> arrived = answers_.wait();
    std::vector<vec4> sums(arrived ? arrived->bytes.size() / sizeof(vec4) : 0);
    if (arrived) {
        std::memcpy(sums.data(), arrived->bytes.data(), sums.size() * sizeof(vec4));
    }
    return added_up(sums);
}

void CoverageMeter::forget() {
    while (answers_.wait()) {
    }
}

bool in_the_open(const Coverage& coverage, float diagonal, double clearance) {
    return coverage.seen_share > 0 && coverage.back_share < 0.05 &&
           coverage.min_distance > clearance * static_cast<double>(diagonal);
}

}  // namespace lanthorn::gi
