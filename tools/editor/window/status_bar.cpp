// The status bar below the picture: what is open, what it takes, how wrong it is, and what can be done next.
#include <fmt/format.h>
#include <imgui.h>

#include <string>

#include "tools/editor/window/panels.h"
#include "tools/editor/window/quantity.h"

namespace lanthorn::edit_window {

namespace {

// Fields side by side; they drop from the right as room ends.
class Fields {
  public:
    explicit Fields(float unit) : gap_(14 * unit) {}

    // Whether it was clicked. An empty hint: none.
    bool field(const std::string& words, ImU32 shade, const std::string& hint = "") const {
        const float width = ImGui::CalcTextSize(words.c_str()).x + gap_;
        if (ImGui::GetCursorPosX() + width > right_) {
            return false;
        }
        ImGui::PushStyleColor(ImGuiCol_Text, shade);
        ImGui::TextUnformatted(words.c_str());
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered() && !hint.empty()) {
            ImGui::SetTooltip("%s", hint.c_str());
        }
        const bool clicked = ImGui::IsItemClicked();
        ImGui::SameLine(0, gap_);
        return clicked;
    }

  private:
    float gap_, right_ = ImGui::GetWindowContentRegionMax().x;
};

void show_times(const EditorState& state, const Fields& bar) {
    const PictureFacts& facts = state.picture.facts();
    const bool two = state.picture.other_is_new();
    bar.field(two ? fmt::format("{:.0f} + {:.0f} ms", state.picture.other_facts().ms, facts.ms)
                  : fmt::format("{:.0f} ms", facts.ms),
              colour::words, two ? "of A and of B in the last 3D frame" : "of the last 3D frame");
    bar.field(fmt::format("ui {:.1f} ms", state.figures.ui_ms), colour::faint, "of these panels");
}

void show_error(EditorState& state, const Fields& bar) {
    const bool measured = state.error && state.error_of_frame == state.picture.frames();
    if (!measured && state.estimate) {
        bar.field(
            fmt::format("error about {:.0f} % ({:.0f} to {:.0f})", 100 * state.estimate->value,
                        100 * state.estimate->low, 100 * state.estimate->high),
            colour::words,
            "the local error of the indirect light as the picture itself tells it; measured against the "
            "path tracer's while the picture rests");
    } else if (state.error &&
               bar.field(
                   (measured ? "error " : "error was ") + error_words(*state.error),
                   measured ? colour::words : colour::faint,
                   "the local error of the indirect light against the path tracer's, measured while the "
                   "picture rests; click: where")) {
        state.act(Act::view_error);
    }
}

void show_light(const EditorState& state, const Fields& bar) {
    if (state.lux_under_pointer) {
        bar.field(shown_number(*state.lux_under_pointer, 3) + " lx", colour::words,
                  "light that arrives under the pointer, as far as the picture tells");
    }
    for (const workbench::ContractVerdict& verdict : state.contracts) {
        if (!verdict.kept || state.contracts.size() <= 2) {
            bar.field(fmt::format("{} {} lx {}", verdict.contract.name, shown_number(verdict.mean, 3),
                                  verdict.kept ? "ok" : "broken"),
                      verdict.kept ? colour::good : colour::bad, contract_words(verdict));
        }
    }
}

// Whether it can be solved, and warnings; a click opens them.
void show_findings(EditorState& state, const Fields& bar) {
    const auto open = [&](int tab) {
        state.drawer_tab = tab;
        state.splits.drawer_open = true;
    };
    if (state.solve.solved) {
        const bool old = state.solve_version != state.session.version(), solvable = *state.solve.solved;
        const std::string words = std::string(old ? "was " : "") + (solvable ? "solvable" : "not solvable");
        if (bar.field(words,
                      old        ? colour::faint
                      : solvable ? colour::good
                                 : colour::bad,
                      state.solve.words)) {
            open(kSolveTab);
        }
    }
    std::size_t count = 0;
    for (const editor::EditWarning& warning : state.warnings) {
        count += state.never_mind.contains(warning.kind) ? 0 : 1;
    }
    if (bar.field(fmt::format("! {}", count), count > 0 ? colour::warning : colour::faint,
                  "warnings: click")) {
        open(kWarningsTab);
    }
}

}  // namespace

void draw_status(EditorState& state) {
    const Fields bar(state.unit);
    // Turns once a frame of the panels: a turn that never ends is a bug that one can see.
    constexpr const char* kTurn[] = {"|", "/", "-", "\\"};
    bar.field(kTurn[state.figures.ui_frames % 4], colour::faint, "turns once a frame of these panels");
    if (!state.session.is_open()) {
        bar.field("no scene", colour::faint);
        return;
    }
    const std::size_t edits = state.session.steps().position();
    const bool dirty = state.dirty;
    bar.field(dirty && edits == 0 ? std::string("* not saved")
              : dirty             ? fmt::format("* {} edit{}", edits, edits == 1 ? "" : "s")
                                  : "saved",
              dirty ? colour::chosen : colour::faint, "edits since the file was opened");
    show_times(state, bar);
    show_error(state, bar);
    show_light(state, bar);
    show_findings(state, bar);
    const std::string name =
        state.session.path().empty() ? "not in a file yet" : state.session.path().filename().string();
    bar.field(name + (dirty ? " *" : ""), colour::words, state.session.path().string());
    if (!state.reloaded.empty()) {
        bar.field(state.reloaded, colour::faint);
    }
    const char* hint =
        !state.places.empty() ? "click a surface: the light comes 0.3 m before it \u00b7 Esc: none"
        : state.chosen.empty()
            ? "click: choose \u00b7 middle: orbit \u00b7 right + WASD: fly \u00b7 F: look at \u00b7 F1: keys"
            : "drag a handle \u00b7 Ctrl: snap \u00b7 digits: typed \u00b7 Esc: back \u00b7 F1: keys";
    bar.field(hint, colour::faint);
}

}  // namespace lanthorn::edit_window
