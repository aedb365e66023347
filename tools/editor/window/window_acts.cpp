// What keys, menus and buttons stand for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/gi/technique.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/same_as_game.h"
#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

using editor::EditSession;
using editor::EditStep;

void EditorWindow::State::step_history(bool back) {
    editor->desk.act([this, back](EditSession& edited) {
        const EditStep* done = back ? edited.undo() : edited.redo();
        editor->say(done == nullptr ? (back ? "nothing to undo" : "nothing to redo")
                                    : fmt::format("{}: {}", back ? "undid" : "did again", done->text),
                    now());
        editor->pace.changed(now(), false);
    });
}

// "COMMAND NODE" for each that is chosen, and stands within no other.
std::vector<std::string> EditorWindow::State::of_chosen(const char* command) const {
    const std::vector<std::uint32_t>& chosen = editor->chosen;
    std::vector<std::string> lines;
    for (const std::uint32_t node : chosen) {
        const bool within = std::ranges::any_of(chosen, [&](std::uint32_t other) {
            return other != node && session.model().is_within(node, other);
        });
        if (session.model().find(node) != nullptr && !within) {
            lines.push_back(fmt::format("{} {}", command, editor::word(session.path_of(node))));
        }
    }
    return lines;
}

void EditorWindow::State::run_and_choose(const char* name, std::vector<std::string> lines) {
    EditorState& e = *editor;
    e.run(name, std::move(lines));
    e.desk.act([&e](EditSession& edited) {
        std::vector<std::uint32_t> made;
        const auto& steps = edited.steps();
        if (steps.position() > 0) {
            for (const editor::Command& command : steps.steps()[steps.position() - 1].commands) {
                if (!command.made.empty()) {
                    made.push_back(command.made.front());
                }
            }
        }
        edited.select(made);
        e.reveal = made.empty() ? kNone : made.back();
    });
}

void EditorWindow::State::group_chosen() {
    if (of_chosen("group").empty()) {
        return;
    }
    std::string line = "group group";
    for (const std::uint32_t node : editor->chosen) {
        line += " " + editor::word(session.path_of(node));
    }
    run_and_choose("group", {line});
}

void EditorWindow::State::show_all() {
    std::vector<std::string> lines;
    for (const std::uint32_t node : session.model().in_order()) {
        if (!session.model().node(node).visible) {
            lines.push_back("show " + editor::word(session.path_of(node)));
        }
    }
    if (!lines.empty()) {
        editor->run("show all", std::move(lines));
    }
}

void EditorWindow::State::step_back() {
    EditorState& e = *editor;
    const bool open = session.is_open();
    if (e.fields.dragging()) {
        e.fields.let_go();
    } else if (e.desk.gesture() || viewport->gesture()) {
        viewport->cancel();
    } else if (!e.places.empty()) {
        e.places.clear();
    } else if (e.wishes.placing) {
        viewport->drop_wish();
        e.wishes.placing = false;
    } else if (e.sheet != Sheet::none && open) {
        e.sheet = Sheet::none;
    } else if (!e.problem.empty()) {
        e.problem.clear();
    } else if (e.why) {
        e.why.reset();
    } else if (open && e.traced.due()) {
        leave_reference();
    } else {
        e.select({});
    }
}

bool EditorWindow::State::act_on_scene(Act what) {
    EditorState& e = *editor;
    switch (what) {
        case Act::undo:
        case Act::redo:
            if (session.is_open()) {
                step_history(what == Act::undo);
            }
            break;
        case Act::duplicate:
            if (std::vector<std::string> lines = of_chosen("duplicate"); !lines.empty()) {
                run_and_choose("duplicate", std::move(lines));
            }
            break;
        case Act::group:
            group_chosen();
            break;
        case Act::remove:
            if (!e.chosen.empty()) {
                e.run(fmt::format("delete {}", e.chosen.size() == 1
                                                   ? editor::called(session.model(), e.chosen.front())
                                                   : fmt::format("{} things", e.chosen.size())),
                      of_chosen("delete"));
                e.select({});
            }
            break;
        case Act::hide:
            if (!e.chosen.empty()) {
                e.run("hide", of_chosen("hide"));
            }
            break;
        case Act::show_all:
            show_all();
            break;
        case Act::select_all:
            e.select(session.model().in_order());
            break;
        case Act::deselect:
            step_back();
            break;
        default:
            return false;
    }
    return true;
}

