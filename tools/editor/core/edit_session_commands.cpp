// An editing session: commands, gestures, undo.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "lanthorn/core/error.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/session_state.h"

namespace lanthorn::editor {

namespace {

// A whole number of 0 or more behind undo, redo and go-to.
std::size_t count_in(const std::vector<std::string>& words, std::size_t otherwise) {
    if (words.size() == 1) {
        return otherwise;
    }
    std::size_t count = 0;
    const std::string& text = words[1];
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (words.size() > 2 || problem != std::errc() || end != text.data() + text.size()) {
        throw InputError(fmt::format("{}: found '{}', expected a whole number", words[0], text));
    }
    return count;
}

// What people call a command: "move lamp_2".
std::string title_of(const Command& command) {
    const std::string verb = command.text.substr(0, command.text.find(' '));
    const std::size_t slash = command.path.rfind('/');
    const std::string what = slash == std::string::npos ? command.path : command.path.substr(slash + 1);
    if (verb == "set" || verb == "unset" || verb == "set-material") {
        const std::vector<std::string> words = words_of(command.text);
        return fmt::format("{} {} {}", verb, verb == "set-material" ? words[1] : what,
                           words.size() > 2 ? words[2] : "");
    }
    return what.empty() ? verb : verb + ' ' + what;
}

}  // namespace

void EditSession::State::check_no_gesture(std::string_view what) const {
    if (!open) {
        throw InputError(fmt::format("{}: no scene is open, expected open FILE or new-room before it", what));
    }
    if (gesture) {
        throw InputError(
            fmt::format("{}: '{}' is going on, expected its end before it", what, gesture->text));
    }
}

void EditSession::State::show(const EditModel& now) {
    world.show(now);
    std::erase_if(selection, [&](std::uint32_t node) { return now.find(node) == nullptr; });
    shown_again();
}

void EditSession::State::add_step(std::string text, std::vector<Command> commands) {
    if (commands.empty()) {
        return;
    }
    EditStep step{std::move(text), std::move(commands), selection, now_seconds()};
    if (step.text.empty()) {
        step.text = title_of(step.commands.front());
    }
    if (saved_position && *saved_position > history.position()) {
        saved_position.reset();  // what is on disk is no step any more
    }
    const bool alters_material = std::ranges::any_of(
        step.commands, [](const Command& command) { return command.path.starts_with("material "); });
    history.add(std::move(step), context());
    decided_dark = decided_dark && !alters_material;  // a lamp's glass may have begun to shine
    previewed.reset();
    show(history.model());
    lend_if_dark();
    log_step(history.steps().back());
}

void EditSession::State::go_to(std::size_t position) {
    history.go_to(position, context());
    previewed.reset();
    show(history.model());
    lend_if_dark();
}

void EditSession::run(std::string_view line) {
    State& s = *state_;
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) {
        return;
    }
    s.check_no_gesture(words[0]);
    const std::string& verb = words[0];
    if (verb == "undo" || verb == "redo") {
        for (std::size_t i = count_in(words, 1); i > 0; --i) {
            if ((verb == "undo" ? undo() : redo()) == nullptr) {
                throw InputError(fmt::format("{}: there is nothing to {}", verb, verb));
            }
        }
    } else if (verb == "go-to") {
        const std::size_t row = count_in(words, s.history.steps().size() + 1);
        if (row > s.history.steps().size()) {
            throw InputError(
                fmt::format("go-to: found row {}, expected 0 to {}", row, s.history.steps().size()));
        }
        go_to(row);
    } else if (verb == "select") {
        std::vector<std::uint32_t> nodes;
        for (std::size_t i = 1; i < words.size(); ++i) {
            nodes.push_back(node_at(words[i]));
        }
        select(std::move(nodes));
    } else if (verb == "adopt") {
        adopt();
    } else {
        EditModel model = s.history.model();
        s.add_step({}, {apply_command(model, s.context(), line)});
    }
}

void EditSession::run(std::string_view text, std::span<const std::string> lines) {
    begin(text);
    try {
        preview(lines);
        commit();
    } catch (...) {
        cancel();
        throw;
    }
}

void EditSession::begin(std::string_view text) {
    state_->check_no_gesture("begin");
    state_->gesture = State::Gesture{std::string(text), {}, state_->selection};
}

void EditSession::preview(std::span<const std::string> lines) {
    State& s = *state_;
    if (!s.gesture) {
        throw InputError("preview: no gesture is going on, expected begin before it");
    }
    EditModel model = s.history.model();
    std::vector<Command> commands;
    for (const std::string& line : lines) {
        commands.push_back(apply_command(model, s.context(), line));
    }
    s.gesture->commands = std::move(commands);
    s.previewed = model;
    s.show(model);
}

void EditSession::commit() {
    State& s = *state_;
    if (!s.gesture) {
        throw InputError("commit: no gesture is going on, expected begin before it");
    }
    State::Gesture done = *std::exchange(s.gesture, std::nullopt);
    try {
        s.add_step(std::move(done.text), std::move(done.commands));
    } catch (...) {  // the document does not allow it
        s.previewed.reset();
        s.show(s.history.model());
        throw;
    }
}

void EditSession::cancel() {
    State& s = *state_;
    s.gesture.reset();
    if (s.previewed) {
        s.previewed.reset();
        s.show(s.history.model());
    }
}

bool EditSession::in_gesture() const {
    return state_->gesture.has_value();
}

bool EditSession::can_undo() const {
    return state_->open && !state_->gesture && state_->history.position() > 0;
}

bool EditSession::can_redo() const {
    return state_->open && !state_->gesture && state_->history.position() < state_->history.steps().size();
}

const EditStep* EditSession::undo() {
    State& s = *state_;
    if (!can_undo()) {
        return nullptr;
    }
    const std::size_t position = s.history.position() - 1;
    s.go_to(position);
    const EditStep& step = s.history.steps()[position];
    select(step.selection);
    s.log_move(position + 1);
    return &step;
}

const EditStep* EditSession::redo() {
    State& s = *state_;
    if (!can_redo()) {
        return nullptr;
    }
    const std::size_t position = s.history.position();
    s.go_to(position + 1);
    const EditStep& step = s.history.steps()[position];
    select(step.selection);
    s.log_move(position);
    return &step;
}

void EditSession::go_to(std::size_t row) {
    State& s = *state_;
    s.check_no_gesture("go-to");
    const std::size_t from = s.history.position();
    s.go_to(std::min(row, s.history.steps().size()));
    s.log_move(from);
}

std::vector<HistoryRow> EditSession::history() const {
    const State& s = *state_;
    std::vector<HistoryRow> rows;
    if (!s.open) {
        return rows;
    }
    rows.push_back({s.path.empty() ? "new room" : "open " + s.path.filename().string(), 0, false, false});
    for (const EditStep& step : s.history.steps()) {
        rows.push_back({step.text, step.seconds, false, false});
    }
    rows[s.history.position()].current = true;
    if (s.saved_position && *s.saved_position < rows.size()) {
        rows[*s.saved_position].saved = true;
    }
    return rows;
}

const EditHistory& EditSession::steps() const {
    return state_->history;
}

const std::vector<std::uint32_t>& EditSession::selection() const {
    return state_->selection;
}

void EditSession::select(std::vector<std::uint32_t> nodes) {
    std::erase_if(nodes, [&](std::uint32_t node) { return model().find(node) == nullptr; });
    state_->selection = std::move(nodes);
}

}  // namespace lanthorn::editor
