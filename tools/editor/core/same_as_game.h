// The proof that the editor shows the game's light: a fresh App of the saved bytes draws the same frames.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "tools/editor/core/edit_session.h"

namespace lanthorn::editor {

// XXH3 of the bytes of what a frame's passes made, in their order.
struct FrameHashes {
    std::uint64_t gbuffer = 0, direct = 0, indirect = 0, final = 0;
    bool operator==(const FrameHashes&) const = default;
};

struct SameAsGame {
    FrameHashes editor, game;
    std::string first_difference;  // "gbuffer", "direct", "indirect", "final"; empty: none
    bool same() const { return first_difference.empty(); }
};

// Of the last frame of an App with picture plugins.
FrameHashes frame_hashes(const App& app);

// Draws the session's world and a fresh App of its document's bytes, both `frames` times from cold with the
// session's pose at `size` pixels, at moment 0. Makes contexts of its own, and adds no plugin to the
// session's App: its world is shown by a copy. Throws Error(ExitCode::no_gl) without OpenGL.
SameAsGame same_as_game(EditSession& session, const Settings& settings, ivec2 size, int frames);

// "lanthorn render crypt.glb --pose 1,2,3,90,0,60 --size 640x360 --frames 4 --time 0 ... -o crypt.png": the
// same picture, bit for bit. `settings` says what differs from the defaults.
std::string render_line(const EditSession& session, const Settings& settings, ivec2 size, int frames);

}  // namespace lanthorn::editor
