// What playing takes up. It comes and goes with what moves and with the rooms in sight; whenever all is quiet
// it is the same again.
#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "game/quality.h"

#include "game/session.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/gpu/memory.h"
#include "tests/support/repository.h"

namespace lanthorn::game {
namespace {

// Somebody who walks and looks about and tries every button.
class Wanderer {
  public:
    PlayerInput next() {
        if (left_-- == 0) {
            left_ = whole(5, 50);
            input_.forward = axis(some(1) + 0.3);
            input_.right = axis(some(1));
            input_.yaw = look(some(0.15));
            input_.pitch = look(some(0.02));
            input_.held = static_cast<std::uint16_t>(whole(0, 511));
        }
        return input_;
    }

  private:
    // Of the same values with any C++ library.
    double some(double most) { return most * (2.0 * static_cast<double>(random_()) / 2147483647.0 - 1); }
    int whole(int least, int most) {
        return least + static_cast<int>(random_() % static_cast<unsigned>(most - least + 1));
    }

    std::minstd_rand random_{7};
    int left_ = 0;
    PlayerInput input_;
};

// How many of the names up to the next new one are those of objects.
template <class Gen, class Delete, class Is>
std::size_t living(Gen gen, Delete remove, Is is) {
    GLuint next = 0;
    gen(1, &next);
    remove(1, &next);
    std::size_t count = 0;
    for (GLuint name = 1; name < next; ++name) {
        count += is(name) == GL_TRUE;
    }
    return count;
}

struct Taken {
    std::size_t gpu = 0, heap = 0;  // bytes
    std::size_t textures = 0, buffers = 0, framebuffers = 0, queries = 0;
};

Taken taken() {
    const struct mallinfo2 heap = mallinfo2();
    return {gpu::allocated_bytes(),
            heap.uordblks + heap.hblkhd,
            living(glGenTextures, glDeleteTextures, glIsTexture),
            living(glGenBuffers, glDeleteBuffers, glIsBuffer),
            living(glGenFramebuffers, glDeleteFramebuffers, glIsFramebuffer),
            living(glGenQueries, glDeleteQueries, glIsQuery)};
}

Taken least(const Taken& a, const Taken& b) {
    return {std::min(a.gpu, b.gpu),
            std::min(a.heap, b.heap),
            std::min(a.textures, b.textures),
            std::min(a.buffers, b.buffers),
            std::min(a.framebuffers, b.framebuffers),
            std::min(a.queries, b.queries)};
}

TEST(Memory, OfALongSessionDoesNotGrow) {
    constexpr int kFrames = 200;  // of 5 steps
    constexpr int kFirst = 50;    // until everything is there
    const auto context = gpu::create_headless_context();
    Options options;
    options.preset = "low";
    options.level = support::repository_file("assets/lantern-room.glb");
    Session session(options, import_gltf(options.level));
    gi::add_picture_plugins(session.app(), Quality(options, 1).settings());
    session.app().view().size = ivec2(64, 36);
    Wanderer wanderer;
    session.set_devices([&] { return wanderer.next(); });
    const auto play = [&](int frames) {
        Taken quiet;
        for (int i = 0; i < frames; ++i) {
            session.app().frame(1.0 / 12, 6);
            quiet = i == 0 ? taken() : least(quiet, taken());
        }
        return quiet;
    };
    play(kFirst);
    const Taken first = play(kFrames), second = play(kFrames);
    // Some buffers keep the size of the most that they held.
    EXPECT_LE(static_cast<double>(second.gpu), 1.01 * static_cast<double>(first.gpu));
    EXPECT_LE(static_cast<double>(second.heap), 1.03 * static_cast<double>(first.heap));
    EXPECT_LE(second.textures, first.textures);
    EXPECT_LE(second.buffers, first.buffers);
    EXPECT_LE(second.framebuffers, first.framebuffers);
    EXPECT_LE(second.queries, first.queries);
}

}  // namespace
}  // namespace lanthorn::game