bool EditorWindow::State::act_on_file(Act what) {
    EditorState& e = *editor;
    const double at = now();
    const bool open = session.is_open();
    switch (what) {
        case Act::save:
            if (open) {
                e.changes.reset();
                e.sheet = session.path().empty()      ? Sheet::save_as
                          : session.changed_outside() ? Sheet::file_changed
                                                      : Sheet::save;
                if (e.sheet == Sheet::save && !e.dirty) {
                    e.sheet = Sheet::none;
                    e.say("nothing to save: the file is as it was", at);
                }
            }
            break;
        case Act::save_as:
            if (open) {
                e.sheet = Sheet::save_as;
            }
            break;
        case Act::open:
            e.sheet = Sheet::open;
            e.save_name.clear();
            break;
        case Act::new_room:
            e.sheet = Sheet::none;
            e.desk.act([this](EditSession& edited) {
                edited.new_room();
                editor->opened = true;
            });
            break;
        case Act::quit:
            if (open && e.dirty) {
                e.sheet = Sheet::quit;
            } else {
                e.close = true;
            }
            break;
        case Act::review:
            if (open) {
                e.say("writing the review page ...", at);
                e.desk.act([this](EditSession&) { write_review_page(); });
            }
            break;
        case Act::check_game:
            if (open) {
                e.desk.act([this](EditSession&) { check_game(); });
            }
            break;
        case Act::play:
            if (open) {
                e.desk.act([this](EditSession&) { play_here(); });
            }
            break;
        case Act::still_solvable:
            if (open) {
                e.desk.act([this](EditSession&) { ask_solvable(); });
            }
            break;
        case Act::screenshot:
            e.desk.act([this](EditSession&) {
                draw_panels(false);
                editor->say("kept " + window.keep_screenshot("lanthorn").string(), now());
            });
            break;
        default:
            return false;
    }
    return true;
}

void EditorWindow::State::leave_reference() {
    editor->leave_reference();
    editor->say("drawn by " + editor->settings.text("gi.technique") + " again", now());
}

void EditorWindow::State::enter_reference() {
    const auto& all = gi::techniques();
    const auto found = std::ranges::find_if(all, &gi::TechniqueEntry::is_reference);
    if (found == all.end()) {
        editor->say("this program has no path tracer among its techniques", now());
        return;
    }
    editor->set_technique(found->name);
}

void EditorWindow::State::show_view(const std::string& name) {
    EditorState& e = *editor;
    e.picture.set_view(e.picture.view() == name ? "final" : name);
    e.pace.changed(now(), false);
}

void EditorWindow::State::show_debug_view(bool next) {
    EditorState& e = *editor;
    const gi::TechniqueEntry* entry = gi::find_technique(e.settings.text("gi.technique"));
    if (entry == nullptr || entry->debug_views.empty()) {
        e.say("this technique has no views of its own", now());
        return;
    }
    const auto& all = entry->debug_views;
    auto found = std::ranges::find(all, next ? e.picture.view() : "coverage", &gi::DebugView::name);
    if (next) {
        found = found == all.end() || found + 1 == all.end() ? all.begin() : found + 1;
    }
    if (found == all.end()) {
        e.say("this technique has no view of that kind", now());
        return;
    }
    show_view(found->name);
}

void EditorWindow::State::compare_technique() {
    EditorState& e = *editor;
    if (e.other_side && e.other_side->as) {
        e.compare(nullptr);
        return;
    }
    // The one of last time, if it is another and this program has it.
    const std::string now_drawn = e.drawn_as().technique();
    std::string other = e.compare_with;
    for (const std::string& name : gi::technique_names()) {
        const bool fits = other != now_drawn && gi::find_technique(other) != nullptr;
        other = fits ? other : name;
    }
    e.compare_as(editor::drawn_as(other, e.drawn_as()));
}

void EditorWindow::State::play_clip() {
    EditorState& e = *editor;
    if (e.timeline.shown() == nullptr) {
        e.say(e.timeline.clips.empty() ? "no clip in this file" : "no clip is shown: the timeline has them",
              now());
    } else {
        e.timeline.play(!e.timeline.playing, now());
    }
}

