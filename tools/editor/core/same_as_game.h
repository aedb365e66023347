// The proof that the editor shows the game's light: a fresh App of the saved bytes draws the same frames.
#pragma once

#include <cstdint>
#include <string>

#include "lanthorn/core/settings.h"
#include "tools/editor/core/edit_session.h"

namespace lanthorn::editor {

// XXH3 of the bytes of what a frame's passes made, in their order.
struct FrameHashes {
    std::uint64_t gbuffer = 0, direct = 0, indirect = 0, final = 0;
    bool operator==(const FrameHashes&) const = default;
};

// Which pictures are compared.
struct CheckedFrames {
    ivec2 size{640, 360};  // pixels
    int frames = 4;        // drawn from cold; the last one counts
};

struct SameAsGame {
    FrameHashes editor, game;
    std::string first_difference;  // "gbuffer", "direct", "indirect", "final"; empty: none
    bool same() const { return first_difference.empty(); }
};

// Of the last frame of an App with picture plugins.
FrameHashes frame_hashes(const App& app);

// Forgets all that frames before have left: the next frame is as a fresh App's first. What is drawn by the
// App's OpenGL objects goes, so whoever holds any of them lets go before.
void make_cold(App& app);

// All that follows needs a current OpenGL context that outlives the session. The moment is the session's.

// The next frame of the session's App is one from cold, of its world as it is seen from its pose. Picture
// plugins are added to it if it has none; its first view has this size then.
void begin_cold(EditSession& session, const Settings& settings, ivec2 size);
// So many of them.
FrameHashes editor_frames(EditSession& session, const Settings& settings, const CheckedFrames& what);
// A fresh App of the document's bytes, likewise.
FrameHashes game_frames(const EditSession& session, const Settings& settings, const CheckedFrames& what);
// Both. The light that is lent to a scene without any is found again first.
SameAsGame same_as_game(EditSession& session, const Settings& settings, const CheckedFrames& what);

// "lanthorn render crypt.glb --pose 1,2,3,90,0 --size 640x360 --frames 1 --warmup 3 --time 0 --set ... -o
// crypt.png": once the session is saved, the same picture bit for bit.
std::string render_line(const EditSession& session, const Settings& settings, const CheckedFrames& what);

}  // namespace lanthorn::editor
