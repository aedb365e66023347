// generate_scenes [--large] FOLDER: writes the project's small scenes and the game's levels, or the large
// scenes, as FOLDER/NAME.glb.
#include <algorithm>
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
        const auto write = [&](const scene_generator::NamedScene& scene) {
            const auto& [name, make] = scene;
            const auto path = std::filesystem::path(argv[argc - 1]) / (name + ".glb");
            const std::string bytes = scene_generator::glb_bytes(make());
            write_file(path, bytes);
            std::printf("%s  %zu bytes\n", path.string().c_str(), bytes.size());
        };
        if (large) {
            std::ranges::for_each(scene_generator::large_scenes(), write);
        } else {
            std::ranges::for_each(scene_generator::all_scenes(), write);
            std::ranges::for_each(scene_generator::level_scenes(), write);
        }
    } catch (const Error& error) {
        std::fprintf(stderr, "generate_scenes: %s\n", error.what());
        return static_cast<int>(error.code());
    }
    return 0;
}
