#include "gi_module/techniques/emc/maps/unseen_places.h"

#include <cstring>
#include <vector>

#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr int kTiles = 16;  // a side of the picture

struct Tile {  // unseen_places.comp
    vec4 start, place, reserved_start, reserved_place, counts;
};
static_assert(sizeof(Tile) == 80);

constexpr std::size_t kTileBytes = kTiles * kTiles * sizeof(Tile);

}  // namespace

void UnseenPlaces::prepare() {
    if (!program_) {
        program_ = gpu::Program({"gi_module/techniques/emc/maps/unseen_places.comp"});
        tiles_ = gpu::Buffer(kTileBytes);
        found_tiles_.reserve(kTileBytes);
        lit_points_view_.bind(2, tiles_, GL_RGBA32F);  // makes it; find() has it look at something else
    }
}

void UnseenPlaces::find(RememberedHits& hits, ivec2 grid, const RayScene& rays) {
    prepare();
    hits.bind(program_);
    rays.maps.bind(program_, 0, 1, rays.settings, rays.scene);
    rays.texels.bind(program_, lit_points_view_, 2);
    program_.set("grid", grid);
    program_.set("tile_size", (grid + kTiles - 1) / kTiles);
    tiles_.bind_storage(1);
    glDispatchCompute(kTiles, kTiles, 1);
    wait_for_shaders();
    forget();
    found_tiles_.begin(tiles_, kTileBytes, 0);
    found_ = true;
}

void UnseenPlaces::forget() {
    found_ = false;
    while (found_tiles_.wait()) {
    }
}

UnseenSurvey UnseenPlaces::take() {
    found_ = false;
    UnseenSurvey survey;
    std::vector<Tile> tiles(kTiles * kTiles);
    if (const auto arrived = found_tiles_.wait()) {
        std::memcpy(tiles.data(), arrived->bytes.data(), arrived->bytes.size());
    }
    for (const Tile& tile : tiles) {
        survey.rays += static_cast<double>(tile.counts.x);
        survey.unknown += static_cast<double>(tile.counts.w);
        survey.blind += static_cast<std::uint64_t>(tile.counts.y);
        survey.points += static_cast<std::uint64_t>(tile.counts.z);
        if (tile.start.w > 0 && tile.place.w == 0.0f) {
            survey.places.push_back({tile.start, tile.place, tile.start.w});
            survey.unseen += static_cast<double>(tile.start.w);
        }
        if (tile.reserved_start.w > 0) {
            survey.places.push_back({tile.reserved_start, tile.reserved_place, tile.reserved_start.w});
        }
    }
    return survey;
}

}  // namespace lanthorn::gi
