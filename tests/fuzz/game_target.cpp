#include "tests/fuzz/game_target.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "game/presentation/options.h"
#include "game/presentation/preferences.h"
#include "game/presentation/progress.h"
#include "game/rules/actions.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/replay/content_hash.h"
#include "tests/fuzz/gltf_target.h"
#include "tests/fuzz/quiet.h"
#include "tests/fuzz/reading.h"
#include "tests/fuzz/target.h"
#include "tests/unit/game/test_level.h"
#include "tools/scene_generator/glb_bytes.h"

namespace lanthorn::fuzz {

namespace {

using namespace lanthorn::game;

constexpr std::size_t kSaveHead = 32;  // progress.cpp: mark, version, bytes of words, bytes, hash

void play(std::string_view bytes) {
    const auto path = write_input(bytes.starts_with("glTF") ? "level.glb" : "level.gltf", bytes);
    const SceneData scene = import_gltf(path);
    Played game(scene);
    game.walk(1, 3);
    game.press(kUse);
    game.press(kCarry);
    game.steps(3);
    const ecs::Registry& registry = game.session.app().registry();
    const std::string stored = ecs::Snapshot::save(game.world(), registry).to_bytes();
    ecs::Snapshot::from_bytes(stored, registry, "snapshot").restore(game.world());
    game.steps(1);
}

void parse(std::string_view bytes) {
    std::vector<std::string> arguments = {"lamplighter"};
    for (std::size_t at = 0; at <= bytes.size();) {
        const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
        arguments.emplace_back(bytes.substr(at, end - at));
        at = end + 1;
    }
    std::vector<const char*> argv;
    std::ranges::transform(arguments, std::back_inserter(argv),
                           [](const std::string& a) { return a.c_str(); });
    const Quiet quiet;
    parse_options(static_cast<int>(argv.size()), argv.data());
}

std::string sealed_progress(std::string bytes) {
    if (bytes.size() >= kSaveHead) {
        const std::string_view rest = std::string_view(bytes).substr(kSaveHead);
        const std::uint64_t size = rest.size(), hash = replay::hash_bytes(std::as_bytes(std::span(rest)));
        std::memcpy(&bytes[16], &size, sizeof size);
        std::memcpy(&bytes[24], &hash, sizeof hash);
    }
    return bytes;
}

}  // namespace

void read_game(std::string_view input) {
    if (input.empty()) {
        return;
    }
    const std::string bytes(input.substr(1));
    switch (input[0]) {
        case 'l':
            expect_refused_or_read([&] { play(bytes); });
            break;
        case 'o':
            expect_refused_or_read([&] { parse(bytes); });
            break;
        case 'p':
            expect_refused_or_read([&] {
                const Preferences once = preferences_from_json(bytes, "options.json");
                if (preferences_from_json(to_json(once), "again.json") != once) {
                    throw Finding("preferences that were written again differ");
                }
            });
            break;
        case 'b':
            expect_refused_or_read([&] {
                const input::Bindings once = read_bindings(bytes, "keys.json");
                if (read_bindings(once.to_json(), "again.json") != once) {
                    throw Finding("bindings that were written again differ");
                }
            });
            break;
        case 's':
            expect_refused_or_read([&] { progress_from_bytes(bytes, "progress"); });
            expect_refused_or_read([&] { progress_from_bytes(sealed_progress(bytes), "progress"); });
            break;
        default:
            break;
    }
}

std::vector<std::string> game_inputs() {
    Progress progress;
    progress.solved = {"red-wall"};
    progress.level = "shutter";
    progress.state = "state";
    return {"l" + scene_generator::glb_bytes(test_level().scene),
            "o--headless\n--frames\n3\n--out\npictures\n--size\n64x36\n--set\ngi.emc.count=4\n--seed\n5",
            "p" + to_json(Preferences()), "b" + usual_bindings().to_json(), "s" + to_bytes(progress)};
}

std::string damage_game(const std::string& input, Mutator& mutator) {
    if (input.empty() || std::string_view("lpb").find(input[0]) == std::string_view::npos) {
        return {};
    }
    const std::string damaged = damage_gltf(input.substr(1), mutator);
    return damaged.empty() ? damaged : input[0] + damaged;
}

}  // namespace lanthorn::fuzz
