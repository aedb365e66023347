// What playing takes up. It comes and goes with what moves and with the rooms in sight; whenever all is quiet
// it is the same again.
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/shell/holdings.h"
#include "game/presentation/playthrough.h"
#include "game/presentation/quality.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/gpu/context.h"
#include "tests/gpu/game/wanderer.h"
#include "tests/support/repository.h"

namespace lanthorn::game {
namespace {

shell::Holdings least(const shell::Holdings& a, const shell::Holdings& b) {
    return {.heap = std::min(a.heap, b.heap),
            .gpu = std::min(a.gpu, b.gpu),
            .textures = std::min(a.textures, b.textures),
            .buffers = std::min(a.buffers, b.buffers),
            .framebuffers = std::min(a.framebuffers, b.framebuffers),
            .queries = std::min(a.queries, b.queries),
            .programs = std::min(a.programs, b.programs),
            .files = std::min(a.files, b.files),
            .threads = std::min(a.threads, b.threads)};
}

TEST(Memory, OfALongSessionDoesNotGrow) {
    constexpr int kFrames = 100;  // of 5 steps
    constexpr int kFirst = 50;    // until everything is there
    const auto context = gpu::create_headless_context();
    Options options;
    options.preset = "low";
    options.level = support::repository_file("assets/lantern-room.glb");
    Playthrough playthrough(options, import_gltf(options.level));
    session::Session& session = playthrough.session();
    Quality(options, 1).draw(session.app());
    session.app().view().size = ivec2(64, 36);
    Wanderer wanderer;
    playthrough.set_devices([&] { return wanderer.next(); });
    const auto play = [&](int frames) {
        shell::Holdings quiet;
        for (int i = 0; i < frames; ++i) {
            session.app().frame(1.0 / 12, 6);
            quiet = i == 0 ? shell::holdings() : least(quiet, shell::holdings());
        }
        return quiet;
    };
    play(kFirst);
    const shell::Holdings first = play(kFrames), second = play(kFrames);
    // Some buffers keep the size of the most that they held.
    EXPECT_LE(static_cast<double>(second.gpu), 1.01 * static_cast<double>(first.gpu));
    EXPECT_LE(static_cast<double>(second.heap), 1.03 * static_cast<double>(first.heap));
    EXPECT_LE(second.textures, first.textures);
    EXPECT_LE(second.buffers, first.buffers);
    EXPECT_LE(second.framebuffers, first.framebuffers);
    EXPECT_LE(second.queries, first.queries);
    EXPECT_LE(second.files, first.files);
    EXPECT_LE(second.threads, first.threads);
}

}  // namespace
}  // namespace lanthorn::game
