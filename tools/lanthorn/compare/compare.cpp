// lanthorn compare IMG REF: how far an image is from its reference.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/workbench/flip.h"
#include "lanthorn/workbench/hdr_flip.h"
#include "lanthorn/workbench/metrics.h"
#include "lanthorn/workbench/ssim.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

namespace {

constexpr const char* kMetrics[] = {"relrmse", "rmse", "mae",  "max",  "flux",
                                    "bias",    "psnr", "ssim", "flip", "hdrflip"};

constexpr double kNoLimit = std::numeric_limits<double>::max();

struct CompareOptions {
    std::string image, reference, mask, heatmap;
    std::string metric = "relrmse";
    std::optional<double> max, min;
    bool any_scene = false;
    bool json = false;
};

struct NamedValue {
    const char* name;
    double value;  // NaN: does not apply to these images
};

// The error by pixel as a person sees it, where it applies; empty where not.
struct Seen {
    std::vector<float> flip, hdr_flip;
};

Encoding encoding_of(const ImageF& image) {
    return image.linear ? Encoding::linear : Encoding::srgb;
}

bool displayable(const ImageF& image) {
    return std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return v >= 0 && v <= 1; });
}

bool nowhere_negative(const ImageF& image) {
    return std::ranges::none_of(image.pixels, [](float v) { return v < 0; });
}

void check_encoding(const CompareOptions& options, const ImageF& image, const ImageF& reference) {
    if (image.linear != reference.linear) {
        const bool linear = image.linear;
        throw InputError(
            options.image, "",
            fmt::format("found {} values, expected {} ones as in {}", linear ? "linear" : "display-encoded",
                        linear ? "display-encoded" : "linear", options.reference));
    }
}

// What wrote the images says of which scene they are, camera and lights taken in.
void check_scene(const CompareOptions& options, const ImageF& image, const ImageF& reference) {
    const auto a = image.metadata.find("scene"), b = reference.metadata.find("scene");
    if (!options.any_scene && a != image.metadata.end() && b != reference.metadata.end() &&
        a->second != b->second) {
        throw InputError(
            options.image, "metadata",
            fmt::format("found scene {}, expected {} as in {} (--any-scene compares all the same)", a->second,
                        b->second, options.reference));
    }
}

PixelMask read_mask(const CompareOptions& options, const ImageF& reference) {
    if (options.mask.empty()) {
        return {};
    }
    const ImageF mask = read_image(options.mask);
    if (mask.width != reference.width || mask.height != reference.height) {
        throw InputError(options.mask, "",
                         fmt::format("found {} x {} pixels, expected {} x {} as in {}", mask.width,
                                     mask.height, reference.width, reference.height, options.reference));
    }
    PixelMask pixels = lit_pixels(mask);
    if (std::ranges::count(pixels, 1) == 0) {
        throw InputError(options.mask, "", "found no pixel that is not 0, expected some to compare");
    }
    return pixels;
}

Seen see(const ImageF& image, const ImageF& reference) {
    Seen seen;
    if (image.channels >= 3) {
        const Encoding encoding = encoding_of(image);
        if (displayable(image) && displayable(reference)) {
            seen.flip = flip(image, reference, encoding);
        }
        if (encoding == Encoding::linear && nowhere_negative(image) && nowhere_negative(reference)) {
            seen.hdr_flip = hdr_flip(image, reference);
        }
    }
    return seen;
}

std::vector<NamedValue> values_of(const Comparison& c, const Seen& seen, double mean_ssim,
                                  const PixelMask& mask) {
    double bias = 0;
    for (const Difference& d : c.channels) {
        bias = std::isnan(d.bias) ? bias : std::max(bias, std::abs(d.bias));
    }
    const auto mean = [&](const std::vector<float>& map) {
        return map.empty() ? std::nan("") : mean_over(map, mask);
    };
    return {{"relrmse", c.all.relrmse}, {"rmse", c.all.rmse},
            {"mae", c.all.mae},         {"max", c.all.max},
            {"flux", c.all.flux},       {"bias", bias},
            {"psnr", c.psnr},           {"ssim", mean_ssim},
            {"flip", mean(seen.flip)},  {"hdrflip", mean(seen.hdr_flip)}};
}

// JSON has neither NaN nor infinity.
nlohmann::ordered_json number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

void print_json(const Comparison& c, const std::vector<NamedValue>& values) {
    nlohmann::ordered_json root;
    for (const auto& [name, value] : values) {
        root[name] = number(value);
    }
    root["mean"] = c.all.mean;
    root["reference_mean"] = c.all.reference_mean;
    root["pixels"] = c.pixels;
    root["valid_pixels"] = c.valid_pixels;
    for (const Difference& d : c.channels) {
        root["channels"].push_back({{"relrmse", number(d.relrmse)},
                                    {"rmse", d.rmse},
                                    {"flux", number(d.flux)},
                                    {"bias", number(d.bias)},
                                    {"mean", d.mean},
                                    {"reference_mean", d.reference_mean}});
    }
    fmt::print("{}\n", root.dump(2));
}

