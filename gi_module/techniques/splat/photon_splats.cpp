#include "gi_module/techniques/splat/photon_splats.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "lanthorn/gi/passes.h"
#include "lanthorn/gpu/context.h"

namespace lanthorn::gi {

namespace {

// Of a tile in a dispatch: Mesa's llvmpipe ends an invocation's loops, silently, after 65535 turns in all,
// and each of an entry's 64 photons takes up to ten.
constexpr std::uint32_t kMostOfTile = 96;
constexpr std::size_t kMostGroups = 65535;  // of a dispatch along an axis: what OpenGL promises

// The tiles about the open ones too: the oracle compares with their photons.
constexpr int kBeside = 2;
std::vector<std::uint32_t> with_neighbours(std::span<const std::uint32_t> open, ivec2 tiles) {
    std::vector<std::uint32_t> result(open.size(), 0);
    const auto at = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(tiles.x) + static_cast<std::size_t>(x);
    };
    for (int y = 0; y < tiles.y; ++y) {
        for (int x = 0; x < tiles.x; ++x) {
            if (open[at(x, y)] == 0) {
                continue;
            }
            for (int v = std::max(y - kBeside, 0); v <= std::min(y + kBeside, tiles.y - 1); ++v) {
                for (int u = std::max(x - kBeside, 0); u <= std::min(x + kBeside, tiles.x - 1); ++u) {
                    result[at(u, v)] = 1;
                }
            }
        }
    }
    return result;
}

// Grows with what is written, never shrinks.
template <class T>
void put(gpu::Buffer& buffer, std::span<const T> data) {
    if (buffer.bytes() < data.size_bytes() || !buffer) {
        buffer = gpu::Buffer(data.size_bytes() + data.size_bytes() / 4);
    }
    buffer.write(0, data);
}

// Software rasterisers run eight invocations as one; one of theirs with eight pixels fetches a photon once.
int lanes() {
    return gpu::draws_in_software() ? 8 : 64;
}

}  // namespace

const gpu::Texture* PhotonSplats::draw(const PictureSurfaces& picture, const SplatSurfaces& surfaces,
                                       PhotonCollection& photons, std::span<const vec3> powers,
                                       const SplatSettings& settings, reference::TileWorkers& workers) {
    counts_ = {};
    if (!splat_ || kernel_ != settings.kernel) {
        kernel_ = settings.kernel;
        lanes_ = lanes();
        splat_ =
            gpu::Program({"gi_module/techniques/splat/splat.comp"},
                         {"LANES " + std::to_string(lanes_),
                          std::string("EPANECHNIKOV ") + (kernel_ == PhotonKernel::constant ? "0" : "1")});
        resolve_ = gpu::Program({"gi_module/techniques/splat/resolve.comp"});
        photons_ = gpu::Buffer(SplatStore::kMostRecords * sizeof(PhotonRecord));
        bad_ = gpu::Buffer(sizeof(std::uint32_t));
    }
    if (!sums_ || ivec2(sums_.size()) != picture.size()) {
        sums_ = gpu::Texture::make_2d(GL_RGBA32F, picture.size());
        irradiance_ = gpu::Texture::make_2d(GL_RGBA32F, picture.size());
        decided_ = gpu::Texture::make_2d(GL_R32UI, picture.size());
    }
    put(pixels_, picture.pixels());
    std::vector<vec4> of_groups;
    for (const vec3& power : powers) {
        of_groups.emplace_back(power, 0.0f);
    }
    put(powers_, std::span<const vec4>(of_groups));
    irradiance_.clear(vec4(0));
    bad_.clear();
    for (const bool caustic : {false, true}) {
        if (photons.all(caustic) > 0 && !draw_kind(caustic, picture, surfaces, photons, settings, workers)) {
            return nullptr;
        }
    }
    counts_.bad = bad_.read<std::uint32_t>(1).front();
    return &irradiance_;
}

