// What is done between two frames, the 3D frame itself, and what is answered in the middle of it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/gpu/pass_end.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/scene/components.h"
#include "tools/editor/core/review_page.h"
#include "tools/editor/core/same_as_game.h"
#include "tools/editor/window/drag_quality.h"
#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

namespace {

// Seconds between panels drawn in a 3D frame for a pointer that moved; for one that drags something, which
// shows with the next frame alone.
constexpr double kMovesEvery = 0.03, kDraggedEvery = 0.15;
// And as many times what the panels took: in a window of 4K pixels they would take more than the picture.
constexpr double kTimesPanels = 4;
constexpr double kMostPixelsOnCpu = 1280 * 720;  // of a picture

// OpenGL's state that Dear ImGui's drawing expects and does not keep: for panels that are drawn between two
// passes of a frame.
class KeptState {
  public:
    KeptState() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
        glGetBooleanv(GL_COLOR_WRITEMASK, mask_);
        srgb_ = glIsEnabled(GL_FRAMEBUFFER_SRGB);
        discard_ = glIsEnabled(GL_RASTERIZER_DISCARD);
        scissor_ = glIsEnabled(GL_SCISSOR_TEST);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDisable(GL_FRAMEBUFFER_SRGB);
        glDisable(GL_RASTERIZER_DISCARD);
        glDisable(GL_SCISSOR_TEST);
    }
    ~KeptState() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
        glColorMask(mask_[0], mask_[1], mask_[2], mask_[3]);
        enable(GL_FRAMEBUFFER_SRGB, srgb_);
        enable(GL_RASTERIZER_DISCARD, discard_);
        enable(GL_SCISSOR_TEST, scissor_);
    }
    KeptState(const KeptState&) = delete;
    KeptState& operator=(const KeptState&) = delete;

  private:
    static void enable(GLenum what, GLboolean on) { on == GL_TRUE ? glEnable(what) : glDisable(what); }
    GLint draw_ = 0, read_ = 0;
    GLboolean mask_[4] = {GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE};
    GLboolean srgb_ = GL_FALSE, discard_ = GL_FALSE, scissor_ = GL_FALSE;
};

}  // namespace

Settings EditorWindow::State::shown_settings(const Settings& chosen) {
    EditorState& e = *editor;
    Settings shown = chosen;
    if (e.exposure_locked) {
        try {
            shown = editor::with_exposure(std::move(shown), static_cast<double>(e.locked_ev));
        } catch (const Error& error) {
            e.problem = error.what();
        }
    }
    if (e.refines && Refinement::possible(shown)) {
        Refinement::prepare(shown);
    }
    return coarse_light ? drag_settings(shown) : shown;
}

// While a hand edits the scene, what no smaller picture spares is coarser.
void EditorWindow::State::follow_hand(Quality quality) {
    const bool coarse =
        window.info().software && quality == Quality::drag && (editor->desk.gesture() || coarse_light);
    if (coarse != coarse_light) {
        coarse_light = coarse;
        gi::apply_settings(session.app(), shown_settings(editor->settings));
    }
}

// What the preview has beside the scene: settings, held exposure, muted lights.
void EditorWindow::State::apply_preview() {
    EditorState& e = *editor;
    const bool other_settings = std::exchange(e.settings_changed, false);
    if (other_settings) {
        gi::apply_settings(session.app(), shown_settings(e.settings));
        e.pace.forget();
    }
    follow_other_side(other_settings);
    if (!session.is_open() || (e.muted.empty() && e.solo.empty() && !dimmed_any)) {
        return;
    }
    // Muted lights are dark in the world, and the session's model knows nothing of it.
    dimmed_any = !e.muted.empty() || !e.solo.empty();
    ecs::World& world = session.world();
    for (const editor::LightRow& row : e.lights) {
        const Light* light = editor::light_of(session.model(), row.node);
        const ecs::Entity entity = light != nullptr ? session.entity_of(row.node) : ecs::kNullEntity;
        const LightComponent* now_shown =
            entity && world.alive(entity) ? world.try_get<LightComponent>(entity) : nullptr;
        if (now_shown == nullptr) {
            continue;
        }
        Light wanted = *light;
        if (e.solo.empty() ? e.muted.contains(row.node) : !e.solo.contains(row.node)) {
            wanted.intensity = 0;
        }
        if (!(now_shown->light == wanted)) {
            world.insert(entity, LightComponent{wanted});
        }
    }
}