void print_table(const Comparison& c, const std::vector<NamedValue>& values) {
    for (const auto& [name, value] : values) {
        if (!std::isnan(value)) {
            fmt::print("{:<8} {:.6g}\n", name, value);
        }
    }
    fmt::print("{:<8} {:.6g} (reference {:.6g})\n", "mean", c.all.mean, c.all.reference_mean);
    for (std::size_t i = 0; i < c.channels.size(); ++i) {
        const Difference& d = c.channels[i];
        fmt::print("channel {}: relrmse {:.6g}, bias {:+.6g}, mean {:.6g} (reference {:.6g})\n", i, d.relrmse,
                   d.bias, d.mean, d.reference_mean);
    }
    fmt::print("pixels   {} valid of {}\n", c.valid_pixels, c.pixels);
}

// The chosen metric's own map, else the error relative to the reference's mean: white is 1 or more. Black
// where the mask does not look.
ImageF error_map(const CompareOptions& options, const ImageF& image, const ImageF& reference,
                 const Comparison& c, const Seen& seen, std::vector<float> similarity,
                 const PixelMask& mask) {
    std::vector<float> errors;
    if (options.metric == "flip") {
        errors = seen.flip;
    } else if (options.metric == "hdrflip") {
        errors = seen.hdr_flip;
    } else if (options.metric == "ssim") {
        errors = std::move(similarity);
        std::ranges::transform(errors, errors.begin(), [](float s) { return 1 - s; });
    } else {
        errors = relative_error(image, reference, c.all.reference_mean);
    }
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const bool counts = options.metric == "ssim" ? c.valid[i] != 0 : mask.empty() || mask[i] != 0;
        errors[i] = counts ? errors[i] : 0;
    }
    return heat_map(errors, image.width, image.height);
}

// Where a limit is to be kept, a pixel that is no number breaks it, and where more than a tenth are none
// there is no picture: compare() refuses both.
ImageF read_to_compare(const CompareOptions& options, const std::string& path) {
    ImageF image = read_image(path);
    if (options.max || options.min) {
        return image;
    }
    ImageF repaired = image;
    const std::size_t pixels = repair_pixels(repaired, true);
    const std::size_t all = image.pixels.size() / static_cast<std::size_t>(image.channels);
    if (pixels == 0 || pixels > all / 10) {
        return image;
    }
    fmt::print(stderr,
               "lanthorn: warning: {}: {} pixel{} infinite or no number; compared as what lies around\n",
               path, pixels, pixels == 1 ? " is" : "s are");
    return repaired;
}

ExitCode compare_images(const CompareOptions& options) {
    if (!options.heatmap.empty()) {
        check_image_writable(options.heatmap);
    }
    const ImageF image = read_to_compare(options, options.image);
    const ImageF reference = read_to_compare(options, options.reference);
    check_encoding(options, image, reference);
    check_scene(options, image, reference);
    const PixelMask mask = read_mask(options, reference);
    const Comparison c = compare(image, reference, options.image, options.reference, mask);
    const Seen seen = see(image, reference);
    std::vector<float> similarity = ssim(image, reference, c.peak, c.valid);
    const std::vector<NamedValue> values = values_of(c, seen, mean_over(similarity, c.valid), mask);
    double chosen = 0;
    for (const auto& [name, value] : values) {
        if (options.metric == name) {
            chosen = value;
        }
    }
    if (std::isnan(chosen)) {
        throw InputError(
            options.image, "",
            fmt::format("{} does not apply, expected two {} colour pictures", options.metric,
                        options.metric == "flip" ? "displayable (0 to 1)" : "linear, nowhere negative"));
    }
    if (!options.heatmap.empty()) {
        write_image(options.heatmap,
                    error_map(options, image, reference, c, seen, std::move(similarity), mask));
    }
    options.json ? print_json(c, values) : print_table(c, values);

    const bool too_large = options.max && !(chosen <= *options.max);
    const bool too_small = options.min && !(chosen >= *options.min);
    if (too_large || too_small) {
        fmt::print(stderr, "lanthorn: {}: {} is {:.6g}, expected at {} {}\n", options.image, options.metric,
                   chosen, too_large ? "most" : "least", too_large ? *options.max : *options.min);
        return ExitCode::check_failed;
    }
    return ExitCode::ok;
}

}  // namespace

Command add_compare(CLI::App& app) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* command = app.add_subcommand("compare", "How far an image is from its reference.");
    command->add_option("IMG", options->image, "image (EXR, PNG, HDR, JPEG, TIFF and more)")->required();
    command->add_option("REF", options->reference, "its reference, of the same size and channels")
        ->required();
    command
        ->add_option("--metric", options->metric,
                     "what --max, --min and --heatmap look at: relrmse (default), rmse, mae, max, flux, bias "
                     "(largest of the channels), psnr, ssim, flip, hdrflip")
        ->check(CLI::IsMember(std::vector<std::string>(std::begin(kMetrics), std::end(kMetrics))));
    command->add_option("--max", options->max, "exit 1 if the metric is above this")
        ->check(number_between(-kNoLimit, kNoLimit));
    command->add_option("--min", options->min, "exit 1 if the metric is below this (flux, psnr, ssim)")
        ->check(number_between(-kNoLimit, kNoLimit));
    command->add_option("--mask", options->mask, "image of the same size: only where it is not 0 counts");
    command->add_option("--heatmap", options->heatmap,
                        "write the error by pixel as colours: black none, white the reference's mean or more "
                        "(flip, hdrflip, ssim: 1)");
    command->add_flag("--any-scene", options->any_scene,
                      "compare even if the images' metadata names different scenes");
    command->add_flag("--json", options->json, "print one JSON object");
    return [options] { return compare_images(*options); };
}

}  // namespace lanthorn::tools
