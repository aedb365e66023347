// Between the panels and the session: what panels ask for waits here until no frame is being drawn.
#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "tools/editor/core/edit_session.h"

namespace lanthorn::edit_window {

// Panels may ask at any time, also in the middle of a 3D frame. Nothing else writes the world.
class CommandDesk {
  public:
    // Lines as one step.
    void run(std::string text, std::vector<std::string> lines);
    // The gesture's newest state; the first of them begins it. An older one that still waits is dropped.
    void preview(std::string text, std::vector<std::string> lines);
    void commit();
    void cancel();
    // Whatever else needs the session: undo, save, open, select.
    void act(std::function<void(editor::EditSession&)> what);

    bool waiting() const { return !waiting_.empty(); }
    bool gesture() const { return gesture_; }  // one is begun, or will be
    // Does all that waits, in order. What fails is told to `say` in one line, and the rest goes on. Between
    // frames alone.
    void apply(editor::EditSession& session, const std::function<void(const std::string&)>& say);

  private:
    struct Lines {
        bool preview = false;
        std::string text;
        std::vector<std::string> lines;
    };
    struct End {
        bool keep = true;
    };
    using Act = std::function<void(editor::EditSession&)>;
    std::vector<std::variant<Lines, End, Act>> waiting_;
    bool gesture_ = false;
};

}  // namespace lanthorn::edit_window