// Between two frames: does what was asked for.
void EditorWindow::State::settle() {
    EditorState& e = *editor;
    if (woken.exchange(false) && watch.happened() && session.is_open() && !session.path().empty()) {
        reload();
    }
    if (e.desk.waiting()) {
        e.desk.apply(session, [&](const std::string& line) { e.problem = line; });
        if (!session.in_gesture()) {
            e.dirty = session.is_open() && session.is_dirty();  // a save changes no version
        }
        settling = kSettlingFrames;
        if (e.toast_until > 1e17) {
            e.toast_until = now() + 4;
        }
    }
    if (std::exchange(e.opened, false)) {
        scene_opened();
    } else if (session.is_open() && session.path() != shown_path) {
        // Saved under another name: all that is looked at stays.
        shown_path = session.path();
        watch.watch(shown_path);
        keep_recent(shown_path);
        e.views.copy(views_of, e.views_file());
        e.views_changed = true;
    }
    if (session.is_open()) {
        views_of = e.views_file();
    }
    keep_views();
    keep_keymap();
    e.read();
    follow_timeline();
    apply_preview();
    follow_title();
}

void EditorWindow::State::hide_other_side() {
    if (other_view) {
        session.app().view(*other_view).size = ivec2(0);
    }
}

// Draws what would be saved by a fresh App, and compares.
void EditorWindow::State::check_game() {
    EditorState& e = *editor;
    if (!e.muted.empty() || !e.solo.empty() || e.exposure_locked) {
        e.say("not the game's light: lights are muted or the exposure is held", now());
        return;
    }
    if (session.moment() > 0 || session.shown_clip()) {
        e.say("not the game's first moment: the timeline stands elsewhere", now());
        return;
    }
    hide_other_side();
    session.world().resource_mut<PresentTarget>().size = ivec2(0);
    const editor::SameAsGame found = editor::same_as_game(session, e.settings, {e.picture.facts().size, 4});
    window.context().make_current();
    e.game_same = found.same();
    e.game_words = found.same() ? fmt::format("= game {:06x}", found.game.final & 0xffffffu)
                                : fmt::format("not the game's: {} differs", found.first_difference);
    e.game_version = session.version();
    e.game_pose = session.pose();
    e.settings_changed = true;
    e.pace.changed(now(), false);
}

// Beside the file: the views that are kept of it, or this one.
void EditorWindow::State::write_review_page() {
    EditorState& e = *editor;
    const std::filesystem::path& file = session.path();
    const std::filesystem::path page =
        (file.empty() ? std::filesystem::current_path() : file.parent_path()) /
        ((file.empty() ? std::string("room") : file.stem().string()) + "-review.html");
    std::vector<editor::ReviewView> views;
    for (int number = 1; number <= KeptViews::kCount; ++number) {
        if (const workbench::CameraPose* pose = e.views.find(e.views_file(), number)) {
            views.push_back({fmt::format("view {}", number), *pose});
        }
    }
    if (views.empty()) {
        views.push_back({"this view", session.pose()});
    }
    session.world().resource_mut<PresentTarget>().size = ivec2(0);
    write_review(session, e.settings, views, {}, page);
    window.context().make_current();
    e.say("review page: " + page.string(), now());
    e.pace.changed(now(), false);
}

// Of the picture at its whole size.
glm::dvec2 EditorWindow::State::whole_size() {
    const Box& box = editor->layout.picture;
    const glm::dvec2 whole(box.width, box.height);
    if (!window.info().software) {
        return whole;
    }
    // Of more, a frame takes seconds.
    return whole * std::min(1.0, std::sqrt(kMostPixelsOnCpu / (whole.x * whole.y)));
}

gi::ErrorEstimate EditorWindow::State::estimate_error() {
    const gpu::PassEnd breathing([this] {
        if (window.info().software) {
            glFinish();
        }
        breathe();
    });
    const gi::ErrorEstimate estimate = gi::technique_of(session.app(), ViewId::first).estimate_error();
    editor->estimate = estimate.known ? std::optional(estimate.local) : std::nullopt;
    return estimate;
}

// How far A and B have come, if their samples grow.
void EditorWindow::State::follow_samples() {
    EditorState& e = *editor;
    const auto follow = [&](ViewId view, editor::TracedSamples& traced, double ms) {
        traced.drew(gi::technique_of(session.app(), view).progress(), ms);
    };
    follow(ViewId::first, e.traced, e.picture.facts().ms);
    if (e.picture.other_is_new()) {
        follow(*other_view, e.other_traced, e.picture.other_facts().ms);
    } else {
        e.other_traced.forget();
    }
}

