#include "gi_module/techniques/emc/gather/close_hits.h"

#include <numeric>
#include <vector>

#include "gi_module/techniques/emc/gather/surface_points.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr std::size_t kWord = sizeof(std::uint32_t);
constexpr int kSlotsOfInvocation = 8;  // close_slots.comp
// close_free.glsl, in words.
constexpr std::size_t kBefore = 2, kLots = 3, kGroups = 4, kWanted = 8;
constexpr std::uint32_t kAllLots = 256;
constexpr std::size_t kFirstFree = kWanted + kAllLots;
// Lamps that a hit which no lit texel shows is held against.
constexpr std::size_t kMostLamps = 64;

// On the GPU.
void fill_words(const gpu::Buffer& buffer, std::size_t first, std::size_t words, std::uint32_t value) {
    glClearNamedBufferSubData(buffer.id(), GL_R32UI, static_cast<GLintptr>(first * kWord),
                              static_cast<GLsizeiptr>(words * kWord), GL_RED_INTEGER, GL_UNSIGNED_INT,
                              &value);
}

}  // namespace

void CloseHits::begin(const render::LightInputs& inputs, int first) {
    if (!points_) {
        slots_ = gpu::Program({"gi_module/techniques/emc/gather/close_slots.comp"});
        lots_ = gpu::Program({"gi_module/techniques/emc/gather/close_lots.comp"});
        const auto slots = static_cast<std::size_t>(count_);
        points_ = gpu::Buffer(slots * sizeof(vec4));
        owners_ = gpu::Buffer(slots * 2 * kWord);
        owners_.fill(0xffffffffu);
        std::vector<std::uint32_t> all(kFirstFree + slots);
        all[1] = static_cast<std::uint32_t>(count_);
        std::iota(all.begin() + kFirstFree, all.end(), 0u);
        free_ = gpu::Buffer::from(all);
        all_free_ = gpu::Buffer::from(all);
        listed_.resize(slots);
        lamp_places_ = gpu::Buffer(kMostLamps * sizeof(vec4));
    }
    first_ = first;
    lamps_.clear();
    for (const render::LightData& light : inputs.light_maps.light_data()) {
        if (light.layers != 0 && light.type != render::kLightDirectional &&
            light.type != render::kLightAreaSample && lamps_.size() < kMostLamps) {
            lamps_.emplace_back(light.position, 0);
        }
    }
    lamp_places_.write(0, std::span<const vec4>(lamps_));
}

void CloseHits::release() {
    owners_.fill(0xffffffffu);
    glCopyNamedBufferSubData(all_free_.id(), free_.id(), 0, 0, static_cast<GLsizeiptr>(free_.bytes()));
}

void CloseHits::bind(const gpu::Program& program, const gpu::Buffer& nearness, GLuint unit) {
    points_.bind_storage(10);
    owners_.bind_storage(11);
    free_.bind_storage(12);
    nearness_view_.bind(unit, nearness, GL_RGBA32F);
    lamps_view_.bind(unit + 1, lamp_places_, GL_RGBA32F);
    program.set("lit_nearness", static_cast<int>(unit));
    program.set("close_lamps", static_cast<int>(unit + 1));
    program.set("close_lamp_count", static_cast<int>(lamps_.size()));
    program.set("close_first", first_);
    program.set("close_every_hit", of_ == Of::every_hit ? 1 : 0);
}

void CloseHits::open() {
    glCopyNamedBufferSubData(free_.id(), free_.id(), 0, kBefore * kWord, kWord);
    fill_words(free_, kLots, 1, kAllLots);
    fill_words(free_, kWanted, kAllLots, 0);
}

void CloseHits::settle(const EntryList& first, const EntryList& left) {
    lots_.use();
    first.bind_storage(6);
    left.bind_storage(7);
    free_.bind_storage(12);
    glDispatchCompute(1, 1, 1);
    wait_for_shaders();
}

void CloseHits::dispatch_again() const {
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, free_.id());
    glDispatchComputeIndirect(kGroups * kWord);
}

void CloseHits::collect(const std::function<void(const gpu::Program&)>& use, std::size_t entries,
                        float origin_offset) {
    listed_.clear();
    fill_words(free_, 0, 2, 0);
    use(slots_);
    owners_view_.bind(0, owners_, GL_RG32UI);
    slots_.set("close_owners", 0);
    slots_.set("origin_offset", origin_offset);
    slots_.set("close_first", first_);
    slots_.set("slots", count_);
    slots_.set("entries", static_cast<int>(entries));
    points_.bind_storage(10);
    listed_.bind_storage(7);
    free_.bind_storage(12);
    dispatch_items(count_ / kSlotsOfInvocation);
    wait_for_shaders();
}

std::size_t CloseHits::bytes() const {
    return points_.bytes() + owners_.bytes() + free_.bytes() + all_free_.bytes() + listed_.bytes();
}

}  // namespace lanthorn::gi
