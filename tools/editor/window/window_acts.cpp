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

bool EditorWindow::State::act_on_scene(Act what) {
    EditorState& e = *editor;
    const auto paths = [&](const char* command) {
        std::vector<std::string> lines;
        for (const std::uint32_t node : e.chosen) {
            const bool within = std::ranges::any_of(e.chosen, [&](std::uint32_t other) {
                return other != node && session.model().is_within(node, other);
            });
            if (session.model().find(node) != nullptr && !within) {
                lines.push_back(fmt::format("{} {}", command, editor::word(session.path_of(node))));
            }
        }
        return lines;
    };
    const auto step = [&](bool back) {
        e.desk.act([&e, back, this](EditSession& edited) {
            const EditStep* done = back ? edited.undo() : edited.redo();
            e.say(done == nullptr ? (back ? "nothing to undo" : "nothing to redo")
                                  : fmt::format("{}: {}", back ? "undid" : "did again", done->text),
                  now());
            e.pace.changed(now(), false);
        });
    };
    const bool open = session.is_open();
    switch (what) {
        case Act::undo:
            if (open) {
                step(true);
            }
            break;
        case Act::redo:
            if (open) {
                step(false);
            }
            break;
        case Act::duplicate:
        case Act::group: {
            std::vector<std::string> lines = paths("duplicate");
            if (lines.empty()) {
                break;
            }
            if (what == Act::group) {
                std::string all = "group group";
                for (const std::uint32_t node : e.chosen) {
                    all += " " + editor::word(session.path_of(node));
                }
                lines = {all};
            }
            e.run(what == Act::group ? "group" : "duplicate", std::move(lines));
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
            break;
        }
        case Act::remove:
            if (!e.chosen.empty()) {
                e.run(fmt::format("delete {}", e.chosen.size() == 1
                                                   ? editor::called(session.model(), e.chosen.front())
                                                   : fmt::format("{} things", e.chosen.size())),
                      paths("delete"));
                e.select({});
            }
            break;
        case Act::hide:
            if (!e.chosen.empty()) {
                e.run("hide", paths("hide"));
            }
            break;
        case Act::show_all: {
            std::vector<std::string> lines;
            for (const std::uint32_t node : session.model().in_order()) {
                if (!session.model().node(node).visible) {
                    lines.push_back("show " + editor::word(session.path_of(node)));
                }
            }
            if (!lines.empty()) {
                e.run("show all", std::move(lines));
            }
            break;
        }
        case Act::select_all:
            e.select(session.model().in_order());
            break;
        case Act::deselect:
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
            open&& e.dirty ? void(e.sheet = Sheet::quit) : void(e.close = true);
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

bool EditorWindow::State::act_on_view(Act what) {
    EditorState& e = *editor;
    const double at = now();
    const auto view = [&](const char* name) {
        e.picture.set_view(e.picture.view() == name ? "final" : name);
        e.pace.changed(at, false);
    };
    switch (what) {
        case Act::helpers:
            e.helpers = !e.helpers;
            break;
        case Act::compare:
            if (session.is_open()) {
                e.desk.act([this](EditSession&) {
                    viewport->compare(editor->other_side ? nullptr : viewport->kept_side(), now());
                });
            }
            break;
        case Act::compare_technique:
            if (session.is_open()) {
                if (e.other_side && e.other_side->as) {
                    e.compare(nullptr);
                } else {
                    // The one of last time, if it is another and this program has it.
                    const std::string now_drawn = e.drawn_as().technique();
                    std::string other = e.compare_with;
                    for (const std::string& name : gi::technique_names()) {
                        const bool fits = other != now_drawn && gi::find_technique(other) != nullptr;
                        other = fits ? other : name;
                    }
                    e.compare_as(editor::drawn_as(other, e.drawn_as()));
                }
            }
            break;
        case Act::play_clip:
            if (e.timeline.shown() == nullptr) {
                e.say(e.timeline.clips.empty() ? "no clip in this file"
                                               : "no clip is shown: the timeline has them",
                      at);
            } else {
                e.timeline.play(!e.timeline.playing, at);
            }
            break;
        case Act::compare_menu:
            e.compare_menu = session.is_open();
            break;
        case Act::copy_render_line:
            if (session.is_open()) {
                const std::string line = render_line(session, e.settings, {e.picture.facts().size, 4});
                glfwSetClipboardString(window.context().handle(), line.c_str());
                e.say(e.dirty ? "copied; it gives this picture once the scene is saved" : "copied: " + line,
                      at);
            }
            break;
        case Act::why_light: {
            const std::optional<vec2> place = viewport->pointed_place();
            if (!place || !session.is_open()) {
                e.say("point at a surface first", at);
                break;
            }
            e.desk.act([this, place = *place](EditSession&) { ask_why(place); });
            e.drawer_tab = kWhyTab;
            if (!e.splits.drawer_open) {
                e.splits.drawer_open = true;
                e.pace.changed(at, false);
            }
            break;
        }
        case Act::view_final:
            e.error_shown = false;
            view("final");
            break;
        case Act::view_direct:
            view("direct");
            break;
        case Act::view_indirect:
            view("indirect");
            break;
        case Act::view_albedo:
            view("albedo");
            break;
        case Act::view_normals:
            view("normals");
            break;
        case Act::view_depth:
            view("depth");
            break;
        case Act::view_error:
            e.error_shown = !e.error_shown;
            break;
        case Act::view_lux:
            view("lux");
            break;
        case Act::reference:
            if (e.draws_reference()) {
                leave_reference();
            } else {
                enter_reference();
            }
            break;
        case Act::view_coverage:
        case Act::view_next_debug: {
            const gi::TechniqueEntry* entry = gi::find_technique(e.settings.text("gi.technique"));
            if (entry == nullptr || entry->debug_views.empty()) {
                e.say("this technique has no views of its own", at);
                break;
            }
            const auto& views = entry->debug_views;
            auto found = std::ranges::find(views, what == Act::view_coverage ? "coverage" : e.picture.view(),
                                           &gi::DebugView::name);
            if (what == Act::view_next_debug) {
                found = found == views.end() || found + 1 == views.end() ? views.begin() : found + 1;
            }
            if (found == views.end()) {
                e.say("this technique has no view of that kind", at);
                break;
            }
            view(found->name.c_str());
            break;
        }
        case Act::lock_exposure: {
            const Renderer& renderer = session.world().resource<Renderer>();
            if (!e.exposure_locked && renderer.frame) {
                e.locked_ev = static_cast<float>(
                    editor::ev100_of(e.settings, static_cast<double>(renderer.frame->exposure())));
            }
            e.exposure_locked = !e.exposure_locked && renderer.frame;
            e.settings_changed = true;
            break;
        }
        case Act::only_picture:
            e.splits.only_picture = !e.splits.only_picture;
            e.pace.changed(at, false);
            break;
        case Act::help:
            e.sheet = e.sheet == Sheet::help ? Sheet::none : Sheet::help;
            break;
        case Act::larger_text:
        case Act::smaller_text:
        case Act::usual_text:
            e.text_scale = what == Act::usual_text
                               ? 1
                               : std::clamp(e.text_scale + (what == Act::larger_text ? 0.25 : -0.25),
                                            kSmallestText, kLargestText);
            e.fonts_changed = true;
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
    (void)(act_on_scene(what) || act_on_file(what) || act_on_view(what));
    settling = kSettlingFrames;
}

}  // namespace lanthorn::edit_window
