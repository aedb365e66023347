// lanthorn convert IN OUT: writes a glTF file anew, or as the other container.
#include "tools/lanthorn/convert/convert.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <system_error>
#include <utility>

#include "lanthorn/assets/gltf_import.h"
#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

namespace fs = std::filesystem;

namespace {

// Writing tells of images that stay named where they are to be copied, and taking in of all.
void add_once(std::vector<std::string>& warnings, const std::vector<std::string>& more) {
    for (const std::string& warning : more) {
        if (std::ranges::find(warnings, warning) == warnings.end()) {
            warnings.push_back(warning);
        }
    }
}

void check_is_glb(const fs::path& out) {
    std::string ending = out.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    if (ending != ".glb") {
        throw InputError(out.string(), "",
                         fmt::format("found the ending '{}', expected .glb with --self-contained", ending));
    }
}

}  // namespace

GltfDocument::Written convert(const fs::path& in, const fs::path& out, const ConvertOptions& options) {
    std::error_code ignored;
    if (options.self_contained) {
        check_is_glb(out);
    }
    if (fs::equivalent(in, out, ignored)) {
        throw InputError(out.string(), "", fmt::format("is '{}' itself, expected another file", in.string()));
    }
    std::vector<std::string> warnings;
    for (const std::string& warning : import_gltf(in, {"", options.allow_outside}).warnings) {
        warnings.push_back(fmt::format("{}: {}", in.string(), warning));
    }
    GltfDocument document = GltfDocument::open(in, options.allow_outside);
    if (options.self_contained) {
        add_once(warnings, document.take_in_files());
    }
    GltfDocument::Written written = document.write(out);
    add_once(warnings, written.warnings);
    written.warnings = std::move(warnings);
    return written;
}

namespace {

struct ConvertArguments {
    std::string in, out;
    ConvertOptions along;
};

ExitCode run(const ConvertArguments& options) {
    const GltfDocument::Written written = convert(options.in, options.out, options.along);
    for (const std::string& warning : written.warnings) {
        fmt::print(stderr, "lanthorn: warning: {}\n", warning);
    }
    for (const fs::path& file : written.files) {
        fmt::print("{}  {} bytes\n", file.string(), fs::file_size(file));
    }
    return ExitCode::ok;
}

}  // namespace

Command add_convert(CLI::App& app) {
    auto options = std::make_shared<ConvertArguments>();
    CLI::App* command =
        app.add_subcommand("convert",
                           "Write a glTF file anew, or as the other container. IN is imported first, and "
                           "refused where other commands "
                           "refuse it; then everything in it is kept byte for byte: names, extras, "
                           "extensions, order, numbers, buffers, "
                           "images. Between .gltf and .glb, buffer 0 moves into the binary chunk, or out of "
                           "it into NAME.bin. In another "
                           "folder, the files that IN names are copied beside OUT. All files appear or none. "
                           "OUT is replaced if it is "
                           "there; of the files beside it, only those that the old OUT names.");
    command->add_option("IN", options->in, "glTF 2.0 file (.gltf, .glb)")->required();
    command->add_option("OUT", options->out, "file to write: its ending, .gltf or .glb, is the container")
        ->required();
    command->add_flag("--allow-outside", options->along.allow_outside,
                      "let IN name files outside of its own folder; without it those are not copied");
    command->add_flag("--self-contained", options->along.self_contained,
                      "put the images and buffers that IN names as files into OUT, a .glb");
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools
