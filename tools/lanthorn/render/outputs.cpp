#include "tools/lanthorn/render/outputs.h"

#include <fmt/format.h>

#include <utility>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/core/error.h"
#include "tools/workbench/render/shown_as.h"

namespace lanthorn::tools {

using render::Aov;

namespace {

constexpr AovKind kAovs[] = {
    {"final", Aov::final, true, true},       {"indirect", Aov::indirect, false, true},
    {"direct", Aov::direct, false, true},    {"albedo", Aov::albedo, true, true},
    {"normal", Aov::normal, false, false},   {"depth", Aov::depth, false, false},
    {"radiance", Aov::radiance, false, true}};

Output output_of(const std::string& name, const gi::TechniqueEntry& technique) {
    std::string known;
    for (const AovKind& kind : kAovs) {
        if (name == kind.name) {
            return {&kind, nullptr, {}};
        }
        known += (known.empty() ? "" : ", ") + std::string(kind.name);
    }
    for (const gi::DebugView& view : technique.debug_views) {
        if (name == view.name) {
            return {nullptr, &view, {}};
        }
        known +=
            (&view == &technique.debug_views.front() ? "; of " + technique.name + ' ' : ", ") + view.name;
    }
    throw InputError(fmt::format("--aov: found '{}', expected one of {}", name, known));
}

}  // namespace

std::vector<Output> plan_outputs(const std::vector<std::string>& aovs, const std::string& file,
                                 const gi::TechniqueEntry& technique) {
    std::vector<Output> outputs;
    for (const std::string& name : aovs) {
        Output output = output_of(name, technique);
        std::filesystem::path path = file;
        if (aovs.size() > 1) {
            path.replace_filename(path.stem().string() + "-" + name + path.extension().string());
        }
        for (const Output& other : outputs) {
            if (other.path == path) {
                throw InputError(fmt::format("--aov: found '{}' twice, expected it once", name));
            }
        }
        if (output.kind != nullptr && ((!holds_linear(path) && !output.kind->fits_png) ||
                                       (path.extension() == ".hdr" && !output.kind->fits_hdr))) {
            throw InputError(path.string(), "", fmt::format("cannot hold --aov {}, expected .exr", name));
        }
        check_image_writable(path);
        output.path = path;
        outputs.push_back(std::move(output));
    }
    return outputs;
}

ImageF encode(ImageF image, const Output& output) {
    const bool png = !holds_linear(output.path);
    if (output.view != nullptr) {
        return png ? workbench::shown_as(std::move(image), output.view->shown) : image;
    }
    const bool encoded = output.kind->aov == Aov::final;
    if (png != encoded) {
        for (float& v : image.pixels) {
            v = encoded ? linear_from_srgb(v) : srgb_from_linear(v);
        }
    }
    return image;
}

}  // namespace lanthorn::tools
