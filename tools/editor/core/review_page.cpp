#include "tools/editor/core/review_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/assets/png_image.h"
#include "engine/core/base64.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/core/printable.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tools/editor/core/error_map.h"
#include "tools/editor/core/review_style.h"
#include "tools/workbench/measure/light_contracts.h"
#include "tools/workbench/measure/light_words.h"
#include "tools/workbench/render/shown_as.h"

namespace lanthorn::editor {

namespace {

constexpr int kSamples = 64;  // of the reference, a place

// One view of one of the two scenes.
struct Look {
    ImageF final, lux, error;  // display-encoded but for lux
    double ms = 0, mean_lux = 0;
    ErrorMap map;
    std::vector<workbench::ContractVerdict> contracts;
};

std::string picture_uri(const ImageF& image) {
    return "data:image/png;base64," + base64(png_picture(image));
}

ImageF lux_image(const render::FrameRenderer& frame) {
    const ImageF indirect = frame.read(render::Aov::indirect), direct = frame.read(render::Aov::direct);
    const ImageF albedo = frame.read(render::Aov::albedo), depth = frame.read(render::Aov::depth);
    ImageF lux{depth.width, depth.height, 1, {}, {}};
    for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
        const auto at = [&](const ImageF& image) {
            return luminance(dvec3(image.pixels[3 * i], image.pixels[3 * i + 1], image.pixels[3 * i + 2]));
        };
        const double lit = static_cast<double>(kPi) * at(direct) / std::max(0.02, at(albedo));
        lux.pixels.push_back(depth.pixels[i] > 0 ? static_cast<float>(at(indirect) + lit) : 0.0f);
    }
    return lux;
}

// By its logarithm, from a thousandth of `most` up.
ImageF coloured(const ImageF& lux, double most) {
    ImageF image{lux.width, lux.height, 3, {}, {}};
    for (const float v : lux.pixels) {
        const float share = v / static_cast<float>(most);
        const vec3 c = share > 0 ? workbench::heat(1 + std::log10(std::max(share, 1e-3f)) / 3) : vec3(0);
        image.pixels.insert(image.pixels.end(), {c.x, c.y, c.z});
    }
    return image;
}

// The picture in grey, with what errs in red (too bright) and blue (too dark).
ImageF tinted(const ImageF& final, const ErrorMap& map) {
    ImageF image = final;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            float* rgb = &image.pixels[3 * static_cast<std::size_t>(y * image.width + x)];
            const float grey = 0.6f * luminance(vec3(rgb[0], rgb[1], rgb[2])) + 0.2f;
            const ivec2 cell = ivec2(x, y) / map.stride;
            const bool in = cell.x < map.cells.x && cell.y < map.cells.y;
            const float error =
                in ? map.error[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(map.cells.x) +
                               static_cast<std::size_t>(cell.x)]
                   : 0.0f;
            const float amount = std::isfinite(error) ? std::min(std::abs(error), 1.0f) : 0.0f;
            const vec3 c =
                glm::mix(vec3(grey), error > 0 ? vec3(1, 0.22f, 0.16f) : vec3(0.19f, 0.49f, 1), amount);
            std::copy_n(&c.x, 3, rgb);
        }
    }
    return image;
}

Look look_at(const GltfDocument& document, const EditSession& session, const Settings& settings,
             const ReviewView& of, const CheckedFrames& what) {
    const EditSession::Copy copy(document);
    workbench::SceneView view = session.view();
    SceneData scene = workbench::load_scene(copy.file().string(), view);
    view.camera = workbench::add_pose_camera(scene, of.pose);
    ShownScene shown(std::move(scene), view);
    gi::add_picture_plugins(shown.app(), settings);
    shown.app().view().size = what.size;
    Look look;
    std::vector<double> ms;
    for (int i = 0; i < what.frames; ++i) {
        const auto begun = std::chrono::steady_clock::now();
        shown.show_at(0);
        glFinish();
        ms.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count());
    }
    std::ranges::sort(ms);
    look.ms = ms[ms.size() / 2];
    const render::FrameRenderer& frame = *std::as_const(shown).world().resource<Renderer>().frame;
    look.final = frame.read(render::Aov::final);
    look.lux = lux_image(frame);
    double sum = 0, seen = 0;
    for (const float v : look.lux.pixels) {
        sum += static_cast<double>(v);
        seen += v > 0 ? 1 : 0;
    }
    look.mean_lux = seen > 0 ? sum / seen : 0;
    const reference::PathSettings path = reference::path_settings(settings);
    reference::SparsePaths paths(shown.frame(), what.size, kErrorStride, path);
    paths.trace(kSamples, {});
    look.map = error_map(paths, frame.read(render::Aov::indirect));
    look.error = tinted(look.final, look.map);
    const auto contracts = workbench::contracts_of(std::as_const(shown).world(), shown.frame());
    if (!contracts.empty()) {
        const reference::LightSplitter light(shown.frame(), path);
        for (const workbench::PlacedContract& contract : contracts) {
            look.contracts.push_back(check_contract(contract, light, {}));
        }
    }
    return look;
}

