// lanthorn convert IN OUT: writes a glTF file anew, or as the other container.
#include "tools/lanthorn/convert/convert.h"

#include <fmt/format.h>

#include <memory>
#include <system_error>

#include "lanthorn/assets/gltf_import.h"
#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

namespace fs = std::filesystem;

GltfDocument::Written convert(const fs::path& in, const fs::path& out, bool allow_outside) {
    std::error_code ignored;
    if (fs::equivalent(in, out, ignored)) {
        throw InputError(out.string(), "", fmt::format("is '{}' itself, expected another file", in.string()));
    }
    std::vector<std::string> warnings;
    for (const std::string& warning : import_gltf(in, {"", allow_outside}).warnings) {
        warnings.push_back(fmt::format("{}: {}", in.string(), warning));
    }
    GltfDocument::Written written = GltfDocument::open(in, allow_outside).write(out);
    written.warnings.insert(written.warnings.begin(), warnings.begin(), warnings.end());
    return written;
}

namespace {

struct Options {
    std::string in, out;
    bool allow_outside = false;
};

ExitCode run(const Options& options) {
    const GltfDocument::Written written = convert(options.in, options.out, options.allow_outside);
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
    auto options = std::make_shared<Options>();
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
    command->add_flag("--allow-outside", options->allow_outside,
                      "let IN name files outside of its own folder; without it those are not copied");
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools
