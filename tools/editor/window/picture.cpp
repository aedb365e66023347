#include "tools/editor/window/picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/gpu/pass_end.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tools/workbench/render/shown_as.h"

namespace lanthorn::edit_window {

using render::Aov;

namespace {

float luminance(const float* rgb) {
    return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
}

// Bytes as a texture has them: rows upwards, display-encoded.
std::vector<std::uint8_t> texture_bytes(const ImageF& image) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    for (int y = image.height; y-- > 0;) {
        for (int x = 0; x < image.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const float v = image.at(x, y, std::min(c, image.channels - 1));
                bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0f, 1.0f))));
            }
            bytes.push_back(255);
        }
    }
    return bytes;
}

// By more than Picture::kSame in one of three channels.
bool differs(std::uint32_t a, std::uint32_t b) {
    for (int shift = 0; shift < 24; shift += 8) {
        const int way = static_cast<int>(a >> shift & 255u) - static_cast<int>(b >> shift & 255u);
        if (std::abs(way) > Picture::kSame) {
            return true;
        }
    }
    return false;
}

ImageF three(ImageF image) {
    if (image.channels == 3) {
        return image;
    }
    ImageF wide{image.width, image.height, 3, {}, {}};
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < image.pixels.size(); i += channels) {
        for (std::size_t c = 0; c < 3; ++c) {
            wide.pixels.push_back(image.pixels[i + std::min(c, channels - 1)]);
        }
    }
    return wide;
}

ImageF debug_picture(App& app, ViewId view, const std::string& name) {
    const Renderer& renderer = app.world().resource<Renderer>();
    const DrawnView& drawn = renderer.drawn(view);
    gi::Technique& technique = gi::technique_of(app, view);
    const auto& entry = gi::technique_entry(
        view == ViewId::first ? app.world().resource<gi::ActiveTechnique>().kind
                              : app.world().resource<gi::ViewTechniques>().entries.at(view).active.kind);
    const auto found = std::ranges::find(entry.debug_views, name, &gi::DebugView::name);
    if (found == entry.debug_views.end()) {
        return {};
    }
    const gpu::Texture texture =
        technique.debug_view(name, drawn.frame->inputs(*drawn.scene, *renderer.timer));
    if (!texture) {
        return {};
    }
    ImageF image{texture.size().x, texture.size().y, 3, {}, {}};
    const std::vector<float> upwards = texture.read_floats(3);
    const std::size_t row = 3 * static_cast<std::size_t>(image.width);
    for (std::size_t y = static_cast<std::size_t>(image.height); y-- > 0;) {
        const auto begin = upwards.begin() + static_cast<std::ptrdiff_t>(y * row);
        image.pixels.insert(image.pixels.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
    }
    return workbench::shown_as(std::move(image), found->shown);
}

}  // namespace

vec3 heat_colour(float share) {
    return workbench::heat(share);
}

ImageF lux_of(App& app, ViewId view) {
    const render::FrameRenderer& frame = app.world().resource<Renderer>().of(view);
    const ImageF indirect = frame.read(Aov::indirect), direct = frame.read(Aov::direct);
    const ImageF albedo = frame.read(Aov::albedo), depth = frame.read(Aov::depth);
    ImageF lux{depth.width, depth.height, 1, {}, {}};
    lux.pixels.resize(depth.pixels.size());
    for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
        if (!(depth.pixels[i] > 0)) {
            continue;
        }
        const float reflected = std::max(0.02f, luminance(&albedo.pixels[3 * i]));
        const float lit = kPi * luminance(&direct.pixels[3 * i]) / reflected;
        const float sum = luminance(&indirect.pixels[3 * i]) + lit;
        lux.pixels[i] = std::isfinite(sum) ? sum : 0;
    }
    return lux;
}

gpu::Texture Picture::copy() const {
    const ivec2 size(first_.shown.texture.size());
    gpu::Texture result = gpu::Texture::make_2d(GL_RGBA8, size);
    result.set_filter(GL_LINEAR, GL_LINEAR);
    glCopyImageSubData(first_.shown.texture.id(), GL_TEXTURE_2D, 0, 0, 0, 0, result.id(), GL_TEXTURE_2D, 0, 0,
                       0, 0, size.x, size.y, 1);
    return result;
}

void Picture::fit(Target& target, ivec2 size) {
    if (target.texture && ivec2(target.texture.size()) == size) {
        return;
    }
    target.framebuffer = {};
    target.texture = gpu::Texture::make_2d(GL_RGBA8, size);
    target.texture.set_filter(GL_LINEAR, GL_LINEAR);
    target.framebuffer = gpu::Framebuffer({&target.texture}, nullptr);
}

