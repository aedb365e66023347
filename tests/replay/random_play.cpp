// Records a session of random play: what no tour does, every button in every place. The same inputs for the
// same seed.
//   random_play LEVEL RECORDING SEED STEPS
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>

#include "game/presentation/playthrough.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"

namespace lanthorn::game {
namespace {

// A number that looks random, from counters (Steele et al. 2014, splitmix64).
std::uint64_t random(std::uint64_t seed, std::uint64_t counter) {
    std::uint64_t x = seed * 0xd1342543de82ef95u + counter * 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

constexpr std::uint64_t kMove = 45;   // steps that a way is kept
constexpr std::uint64_t kPress = 20;  // steps from press to press

PlayerInput input_of(std::uint64_t seed, std::uint64_t step) {
    PlayerInput input;
    const std::uint64_t way = random(seed, 2 * (step / kMove));
    input.forward = axis(way % 4 == 0 ? 0 : way % 4 == 1 ? -0.5 : 0.9);
    input.right = axis((static_cast<double>(way >> 8 & 0xff) - 128) / 200);
    input.yaw = static_cast<std::int16_t>(static_cast<int>(way >> 16 & 0x1ff) - 256);
    input.pitch =
        static_cast<std::int16_t>((step / kMove % 2 == 0 ? 1 : -1) * static_cast<int>(way >> 25 & 0x3f));
    constexpr std::uint16_t kButtons[] = {kUse,     kCarry,  kUse,  kLight, kDimUp,
                                          kDimDown, kColour, kView, kUse,   kHint};
    const std::uint64_t press = random(seed, 2 * (step / kPress) + 1);
    if (step % kPress < 1 + (press >> 32) % 6) {
        input.held = kButtons[press % std::size(kButtons)];
    }
    return input;
}

int record(const std::string& level, const std::string& file, std::uint64_t seed, std::uint64_t steps) {
    Options options;
    options.level = level;
    options.record = file;
    options.seed = seed;
    Playthrough playthrough(options, import_gltf(level));
    std::uint64_t step = 0;
    playthrough.set_devices([&] { return input_of(seed, step++); });
    while (step < steps) {
        playthrough.app().step();
    }
    playthrough.session().finish();
    return playthrough.session().recording_failed() ? 1 : 0;
}

}  // namespace
}  // namespace lanthorn::game

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: random_play LEVEL RECORDING SEED STEPS\n");
        return 2;
    }
    try {
        return lanthorn::game::record(argv[1], argv[2], std::strtoull(argv[3], nullptr, 10),
                                      std::strtoull(argv[4], nullptr, 10));
    } catch (const lanthorn::Error& error) {
        std::fprintf(stderr, "random_play: %s\n", error.what());
        return static_cast<int>(error.code());
    }
}