bool PhotonSplats::draw_kind(bool caustic, const PictureSurfaces& picture, const SplatSurfaces& surfaces,
                             PhotonCollection& photons, const SplatSettings& settings,
                             reference::TileWorkers& workers) {
    const GLuint none = 0;
    glClearTexImage(decided_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
    const ivec2 tiles = picture.tiles();
    std::vector<std::uint32_t> open(static_cast<std::size_t>(tiles.x * tiles.y), 1);
    const bool adapts =
        settings.adaptive == SplatAdaptive::all || (settings.adaptive == SplatAdaptive::caustics && caustic);
    const int levels = adapts ? settings.levels : 1;
    float c = caustic ? settings.caustic_bandwidth : settings.bandwidth;
    for (int level = 0; level < levels; ++level, c *= 0.75f) {  // "reduced by one quarter" (sec. 4.2)
        ++counts_.rounds;
        const std::vector<float> h = bandwidths(surfaces, photons.photons(caustic), c);
        sums_.clear(vec4(0));
        const std::vector<std::uint32_t> splatted = with_neighbours(open, tiles);
        const bool read = photons.store().each([&](const RecordRun& run) {
            if (run.caustic == caustic) {
                add_run(run, picture, h, splatted, workers);
            }
        });
        if (!read) {
            return false;
        }
        const std::vector<float> areas =
            inverse_kernel_areas(picture, surfaces, h, settings.kernel, settings.boundaries, open, workers);
        resolve(picture, h, areas, splatted, settings, level + 1 == levels);
        if (level + 1 < levels) {
            open = open_.read<std::uint32_t>(open.size());
            if (std::ranges::none_of(open, [](std::uint32_t tile) { return tile != 0; })) {
                break;
            }
        }
    }
    return true;
}

void PhotonSplats::add_run(const RecordRun& run, const PictureSurfaces& picture, std::span<const float> h,
                           std::span<const std::uint32_t> open, reference::TileWorkers& workers) {
    counts_.splatted += run.records.size();
    put(photons_, std::span<const PhotonRecord>(run.records));
    for (std::span<const PhotonBlock> left = run.blocks; !left.empty();) {
        const std::size_t now = blocks_at_once(left, picture, kMostEntries);
        add_lists(splat_lists(left.first(now), picture, h, open, workers), picture);
        left = left.subspan(now);
    }
}

void PhotonSplats::add_lists(const SplatLists& lists, const PictureSurfaces& picture) {
    counts_.entries += lists.entries.size();
    if (lists.entries.empty()) {
        return;
    }
    put(entries_, std::span<const SplatEntry>(lists.entries));
    splat_.use();
    photon_texels_.bind(0, photons_, GL_RGBA32UI);
    entry_texels_.bind(1, entries_, GL_RGBA32UI);
    pixel_texels_.bind(3, pixels_, GL_RGBA32UI);
    power_texels_.bind(4, powers_, GL_RGBA32F);
    splat_.set("photons", 0);
    splat_.set("entries", 1);
    splat_.set("tiles", 2);
    splat_.set("pixels", 3);
    splat_.set("image_size", picture.size());
    splat_.set("tiles_across", picture.tiles().x);
    splat_.set("powers", 4);
    sums_.bind_image(0, GL_READ_WRITE);
    for (std::uint32_t done = 0;; done += kMostOfTile) {
        std::vector<glm::uvec4> tiles;
        for (std::uint32_t t = 0; t + 1 < lists.firsts.size(); ++t) {
            const std::uint32_t first = lists.firsts[t] + done;
            if (first < lists.firsts[t + 1]) {
                tiles.emplace_back(t, first, std::min(first + kMostOfTile, lists.firsts[t + 1]), 0u);
            }
        }
        if (tiles.empty()) {
            return;
        }
        put(tiles_, std::span<const glm::uvec4>(tiles));
        tile_texels_.bind(2, tiles_, GL_RGBA32UI);
        for (std::size_t begin = 0; begin < tiles.size(); begin += kMostGroups) {
            const int groups = static_cast<int>(std::min(tiles.size() - begin, kMostGroups));
            splat_.set("first_tile", static_cast<int>(begin));
            splat_.dispatch(ivec2(groups * lanes_, 1), ivec2(lanes_, 1));
        }
        wait_for_shaders();
    }
}

void PhotonSplats::resolve(const PictureSurfaces& picture, std::span<const float> h,
                           std::span<const float> areas, std::span<const std::uint32_t> splatted,
                           const SplatSettings& settings, bool last) {
    const ivec2 tiles = picture.tiles();
    const std::size_t bytes = static_cast<std::size_t>(tiles.x * tiles.y) * sizeof(std::uint32_t);
    if (!open_ || open_.bytes() < bytes) {
        open_ = gpu::Buffer(bytes);
    }
    open_.clear();
    put(areas_, areas);
    put(bandwidths_, h);
    put(splatted_, splatted);
    resolve_.use();
    sums_.bind(0);
    area_texels_.bind(1, areas_, GL_R32F);
    pixel_texels_.bind(2, pixels_, GL_RGBA32UI);
    bandwidth_texels_.bind(3, bandwidths_, GL_R32F);
    splatted_texels_.bind(4, splatted_, GL_R32UI);
    resolve_.set("splatted", 4);
    resolve_.set("sums", 0);
    resolve_.set("inverse_areas", 1);
    resolve_.set("pixels", 2);
    resolve_.set("bandwidths", 3);
    resolve_.set("image_size", picture.size());
    resolve_.set("tiles_across", tiles.x);
    resolve_.set("last_level", last ? 1 : 0);
    resolve_.set("least", static_cast<float>(settings.least));
    resolve_.set("most", static_cast<float>(settings.most));
    resolve_.set("bias", settings.bias);
    irradiance_.bind_image(0, GL_READ_WRITE);
    decided_.bind_image(1, GL_READ_WRITE);
    open_.bind_storage(0);
    bad_.bind_storage(1);
    resolve_.dispatch(picture.size(), ivec2(8));
    wait_for_shaders();
}

}  // namespace lanthorn::gi