void Picture::show_view(App& app, ViewId view, Target& target) {
    const render::FrameRenderer& frame = app.world().resource<Renderer>().of(view);
    ImageF image;
    const bool is_first = view == ViewId::first;
    scale_ = is_first ? 0 : scale_;
    if (view_ == "indirect") {
        image = workbench::shown_as(frame.read(Aov::indirect), gi::DebugView::Shown::light);
    } else if (view_ == "direct") {
        image = workbench::shown_as(frame.read(Aov::direct), gi::DebugView::Shown::light);
    } else if (view_ == "albedo") {
        image = workbench::shown_as(frame.read(Aov::albedo), gi::DebugView::Shown::colour);
    } else if (view_ == "normals") {
        image = frame.read(Aov::normal);
        for (float& v : image.pixels) {
            v = 0.5f + 0.5f * v;
        }
    } else if (view_ == "depth") {
        image = workbench::shown_as(three(frame.read(Aov::depth)), gi::DebugView::Shown::amount);
    } else if (view_ == "lux") {
        ImageF lux = lux_of(app, view);
        if (is_first) {
            std::vector<float> amounts = lux.pixels;
            const auto high =
                amounts.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(amounts.size()));
            std::ranges::nth_element(amounts, high);
            // From a thousandth of the brightest hundredth up, by its logarithm: eyes see ratios.
            scale_ = std::max(1e-6, static_cast<double>(*high));
        }
        image = three(std::move(lux));
        for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
            const float share = image.pixels[i] / static_cast<float>(scale_);
            const vec3 colour = share > 0 ? heat_colour(1 + std::log10(std::max(share, 1e-3f)) / 3) : vec3(0);
            std::copy_n(&colour.x, 3, &image.pixels[i]);
        }
    } else {
        image = debug_picture(app, view, view_);
    }
    if (image.pixels.empty()) {
        target.texture.clear(vec4(0, 0, 0, 1));
        return;
    }
    fit(target, {image.width, image.height});
    const std::vector<std::uint8_t> bytes = texture_bytes(image);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTextureSubImage2D(target.texture.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        bytes.data());
}

void Picture::forget_other() {
    other_ = {};
    other_is_new_ = false;
}

double Picture::take(Side& side) {
    const ivec2 seen(side.next.texture.size());
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(seen.x) * static_cast<std::size_t>(seen.y));
    glGetTextureImage(side.next.texture.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(4 * pixels.size()), pixels.data());
    std::swap(side.shown, side.next);
    const std::vector<std::uint32_t> before = std::exchange(side.pixels, std::move(pixels));
    if (before.size() != side.pixels.size()) {
        return 1;
    }
    std::size_t other = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        other += before[i] != side.pixels[i] && differs(before[i], side.pixels[i]) ? 1 : 0;
    }
    return static_cast<double>(other) / static_cast<double>(std::max<std::size_t>(1, before.size()));
}

double Picture::draw(App& app, ivec2 size, ivec2 whole, std::optional<ViewId> other,
                     const std::function<void()>& breathe) {
    using clock = std::chrono::steady_clock;
    const auto ms_since = [](clock::time_point from) {
        return std::chrono::duration<double, std::milli>(clock::now() - from).count();
    };
    ecs::World& world = app.world();
    if (world.resource<render::RenderSettings>().upscale == render::Upscale::none) {
        whole = size;
    }
    fit(first_.next, whole);
    const View& looks = app.view();
    app.view().size = size;
    app.view().whole = whole;
    for (const auto& [id, view] : std::as_const(app).world().resource<Views>().all()) {
        View& beside = app.view(id);
        beside.rests = id != other;
        if (beside.rests) {
            continue;
        }
        beside.size = size;
        beside.whole = whole;
        beside.camera = looks.camera;
        beside.placed = looks.placed;
        beside.y_fov = looks.y_fov;
    }
    PresentTarget& target = world.resource_mut<PresentTarget>();
    target.framebuffer = first_.next.framebuffer.id();
    target.size = whole;
    auto breath = clock::now();
    double longest = 0;
    double ms[2] = {};  // of the first view and of the other; what both have in common counts for each
    const bool finishes = gpu::draws_in_software() || other;
    const Renderer& renderer = world.resource<Renderer>();
    // The time since the last call is of the view that a pass is at work for.
    const auto spend = [&] {
        const double spent = ms_since(breath);
        const auto at_work =
            std::ranges::find_if(renderer.views, [](const auto& view) { return view->at_work; });
        const bool shared = at_work == renderer.views.end();
        ms[0] += shared || (*at_work)->id == ViewId::first ? spent : 0;
        ms[1] += shared || (*at_work)->id != ViewId::first ? spent : 0;
        longest = std::max(longest, spent);
    };
    const auto pass_end = [&] {
        if (finishes) {
            // What is drawn waits in a queue till somebody asks for it: an answer behind it would wait, too.
            glFinish();
        }
        spend();
        if (breathe) {
            breathe();
        }
        breath = clock::now();
    };
    {
        const gpu::PassEnd breathing(pass_end);
        app.show();
    }
    scale_ = 0;
    const auto show = [&](ViewId view, Side& side) {
        if (view_ != "final") {
            show_view(app, view, side.next);
        } else if (view != ViewId::first) {
            renderer.of(view).present(side.next.framebuffer.id(), whole);
        }
        const double changed = take(side);  // waits: what the badge says is what a frame takes
        side.facts.size = size;
        side.facts.view = view_;
        return changed;
    };
    double changed = show(ViewId::first, first_);
    ms[0] += ms_since(breath);
    longest = std::max(longest, ms_since(breath));
    other_is_new_ = other.has_value();
    if (other) {
        const auto begun = clock::now();
        fit(other_.next, whole);
        changed = std::max(changed, show(*other, other_));
        other_.facts.ms = ms[1] + ms_since(begun);
    }
    first_.facts.ms = ms[0];
    first_.facts.longest_ms = longest;
    ++frames_;
    return changed;
}

}  // namespace lanthorn::edit_window