std::string pair_of(const char* kind, const ImageF& before, const ImageF& after) {
    return fmt::format(
        "<div class='pair {0}'><img src='{1}' alt='before'><img class='after' src='{2}' alt='after'>"
        "<input type='range' min='0' max='1000' value='500' aria-label='before or after'>"
        "<b class='l'>before</b><b class='r'>after</b></div>\n",
        kind, picture_uri(before), picture_uri(after));
}

std::string row(const char* what, const std::string& before, const std::string& after) {
    return fmt::format("<tr><th>{}</th><td>{}</td><td>{}</td></tr>\n", what, markup_text(before),
                       markup_text(after));
}

std::string error_text(const ErrorMap& map) {
    return fmt::format("{:.1f} % +- {:.1f}{}", 100 * map.local, 100 * map.uncertainty,
                       map.within_noise ? " (within the noise)" : "");
}

std::string section(const ReviewView& view, const Look& before, const Look& after,
                    const CheckedFrames& what) {
    // One scale for both, so that they can be compared.
    std::vector<float> amounts = before.lux.pixels;
    amounts.insert(amounts.end(), after.lux.pixels.begin(), after.lux.pixels.end());
    const auto high =
        amounts.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(amounts.size() - 1));
    std::ranges::nth_element(amounts, high);
    const double most = std::max(1e-6, static_cast<double>(*high));
    std::string html = fmt::format("<section><h2>{}</h2><p class='pose'>--pose={}</p>\n",
                                   markup_text(view.name), workbench::text_of(view.pose));
    html +=
        "<div class='tabs'><button data-show='final'>Final</button><button data-show='lux'>Lux</button>"
        "<button data-show='error'>Error</button></div>\n";
    html += pair_of("final", before.final, after.final);
    html += pair_of("lux", coloured(before.lux, most), coloured(after.lux, most));
    html += pair_of("error", before.error, after.error);
    html += fmt::format(
        "<p class='lux note'>violet {} lx to white {} lx, by the logarithm</p>"
        "<p class='error note'>red: indirect light too bright, blue: too dark, grey: within the "
        "reference's noise</p>\n",
        workbench::lux_text(most / 1000), workbench::lux_text(most));
    html += "<table><tr><th></th><th>before</th><th>after</th></tr>\n";
    html += row("mean of what is seen", workbench::lux_text(before.mean_lux) + " lx",
                workbench::lux_text(after.mean_lux) + " lx");
    html += row("error of indirect light", error_text(before.map), error_text(after.map));
    html += row(fmt::format("frame of {}x{} here", what.size.x, what.size.y).c_str(),
                fmt::format("{:.0f} ms", before.ms), fmt::format("{:.0f} ms", after.ms));
    return html + "</table></section>\n";
}

std::string contracts_html(const Look& before, const Look& after) {
    if (before.contracts.empty() && after.contracts.empty()) {
        return "";
    }
    std::string html = "<section><h2>Contracts</h2><table><tr><th>before</th><th>after</th></tr>\n";
    for (std::size_t i = 0; i < std::max(before.contracts.size(), after.contracts.size()); ++i) {
        html += "<tr>";
        for (const Look* look : {&before, &after}) {
            html += i < look->contracts.size()
                        ? fmt::format("<td class='{}'>{}</td>", look->contracts[i].kept ? "kept" : "broken",
                                      markup_text(contract_words(look->contracts[i])))
                        : std::string("<td></td>");
        }
        html += "</tr>\n";
    }
    return html + "</table></section>\n";
}

}  // namespace

void write_review(const EditSession& session, const Settings& settings, const std::vector<ReviewView>& views,
                  const CheckedFrames& what, const std::filesystem::path& page) {
    const GltfDocument before = session.path().empty()
                                    ? session.steps().first_document()
                                    : GltfDocument::open(session.path(), session.view().allow_outside);
    const TextChanges changes = text_changes(before.json_text(), session.document().json_text());
    const std::string name = session.path().empty() ? "new room" : session.path().filename().string();
    std::string html = fmt::format(
        "<!doctype html><html lang='en'><head><meta charset='utf-8'><title>{0}: "
        "review</title><style>{1}</style></head>"
        "<body><h1>{0}</h1><p>{2}; {3} {4}</p>\n",
        markup_text(name), kReviewStyle, markup_text(summary(changes, session.file_bytes())),
        markup_text(settings.text("gi.technique")),
        views.size() == 1 ? "in one view" : fmt::format("in {} views", views.size()));
    std::string contracts;
    for (const ReviewView& view : views) {
        const Look was = look_at(before, session, settings, view, what);
        const Look is = look_at(session.document(), session, settings, view, what);
        html += section(view, was, is, what);
        contracts = contracts_html(was, is);
    }
    html += contracts + "<section><h2>Edits</h2><ol>\n";
    for (std::size_t i = 0; i < session.steps().position(); ++i) {
        html += fmt::format("<li>{}</li>\n", markup_text(session.steps().steps()[i].text));
    }
    html += "</ol></section><section><h2>Text that changes</h2><pre>\n";
    for (const TextChanges::Line& line : changes.lines) {
        html += fmt::format("<span class='{}'>{}{:6} {}</span>\n", line.added ? "plus" : "minus",
                            line.added ? '+' : '-', line.line, markup_text(line.text));
    }
    html += fmt::format("</pre></section><script>{}</script></body></html>\n", kReviewScript);
    write_file(page, html);
}

}  // namespace lanthorn::editor
