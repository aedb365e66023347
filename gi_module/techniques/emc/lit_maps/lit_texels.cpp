#include "gi_module/techniques/emc/lit_maps/lit_texels.h"

#include <algorithm>
#include <string>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

// Of EnvironmentMaps::extent(), that boxes are widened by against rounding.
constexpr float kTexelMargin = 2e-5f;

}  // namespace

bool LitTexels::resize(const EnvironmentMaps& maps, const GiSettings& settings) {
    const int resolution = std::max(
        16,
        std::min(settings.of<EmcSettings>().gather_texels, settings.of<EmcSettings>().resolution) / 16 * 16);
    const int faces = 6 * maps.slots();
    if (resolution == resolution_ && faces == faces_) {
        return false;
    }
    if (faces != faces_) {
        program_ = gpu::Program({"gi_module/techniques/emc/lit_maps/lit_texels.comp"},
                                {"MAPS " + std::to_string(maps.slots())});
    }
    resolution_ = resolution;
    faces_ = faces;
    const auto texels = static_cast<std::size_t>(places());
    points_ = gpu::Buffer(2 * texels * sizeof(vec4));
    albedo_ = gpu::Buffer(texels * sizeof(vec4));
    static_assert(kSkyPlaces % 32 == 0 && CloseHits::kAllSlots % 32 == 0);  // as a face's texels
    changed_ = gpu::Buffer((static_cast<std::size_t>(changed_places()) + words_of_bits(blocks())) *
                           sizeof(std::uint32_t));
    sharper_ = gpu::Buffer(static_cast<std::size_t>(blocks()) * 2 * sizeof(std::uint32_t));
    listed_.resize(static_cast<std::size_t>(blocks()));
    changed_blocks_.resize(static_cast<std::size_t>(blocks()));
    return true;
}

void LitTexels::look(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene,
                     const SweptBoxes& movers, bool all, const ivec2& exchanged, const gpu::Buffer& radiosity,
                     const gpu::Buffer& first) {
    if (!all_) {
        all_ = gpu::Program({"gi_module/techniques/emc/lit_maps/lit_touched.comp"}, {"ALL 1", "BOXES 1"});
    }
    changed_.clear();
    listed_.clear();
    changed_blocks_.clear();
    if (all) {
        all_.use();
    }
    const gpu::Program& touched =
        all ? all_ : touched_.use(movers.boxes(), kTexelMargin * maps.extent(scene));
    maps.bind(touched, 0, 1, settings, scene);
    bind(touched, points_view_, 2);
    if (!all) {
        touched.set("exchanged", exchanged);
    }
    sharper_.bind_storage(6);
    listed_.bind_storage(7);
    dispatch_items(blocks());
    wait_for_shaders();
    program_.use();
    maps.bind(program_, 0, 1, settings, scene);
    bind(program_, points_view_, 2);
    points_.bind_storage(1);
    albedo_.bind_storage(2);
    changed_.bind_storage(3);
    radiosity.bind_storage(4);
    first.bind_storage(5);
    listed_.bind_storage(6);
    sharper_.bind_storage(0);
    program_.set("changed_blocks", static_cast<unsigned>(changed_places()));
    program_.set("mark_changed", all ? 0 : 1);
    listed_.dispatch();
    wait_for_shaders();
    if (!all) {
        list_changed_blocks();
    }
}

void LitTexels::list_changed_blocks() {
    if (!list_blocks_) {
        list_blocks_ = gpu::Program({"gi_module/techniques/emc/lit_maps/lit_changed_blocks.comp"});
    }
    const std::size_t words = words_of_bits(blocks());
    list_blocks_.use();
    list_blocks_.set("first_word", static_cast<unsigned>(changed_places()));
    list_blocks_.set("words", static_cast<unsigned>(words));
    changed_.bind_storage(3);
    changed_blocks_.bind_storage(7);
    dispatch_items(static_cast<int>(words));
    wait_for_shaders();
}

void LitTexels::recolour(const EnvironmentMaps& maps, const GiSettings& settings, const FrameScene& scene,
                         const EntryList& lit) {
    if (!recolour_) {
        recolour_ = gpu::Program({"gi_module/techniques/emc/lit_maps/lit_recolour.comp"});
    }
    recolour_.use();
    maps.bind(recolour_, 0, 1, settings, scene);
    bind(recolour_, points_view_, 2);
    albedo_.bind_storage(2);
    lit.bind_storage(6);
    lit.dispatch();
    wait_for_shaders();
}

void LitTexels::bind(const gpu::Program& program, gpu::BufferTexture& points, GLuint unit) const {
    points.bind(unit, points_, GL_RGBA32F);
    program.set("lit_points", static_cast<int>(unit));
    program.set("lit_resolution", resolution_);
    program.set("lit_sheets", places());
    program.set("sky_first", places());
}

}  // namespace lanthorn::gi