void EditorWindow::State::copy_render_line() {
    EditorState& e = *editor;
    const std::string line = render_line(session, e.settings, {e.picture.facts().size, 4});
    glfwSetClipboardString(window.context().handle(), line.c_str());
    e.say(e.dirty ? "copied; it gives this picture once the scene is saved" : "copied: " + line, now());
}

void EditorWindow::State::ask_why_there() {
    EditorState& e = *editor;
    const std::optional<vec2> place = viewport->pointed_place();
    if (!place || !session.is_open()) {
        e.say("point at a surface first", now());
        return;
    }
    e.desk.act([this, place = *place](EditSession&) { ask_why(place); });
    e.drawer_tab = kWhyTab;
    if (!e.splits.drawer_open) {
        e.splits.drawer_open = true;
        e.pace.changed(now(), false);
    }
}

void EditorWindow::State::lock_exposure() {
    EditorState& e = *editor;
    const Renderer& renderer = session.world().resource<Renderer>();
    if (!e.exposure_locked && renderer.frame) {
        e.locked_ev =
            static_cast<float>(editor::ev100_of(e.settings, static_cast<double>(renderer.frame->exposure())));
    }
    e.exposure_locked = !e.exposure_locked && renderer.frame;
    e.settings_changed = true;
}

void EditorWindow::State::scale_text(Act what) {
    EditorState& e = *editor;
    const double by = what == Act::larger_text ? 0.25 : -0.25;
    e.text_scale = what == Act::usual_text ? 1 : std::clamp(e.text_scale + by, kSmallestText, kLargestText);
    e.fonts_changed = true;
}

// What is shown in the place of the picture.
bool EditorWindow::State::act_on_shown_view(Act what) {
    switch (what) {
        case Act::view_final:
            editor->error_shown = false;
            show_view("final");
            break;
        case Act::view_direct:
            show_view("direct");
            break;
        case Act::view_indirect:
            show_view("indirect");
            break;
        case Act::view_albedo:
            show_view("albedo");
            break;
        case Act::view_normals:
            show_view("normals");
            break;
        case Act::view_depth:
            show_view("depth");
            break;
        case Act::view_lux:
            show_view("lux");
            break;
        case Act::view_error:
            editor->error_shown = !editor->error_shown;
            break;
        case Act::view_coverage:
        case Act::view_next_debug:
            show_debug_view(what == Act::view_next_debug);
            break;
        case Act::reference:
            editor->draws_reference() ? leave_reference() : enter_reference();
            break;
        default:
            return false;
    }
    return true;
}

bool EditorWindow::State::act_on_window(Act what) {
    EditorState& e = *editor;
    const bool open = session.is_open();
    switch (what) {
        case Act::helpers:
            e.helpers = !e.helpers;
            break;
        case Act::compare:
            if (open) {
                e.desk.act([this](EditSession&) {
                    viewport->compare(editor->other_side ? nullptr : viewport->kept_side(), now());
                });
            }
            break;
        case Act::compare_technique:
            if (open) {
                compare_technique();
            }
            break;
        case Act::play_clip:
            play_clip();
            break;
        case Act::compare_menu:
            e.compare_menu = open;
            break;
        case Act::copy_render_line:
            if (open) {
                copy_render_line();
            }
            break;
        case Act::why_light:
            ask_why_there();
            break;
        case Act::lock_exposure:
            lock_exposure();
            break;
        case Act::only_picture:
            e.splits.only_picture = !e.splits.only_picture;
            e.pace.changed(now(), false);
            break;
        case Act::help:
            e.sheet = e.sheet == Sheet::help ? Sheet::none : Sheet::help;
            break;
        case Act::larger_text:
        case Act::smaller_text:
        case Act::usual_text:
            scale_text(what);
            break;
        default:
            return false;
    }
    return true;
}

void EditorWindow::State::act(Act what) {
    if (what == Act::none || viewport->act(what, now())) {
        return;
    }
    (void)(act_on_scene(what) || act_on_file(what) || act_on_shown_view(what) || act_on_window(what));
    settling = kSettlingFrames;
}

}  // namespace lanthorn::edit_window
