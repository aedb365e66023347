// lanthorn compare IMG REF: how far an image is from its reference.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/assets/image_io.h"
#include "tools/image_metrics/flip.h"
#include "tools/image_metrics/metrics.h"
#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

namespace {

using namespace image_metrics;

struct Options {
    std::string image, reference, heatmap;
    std::string metric = "relrmse";
    std::optional<double> max, min;
    bool json = false;
};

struct NamedValue {
    const char* name;
    double value;  // NaN: does not apply to these images
};

// FLIP is for display-encoded pictures: three channels within 0..1.
bool displayable(const ImageF& image) {
    return image.channels >= 3 &&
           std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return v >= 0 && v <= 1; });
}

std::vector<NamedValue> values_of(const Comparison& c, double mean_flip) {
    return {{"relrmse", c.all.relrmse}, {"rmse", c.all.rmse}, {"mae", c.all.mae}, {"max", c.all.max},
            {"flux", c.all.flux},       {"psnr", c.psnr},     {"flip", mean_flip}};
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
        fmt::print("channel {}: relrmse {:.6g}, flux {:.6g}, mean {:.6g} (reference {:.6g})\n", i, d.relrmse,
                   d.flux, d.mean, d.reference_mean);
    }
    fmt::print("pixels   {} valid of {}\n", c.valid_pixels, c.pixels);
}

ExitCode compare_images(const Options& options) {
    if (!options.heatmap.empty()) {
        check_image_writable(options.heatmap);
    }
    const ImageF image = read_image(options.image);
    const ImageF reference = read_image(options.reference);
    const Comparison c = compare(image, reference, options.image, options.reference);

    std::vector<float> flip_map;
    double mean_flip = std::nan("");
    if (displayable(image) && displayable(reference)) {
        flip_map = flip(image, reference);
        double sum = 0;
        for (const float value : flip_map) {
            sum += value;
        }
        mean_flip = sum / static_cast<double>(flip_map.size());
    }
    const std::vector<NamedValue> values = values_of(c, mean_flip);
    double chosen = 0;
    for (const auto& [name, value] : values) {
        if (options.metric == name) {
            chosen = value;
        }
    }
    if (std::isnan(chosen)) {
        throw InputError(
            options.image, "",
            fmt::format("{} does not apply, expected two display-encoded colour pictures", options.metric));
    }
    if (!options.heatmap.empty()) {
        // FLIP's own map, else the error relative to the reference's mean: white is 1 or more.
        const auto errors =
            options.metric == "flip" ? flip_map : relative_error(image, reference, c.all.reference_mean);
        write_image(options.heatmap, heat_map(errors, image.width, image.height));
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
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("compare", "How far an image is from its reference.");
    command->add_option("IMG", options->image, "image (EXR, PNG, HDR)")->required();
    command->add_option("REF", options->reference, "its reference, of the same size and channels")
        ->required();
    command
        ->add_option("--metric", options->metric,
                     "what --max and --min look at: relrmse (default), rmse, mae, max, flux, psnr, flip")
        ->check(CLI::IsMember({"relrmse", "rmse", "mae", "max", "flux", "psnr", "flip"}));
    command->add_option("--max", options->max, "exit 1 if the metric is above this");
    command->add_option("--min", options->min, "exit 1 if the metric is below this (flux, psnr)");
    command->add_option(
        "--heatmap", options->heatmap,
        "write the error by pixel as colours: black none, white the reference's mean or more (flip: 1)");
    command->add_flag("--json", options->json, "print one JSON object");
    return [options] { return compare_images(*options); };
}

}  // namespace lanthorn::tools
