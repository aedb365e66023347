// What is measured while the hand rests: error, contracts, what each light gives and costs.
#include <algorithm>

#include "lanthorn/runtime/render_plugin.h"
#include "tools/editor/core/document_light_costs.h"
#include "tools/editor/core/same_as_game.h"
#include "tools/editor/window/window_state.h"

namespace lanthorn::edit_window {

namespace {

constexpr double kCostsAfter = 1;  // seconds of rest

}  // namespace

std::uint32_t EditorWindow::State::node_with(std::uint32_t entity) {
    const std::vector<ecs::Entity> all = session.entities();
    for (std::uint32_t node = 0; node < all.size(); ++node) {
        if (all[node] != ecs::kNullEntity && all[node].index == entity) {
            return node;
        }
    }
    return kNone;
}

void EditorWindow::State::take_rest_figures(RestFigures figures) {
    EditorState& e = *editor;
    e.contracts = std::move(figures.contracts);
    for (auto& [node, gain] : e.gains) {
        gain.share = 0;
    }
    for (const workbench::LightShare& share : figures.shares) {
        const std::uint32_t node =
            share.source.kind == reference::LightKind::punctual ? node_with(share.entity) : kNone;
        if (node != kNone) {
            e.gains[node].share = share.share;
        }
    }
    e.gains_version = session.version();
    if (figures.error) {
        viewport->show_error(*figures.error);
        e.error = std::move(*figures.error);
        e.error_of_frame = measured_frame;
    }
    settling = kSettlingFrames;
}

// Once the picture's figures are there: they and the passes would be in each other's way.
bool EditorWindow::State::refines_now() const {
    const EditorState& e = *editor;
    return session.is_open() && !e.pace.due() && !e.pace.held() && (e.refinement.due() || samples_due()) &&
           !e.layout.picture.empty() && !rest_watch.busy() && !game.running() && !solver.running();
}

void EditorWindow::State::follow_rest() {
    EditorState& e = *editor;
    if (std::optional<RestFigures> figures = rest_watch.take()) {
        take_rest_figures(std::move(*figures));
    }
    const bool rests = session.is_open() && !e.pace.due() && !e.pace.held() && e.picture.frames() > 0;
    if (!rests) {
        if (std::exchange(measured_frame, -1) >= 0) {
            rest_watch.stop();  // the hand comes first
        }
        costs.reset();
        return;
    }
    if ((e.refinement.due() || samples_due()) && resumed) {
        return;  // what is measured is the picture before it, and then the last one
    }
    const ivec2 size = e.picture.facts().size;
    const Renderer& renderer = session.world().resource<Renderer>();
    if (renderer.frame && e.picture.view() == "final" && carded != session.path() &&
        !session.path().empty()) {
        carded = session.path();
        e.cards.keep(carded, renderer.frame->read(render::Aov::final));
    }
    if (measured_frame != e.picture.frames() && renderer.frame && size.x >= 16 * editor::kErrorStride) {
        measured_frame = e.picture.frames();
        rest_since = now();
        auto job = std::make_unique<RestWatch::Job>();
        job->frame = session.world().resource<FrameScene>();
        job->size = size;
        job->settings = reference::path_settings(e.settings);
        if (e.settings.text("gi.technique") != "path") {
            ImageF indirect = renderer.frame->read(render::Aov::indirect);
            if (indirect.width == size.x && indirect.height == size.y) {
                job->indirect = std::move(indirect);
            }
        }
        job->contracts = workbench::contracts_of(session.world(), job->frame);
        rest_watch.measure(std::move(job));
    }
    if (!e.refinement.due() && !samples_due()) {
        measure_costs(size);
    }
}

// A frame a turn, where somebody looks at the table of lights.
void EditorWindow::State::measure_costs(ivec2 size) {
    EditorState& e = *editor;
    const bool asked =
        e.splits.drawer_open && e.drawer_tab == kLightsTab && !e.splits.only_picture && !e.lights.empty();
    const bool known = e.costs_version == session.version() && e.costs_pose == session.pose() && !costs;
    if (!asked || known || rest_watch.busy() || !e.muted.empty() || !e.solo.empty() ||
        e.settings.text("gi.technique") == "path" || game.running() || solver.running()) {
        costs.reset();
        return;
    }
    if (const double left = rest_since + kCostsAfter - now(); left > 0) {
        costs_alarm.set(Alarm::Clock::now() + std::chrono::duration_cast<Alarm::Clock::duration>(
                                                  std::chrono::duration<double>(left + 0.01)));
        return;
    }
    try {
        if (!costs) {
            costs = editor::document_light_costs(session, e.settings, size);
            for (auto& [node, gain] : e.gains) {
                gain.ms.reset();
            }
            e.costs_version = session.version();
            e.costs_pose = session.pose();
        }
        const bool goes_on = costs->step();
        window.context().make_current();
        for (const workbench::LightCosts::Cost& cost : costs->costs()) {
            if (const std::uint32_t node = node_with(cost.lamp.entities.front().index); node != kNone) {
                // Other programs make the clock of a CPU's frames say nothing.
                const bool software = window.info().software;
                e.gains[node].ms = software ? cost.cpu_ms : cost.ms;
                e.gains[node].ms_noise = software ? cost.cpu_noise : cost.noise;
            }
        }
        if (!goes_on) {
            costs.reset();
        }
        settling = std::max(settling, 1);
    } catch (const Error& error) {
        costs.reset();
        e.problem = error.what();
    }
}

}  // namespace lanthorn::edit_window