// A frame more of a picture that is still.
void EditorWindow::State::refine_picture() {
    EditorState& e = *editor;
    const ivec2 size = glm::max(ivec2(glm::round(whole_size())), 16);
    try {
        e.picture.draw(session.app(), size, size, other_view, [this] { breathe(); });
        resumed = true;
        follow_samples();
        if (e.refinement.due() && e.refinement.drew(e.picture.facts().ms)) {
            const gi::ErrorEstimate estimate = estimate_error();
            e.refinement.estimated(estimate.known ? std::optional(estimate.relrmse.value) : std::nullopt);
            settling = std::max(settling, 1);
        }
        if (!e.refinement.due() && !samples_due()) {
            settling = std::max(settling, 1);
            viewport->read_light();
        }
    } catch (const Error& error) {
        e.problem = error.what();
        e.refinement.forget();
        e.traced.forget();
        e.other_traced.forget();
    }
}

void EditorWindow::State::draw_picture() {
    EditorState& e = *editor;
    if (e.layout.picture.empty() || !session.is_open()) {
        return;
    }
    const double at = now();
    const Quality quality = e.pace.quality(at);
    const double scale = e.pace.scale(at);
    const glm::dvec2 whole = whole_size();
    const ivec2 size = glm::max(ivec2(glm::round(scale * whole)), 16);
    const ivec2 rests = glm::max(ivec2(glm::round(whole)), 16);
    const bool dragged = window.info().software && quality == Quality::drag;
    follow_hand(quality);
    e.refinement.forget();
    resumed = false;
    if (quality == Quality::drag || e.picture.facts().quality == Quality::drag) {
        e.traced.forget();  // what a pass of a smaller picture takes says nothing of this one
    }
    try {
        // A is frozen while the hand moves: the hand has the time that it would take.
        const double changed =
            e.picture.draw(session.app(), size, dragged ? drag_whole(size, rests) : rests,
                           quality == Quality::drag ? std::nullopt : other_view, [this] { breathe(); });
        PictureFacts& facts = e.picture.facts();
        facts.changed = changed;
        facts.quality = quality;
        facts.technique = e.settings.text("gi.technique");
        facts.preset = e.preset;
        follow_samples();
        // Samples that grow are told apart: what they alter from pass to pass is no reason to wait.
        e.pace.drew(quality, scale, facts.ms, e.traced.grows() ? 0 : changed);
        if (!e.pace.due()) {
            facts.quality = e.pace.quality(now());
        }
        if (e.picture.other_is_new() && e.other_side && e.other_side->as) {
            PictureFacts& other = e.picture.other_facts();
            other.quality = facts.quality;
            other.technique = e.other_side->as->technique();
            other.preset = e.other_side->as->preset;
        }
        viewport->picture_drawn();
        if (e.pace.due()) {
            e.estimate.reset();
        } else {
            const gi::ErrorEstimate estimate = estimate_error();
            if (e.refines && Refinement::possible(e.settings)) {
                e.refinement.begin(estimate.known ? std::optional(estimate.relrmse.value) : std::nullopt,
                                   e.settings);
            }
        }
        if (!e.pace.due() && e.settings.text("gi.technique") != "path") {
            viewport->read_light();
            if (e.why && e.why->version != session.version() && e.why->pose == session.pose()) {
                ask_why(e.why->place);  // the same place after an edit
            }
        }
    } catch (const Error& error) {
        e.problem = error.what();
        for (int i = 0; i < Pace::kFewest; ++i) {  // no picture comes of it: none is due
            e.pace.drew(Quality::rest, 1, 0, 0);
        }
    }
}

// In the middle of a frame, between two passes: answers what has happened over the picture before.
void EditorWindow::State::breathe() {
    glfwPollEvents();
    const double every = std::max(viewport->gesture() ? kDraggedEvery : kMovesEvery,
                                  kTimesPanels * 1e-3 * editor->figures.ui_ms);
    const bool moved = input.dirty() && now() - last_ui > every;
    if (!input.urgent() && !moved) {
        return;
    }
    try {
        take_events();
        const KeptState kept;
        draw_panels(true);
        window.context().swap_buffers();
    } catch (const std::exception& error) {
        editor->problem = error.what();
    }
}

}  // namespace lanthorn::edit_window
