#include "tools/editor/window/command_desk.h"

#include <utility>

#include "lanthorn/core/error.h"

namespace lanthorn::edit_window {

void CommandDesk::run(std::string text, std::vector<std::string> lines) {
    waiting_.emplace_back(Lines{false, std::move(text), std::move(lines)});
}

void CommandDesk::preview(std::string text, std::vector<std::string> lines) {
    gesture_ = true;
    if (!waiting_.empty()) {
        if (auto* last = std::get_if<Lines>(&waiting_.back()); last != nullptr && last->preview) {
            *last = {true, std::move(text), std::move(lines)};
            return;
        }
    }
    waiting_.emplace_back(Lines{true, std::move(text), std::move(lines)});
}

void CommandDesk::commit() {
    if (std::exchange(gesture_, false)) {
        waiting_.emplace_back(End{true});
    }
}

void CommandDesk::cancel() {
    if (std::exchange(gesture_, false)) {
        waiting_.emplace_back(End{false});
    }
}

void CommandDesk::act(std::function<void(editor::EditSession&)> what) {
    waiting_.emplace_back(std::move(what));
}

void CommandDesk::apply(editor::EditSession& session, const std::function<void(const std::string&)>& say) {
    // What is asked for meanwhile comes with the next call.
    for (auto& each : std::exchange(waiting_, {})) {
        try {
            if (auto* lines = std::get_if<Lines>(&each)) {
                if (!lines->preview) {
                    session.run(lines->text, lines->lines);
                    continue;
                }
                if (!session.in_gesture()) {
                    session.begin(lines->text);
                }
                session.preview(lines->lines);
            } else if (const auto* end = std::get_if<End>(&each)) {
                if (session.in_gesture()) {
                    end->keep ? session.commit() : session.cancel();
                }
            } else {
                std::get<Act>(each)(session);
            }
        } catch (const Error& error) {
            say(error.what());
        }
    }
}

}  // namespace lanthorn::edit_window
