// generate_scenes [--large] FOLDER: writes the project's small scenes and the game's levels, or the large
// scenes, as FOLDER/NAME.glb. generate_scenes --wavy-ground|--stones COUNT FILE.glb: a scene of that many
// triangles, or stones of 3 200. generate_scenes --lamps|--ranged-lamps|--spots COUNT FILE.glb: a hall with
// so many lamps.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "tools/scene_generator/glb_bytes.h"
#include "tools/scene_generator/scenes.h"

using namespace lanthorn;

namespace {

constexpr int kMost = 40'000'000;

SceneData (*made_of_number(std::string_view kind))(int) {
    using namespace scene_generator;
    struct Kind {
        std::string_view option;
        SceneData (*make)(int);
    };
    static constexpr Kind kKinds[] = {
        {"--wavy-ground", wavy_ground},
        {"--stones", many_stones},
        {"--lamps", [](int count) { return lamp_hall(count, LampKind::endless); }},
        {"--ranged-lamps", [](int count) { return lamp_hall(count, LampKind::in_range); }},
        {"--spots", [](int count) { return lamp_hall(count, LampKind::spot); }}};
    const auto* const found = std::ranges::find(kKinds, kind, &Kind::option);
    return found != std::end(kKinds) ? found->make : nullptr;
}

// Makes the file of a scene of any number; false if that is not what is asked for.
bool write_of_number(int argc, char** argv) {
    const auto make = argc == 4 ? made_of_number(argv[1]) : nullptr;
    const int count = argc == 4 ? std::atoi(argv[2]) : 0;
    if (make == nullptr || count < 1 || count > kMost) {
        return false;
    }
    const std::string bytes = scene_generator::glb_bytes(make(count));
    write_file(argv[3], bytes);
    std::printf("%s  %zu bytes\n", argv[3], bytes.size());
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    const bool large = argc == 3 && std::string_view(argv[1]) == "--large";
    try {
        if (write_of_number(argc, argv)) {
            return 0;
        }
        if (argc != 2 && !large) {
            std::fprintf(stderr,
                         "usage: generate_scenes [--large] FOLDER\n"
                         "       generate_scenes --wavy-ground|--stones|--lamps|--ranged-lamps|--spots "
                         "COUNT FILE.glb\n");
            return static_cast<int>(ExitCode::bad_input);
        }
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
