// generate_scenes [--large] FOLDER: writes the project's small scenes, or the large ones, as FOLDER/NAME.glb.
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "tools/scene_generator/glb_bytes.h"
#include "tools/scene_generator/scenes.h"

using namespace lanthorn;

int main(int argc, char** argv) {
    const bool large = argc == 3 && std::string_view(argv[1]) == "--large";
    if (argc != 2 && !large) {
        std::fprintf(stderr, "usage: generate_scenes [--large] FOLDER\n");
        return static_cast<int>(ExitCode::bad_input);
    }
    try {
        for (const auto& [name, make] :
             large ? scene_generator::large_scenes() : scene_generator::all_scenes()) {
            const auto path = std::filesystem::path(argv[argc - 1]) / (name + ".glb");
            const std::string bytes = scene_generator::glb_bytes(make());
            write_file(path, bytes);
            std::printf("%s  %zu bytes\n", path.string().c_str(), bytes.size());
        }
    } catch (const Error& error) {
        std::fprintf(stderr, "generate_scenes: %s\n", error.what());
        return static_cast<int>(error.code());
    }
    return 0;
}
