#include "gi_module/techniques/emc/gather/still_gather.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "engine/gpu/pass_end.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

// The gathered picture errs about as much as the filtered mean of so many rays a pixel.
constexpr double kFirstRays = 48;

constexpr int kFadeFrames = 8;

// Of its own rays, beside the gathered picture: of few less than their number says, since the filter, which
// stops at what differs by more than their noise, then leaves bright ones out (2 % of the light at 18 rays).
double own_weight(double rays) {
    return rays * rays / (rays * rays + kFirstRays * kFirstRays);
}

constexpr int kFewestPasses = 4;  // behind a picture, and between two
constexpr int kPassesOver = 8;    // between two pictures, of those that there are: an eighth to a sixteenth

// What the two levels of the narrow filter divide noise by, where light is even.
constexpr double kFilteredPixels = 9;

// The pass's pixel in a cell of stride x stride pixels: all of them in turn, near ones far apart in time.
ivec2 pixel_of(int pass, int stride) {
    const int pixels = stride * stride;
    int step = 2 * pixels / 3 + 1;
    while (std::gcd(step, pixels) != 1) {
        ++step;
    }
    const int k = (pass - 1) % pixels * step % pixels;
    return {k % stride, k / stride};
}

// Pixels between those of a pass: as in the gather's grid, or more, so that every hit has a slot of its own.
int stride_of(ivec2 size, const EmcSettings& settings) {
    int stride = settings.gather_grid;
    const auto hits = [&] {
        const ivec2 grid = (size + stride - 1) / stride;
        return static_cast<std::int64_t>(grid.x) * grid.y * settings.gather_rays;
    };
    while (hits() > CloseHits::kStillSlots && stride < std::max(size.x, size.y)) {
        ++stride;
    }
    return stride;
}

}  // namespace

void StillGather::begin(const render::FrameInputs& inputs, const RayScene& rays) {
    if (!surfaces_program_) {
        surfaces_program_ = gpu::Program({"gi_module/techniques/emc/gather/still_surfaces.comp"});
        points_program_ = gpu::Program({"gi_module/techniques/emc/gather/still_points.comp"});
        mean_program_ = gpu::Program({"gi_module/techniques/emc/gather/still_mean.comp"});
        show_program_ = gpu::Program({"gi_module/techniques/emc/gather/still_show.comp"});
        fade_program_ = gpu::Program({"gi_module/techniques/emc/gather/still_fade.comp"});
    }
    const ivec2 size = inputs.gbuffer.size();
    if (size != size_) {
        const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
        surfaces_ = gpu::Buffer(pixels * sizeof(vec4));
        mean_ = gpu::Buffer(pixels * sizeof(vec4));
        known_ = gpu::Buffer(pixels * sizeof(float));
        picture_ = gpu::Texture::make_2d(GL_RGBA32F, size);
        corrections_ = gpu::Texture::make_2d(GL_RGBA16F, size);
    }
    size_ = size;
    stride_ = stride_of(size, rays.settings.of<EmcSettings>());
    grid_ = (size + stride_ - 1) / stride_;
    use_surfaces(surfaces_program_, inputs);
    surfaces_.bind_storage(4);
    mean_.bind_storage(5);
    known_.bind_storage(6);
    dispatch_items(size.x * size.y);
    wait_for_shaders();
    gpu::PassEnd::tell();
    links_.find(inputs, rays.maps, rays.settings, surfaces_, size);
}

void StillGather::place(const render::FrameInputs& inputs, int pass) {
    offset_ = pixel_of(pass, stride_);
    use_surfaces(points_program_, inputs);
    points_program_.set("stride", stride_);
    points_program_.set("grid", grid_);
    points_program_.set("offset", offset_);
    points_program_.set("rays", points_.rays());
    points_.bind_storage();
    dispatch_items(points_.capacity());
    wait_for_shaders();
}

void StillGather::add(const gpu::Buffer& irradiance) {
    mean_program_.use();
    irradiance_view_.bind(0, irradiance, GL_RGBA32F);
    rays_view_.bind(1, hits_.known(), GL_R32F);
    mean_program_.set("irradiance", 0);
    mean_program_.set("rays", 1);
    mean_program_.set("stride", stride_);
    mean_program_.set("grid", grid_);
    mean_program_.set("offset", offset_);
    mean_program_.set("image_size", size_);
    points_.bind_storage();
    mean_.bind_storage(5);
    known_.bind_storage(6);
    points_.dispatch();
    wait_for_shaders();
}

void StillGather::show(const gpu::Texture& first, double rays) {
    shown_rays_ = rays;
    const gpu::Buffer& filtered =
        filter_.run({size_, surfaces_, mean_, known_, links_.cuts()}, {.narrow = 1});
    show_program_.use();
    first.bind(0);
    irradiance_view_.bind(1, filtered, GL_RGBA32F);
    show_program_.set("first", 0);
    show_program_.set("irradiance", 1);
    show_program_.set("weight", static_cast<float>(own_weight(rays)));
    picture_.bind_image(0, GL_WRITE_ONLY);
    corrections_.bind_image(1, GL_WRITE_ONLY);
    show_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
    fade_left_ = kFadeFrames;
}

const gpu::Texture& StillGather::faded(const gpu::Texture& gathered) {
    shown_rays_ = 0;
    if (fade_left_ == 0) {
        return gathered;
    }
    fade_program_.use();
    gathered.bind(0);
    corrections_.bind(1);
    fade_program_.set("gathered", 0);
    fade_program_.set("corrections", 1);
    fade_program_.set("left", static_cast<float>(fade_left_) / (kFadeFrames + 1));
    picture_.bind_image(0, GL_WRITE_ONLY);
    fade_program_.dispatch(size_, ivec2(8));
    wait_for_shaders();
    --fade_left_;
    return picture_;
}

bool StillGather::changes_picture(int pass, int last) {
    const int few = static_cast<int>(std::bit_floor(static_cast<unsigned>(pass)));
    return pass % std::max(kFewestPasses, few / kPassesOver) == 0 || pass == last;
}

void StillGather::refine(ErrorParts& parts) const {
    if (shown_rays_ <= 0) {
        return;
    }
    const double own = own_weight(shown_rays_), first = (1 - own) * (1 - own);
    parts.noise = first * parts.noise + own * own * parts.contrast / (shown_rays_ * kFilteredPixels);
    parts.blur *= first;
    parts.bend *= first;
    if (exact_) {
        parts.contrast *= first;
    }
}

const gpu::Buffer& StillGather::shoot(const render::FrameInputs& inputs, const RayScene& rays, LitMaps& lit,
                                      int pass, const gpu::Buffer& bad_values) {
    RayScene own = rays;
    hits_.forget();
    if (own.exact != nullptr) {
        close_.begin(inputs, lit.texels().all_places() + CloseHits::kSlots + CloseHits::kPixelSlots);
        close_.release();
        own.close = &close_;
        own.nearness = &lit.nearness();
    }
    hits_.shoot(points_, own, nullptr, pass);
    gpu::PassEnd::tell();
    if (own.exact != nullptr) {
        hits_.collect(own);
        gpu::PassEnd::tell();
        lit.light_close(inputs, own.maps, own.settings, close_, bad_values);
        gpu::PassEnd::tell();
    }
    return hits_.shade(points_, lit.radiosity());
}

const gpu::Texture& StillGather::irradiance(const render::FrameInputs& inputs, const RayScene& rays,
                                            LitMaps& lit, const gpu::Texture& first, int pass, int last,
                                            const gpu::Buffer& bad_values) {
    inputs.gpu_scene.bind_materials();
    if (pass == 1) {
        begin(inputs, rays);
        gpu::PassEnd::tell();
    }
    points_.resize(grid_.x * grid_.y, grid_.x, rays.settings.of<EmcSettings>().gather_rays);
    place(inputs, pass);
    add(shoot(inputs, rays, lit, pass, bad_values));
    gpu::PassEnd::tell();
    exact_ = rays.exact != nullptr;
    if (changes_picture(pass, last)) {
        show(first,
             static_cast<double>(pass) * rays.settings.of<EmcSettings>().gather_rays / (stride_ * stride_));
    }
    return pass < kFewestPasses && pass < last ? faded(first) : picture_;
}

}  // namespace lanthorn::gi
