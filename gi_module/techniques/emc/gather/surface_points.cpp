#include "gi_module/techniques/emc/gather/surface_points.h"

#include <algorithm>
#include <cstddef>

#include "engine/gpu/pass_end.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

// A software rasteriser takes a few microseconds a group.
constexpr std::uint32_t kGroup = 256;
constexpr std::uint32_t kRow = 16384;  // work_items.glsl
constexpr int kItemsAtOnce = 1 << 15;  // between two answers to a window's user; a multiple of kGroup

struct Header {
    std::uint32_t count = 0;
    std::uint32_t point_groups[3] = {0, 1, 1};
    std::uint32_t ray_groups[3] = {0, 1, 1};
};
constexpr GLintptr kPointGroups = offsetof(Header, point_groups);
constexpr GLintptr kRayGroups = offsetof(Header, ray_groups);
static_assert(sizeof(Header) == 28 && kPointGroups == 4 && kRayGroups == 16);

void set_groups(std::uint32_t (&groups)[3], std::uint32_t items) {
    const std::uint32_t all = (items + kGroup - 1) / kGroup;
    groups[0] = std::min(all, kRow);
    groups[1] = std::max((all + kRow - 1) / kRow, 1u);
}

void dispatch_indirect(const gpu::Buffer& header, GLintptr offset) {
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, header.id());
    glDispatchComputeIndirect(offset);
}

}  // namespace

void SurfacePoints::resize(int capacity, int row, int rays) {
    const auto places = static_cast<std::size_t>(capacity);
    if (capacity != capacity_) {
        header_ = gpu::Buffer(sizeof(Header));
        points_ = gpu::Buffer(places * sizeof(vec4));
        keys_ = gpu::Buffer(places * sizeof(std::uint32_t));
    }
    capacity_ = capacity;
    row_ = row;
    rays_ = rays;
    clear();
}

void SurfacePoints::clear() {
    const Header none;
    header_.write_bytes(0, &none, sizeof(none));
}

void SurfacePoints::fill(int count) {
    Header all;
    all.count = static_cast<std::uint32_t>(count);
    set_groups(all.point_groups, all.count);
    set_groups(all.ray_groups, all.count * static_cast<std::uint32_t>(rays_));
    header_.write_bytes(0, &all, sizeof(all));
}

void SurfacePoints::bind_storage() const {
    header_.bind_storage(0);
    points_.bind_storage(1);
    keys_.bind_storage(3);
}

void SurfacePoints::dispatch() const {
    dispatch_indirect(header_, kPointGroups);
}

void SurfacePoints::dispatch_rays() const {
    dispatch_indirect(header_, kRayGroups);
}

std::uint32_t SurfacePoints::count() const {
    if (capacity_ == 0) {
        return 0;
    }
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    return header_.read<std::uint32_t>(1).front();
}

void dispatch_items(int count) {
    std::uint32_t groups[3] = {0, 1, 1};
    set_groups(groups, static_cast<std::uint32_t>(count));
    glDispatchCompute(groups[0], groups[1], 1);
}

void dispatch_in_parts(const gpu::Program& program, int count) {
    const int some = gpu::PassEnd::is_heard() ? kItemsAtOnce : std::max(count, 1);
    for (int first = 0; first < count; first += some) {
        program.set("first_item", first);
        dispatch_items(std::min(some, count - first));
        wait_for_shaders();
        gpu::PassEnd::tell();
    }
}

void dispatch_rows(int keys, int rows) {
    glDispatchCompute((static_cast<GLuint>(keys) + kGroup - 1) / kGroup, static_cast<GLuint>(rows), 1);
}

}  // namespace lanthorn::gi
