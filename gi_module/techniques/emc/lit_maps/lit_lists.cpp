#include "gi_module/techniques/emc/lit_maps/lit_lists.h"

#include <algorithm>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr int kCoarser = 4;  // lit texels a side of a coarse one
constexpr int kLeastCoarse = 8;
static_assert(kCoarser <= LitTexels::kBlock);

}  // namespace

void LitLists::resize(const LitTexels& texels, int rays) {
    if (!list_program_) {
        list_program_ = gpu::Program({"gi_module/techniques/emc/lit_maps/lit_lists.comp"});
        around_program_ = gpu::Program({"gi_module/techniques/emc/lit_maps/lit_around.comp"});
        fits_program_ = gpu::Program({"gi_module/techniques/emc/lit_maps/lit_fits.comp"});
    }
    resolution_ = std::max(kLeastCoarse, texels.resolution() / kCoarser);
    const int places = texels.faces() * resolution_ * resolution_;
    if (coarse_.capacity() == places && texel_resolution_ == texels.resolution()) {
        return;
    }
    texel_resolution_ = texels.resolution();
    lit_.resize(static_cast<std::size_t>(texels.places()));
    coarse_.resize(places, resolution_, rays);
    index_ = gpu::Buffer(static_cast<std::size_t>(places) * sizeof(std::uint32_t));
    given_ = gpu::Buffer(index_.bytes());
    held_ = gpu::Buffer((static_cast<std::size_t>(texels.blocks()) + 1) * sizeof(std::uint32_t));
    around_.resize(static_cast<std::size_t>(texels.blocks()));
    fits_ = gpu::Buffer(static_cast<std::size_t>(texels.places()) * sizeof(std::uint32_t));
    reached_.resize(static_cast<std::size_t>(places));
    marks_ = gpu::Buffer((words_of_bits(texels.blocks()) + words_of_bits(places)) * sizeof(std::uint32_t));
}

void LitLists::follow(const LitTexels& texels, const EnvironmentMaps& maps, const GiSettings& settings,
                      const FrameScene& scene, bool all, int rays) {
    resize(texels, rays);
    looks_ = all ? 0 : (looks_ + 1) % kWhole;
    list(texels, looks_ == 0);
    if (!all) {
        find_around(texels);
    }
    fit(texels, maps, settings, scene, all);
}

void LitLists::list(const LitTexels& texels, bool whole) {
    if (whole) {
        lit_.clear();
        coarse_.clear();
        held_.clear();
        given_.clear();
    }
    list_program_.use();
    texels.bind(list_program_, lit_points_view_, 0);
    list_program_.set("coarse_resolution", resolution_);
    list_program_.set("blocks", static_cast<unsigned>(texels.blocks()));
    list_program_.set("whole", whole ? 1 : 0);
    list_program_.set("rays", coarse_.rays());
    coarse_.bind_storage();
    held_.bind_storage(2);
    given_.bind_storage(4);
    texels.changed_blocks().bind_storage(5);
    index_.bind_storage(6);
    lit_.bind_storage(7);
    if (whole) {
        dispatch_items(texels.blocks());
    } else {
        texels.changed_blocks().dispatch();
    }
    wait_for_shaders();
}

void LitLists::find_around(const LitTexels& texels) {
    around_.clear();
    reached_.clear();
    marks_.clear();
    around_program_.use();
    texels.bind(around_program_, lit_points_view_, 0);
    around_program_.set("coarse_resolution", resolution_);
    around_program_.set("first_coarse", static_cast<unsigned>(words_of_bits(texels.blocks())));
    reached_.bind_storage(4);
    marks_.bind_storage(5);
    texels.changed_blocks().bind_storage(6);
    around_.bind_storage(7);
    texels.changed_blocks().dispatch();
    wait_for_shaders();
}

void LitLists::fit(const LitTexels& texels, const EnvironmentMaps& maps, const GiSettings& settings,
                   const FrameScene& scene, bool all) {
    fits_program_.use();
    maps.bind(fits_program_, 0, 1, settings, scene);
    texels.bind(fits_program_, lit_points_view_, 2);
    index_view_.bind(3, index_, GL_R32UI);
    points_view_.bind(4, coarse_.points(), GL_RGBA32F);
    fits_program_.set("coarse_index", 3);
    fits_program_.set("coarse_points", 4);
    fits_program_.set("coarse_resolution", resolution_);
    fits_.bind_storage(4);
    around_.bind_storage(6);
    fits_program_.set("blocks", all ? static_cast<unsigned>(texels.blocks()) : 0u);
    if (all) {
        dispatch_items(texels.places());
    } else {
        around_.dispatch();
    }
    wait_for_shaders();
}

std::uint32_t LitLists::lit_count() const {
    if (!held_) {
        return 0;
    }
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    return held_.read<std::uint32_t>(1, held_.bytes() - sizeof(std::uint32_t)).front();
}

std::size_t LitLists::bytes() const {
    return lit_.bytes() + index_.bytes() + held_.bytes() + given_.bytes() + around_.bytes() +
           reached_.bytes() + marks_.bytes() + fits_.bytes();
}

}  // namespace lanthorn::gi
