// An editing session: what outlives a crash, and edits on a file that has become another.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lanthorn/core/colour.h"
#include "lanthorn/core/error.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/session_state.h"

namespace lanthorn::editor {

namespace fs = std::filesystem;

namespace {

constexpr const char* kClearSky = "clear_sky";

}  // namespace

void EditSession::State::log_step(const EditStep& step) {
    log.append(log_block(step));
}

// Undo has gone back beyond what is on disk: the log begins with the scene as it was opened.
void EditSession::State::log_from_start() {
    if (options.recovery.empty()) {
        return;
    }
    const fs::path base = new_base(options.recovery);
    std::error_code ignored;
    fs::create_directories(options.recovery, ignored);
    try {
        history.first_document().write(base);
    } catch (const InputError&) {
        return;  // the log says why nothing can be written there
    }
    log.discard();
    log = RecoveryLog(options.recovery, path, saved_hash, base);
    std::string blocks;
    for (const EditStep& step : history.steps()) {
        blocks += log_block(step);
    }
    if (const std::size_t undone = history.steps().size() - history.position(); undone > 0) {
        blocks += fmt::format("undo {}\n", undone);
    }
    log.append(blocks);
    log_base = 0;
}

void EditSession::State::log_move(std::size_t from) {
    const std::size_t now = history.position();
    if (now < log_base) {
        log_from_start();
    } else if (now != from) {
        log.append(
            fmt::format("{} {}\n", now < from ? "undo" : "redo", now < from ? from - now : now - from));
    }
}

Rebased EditSession::State::redo_all(const std::vector<EditStep>& steps) {
    Rebased result = rebase(steps, history, context());
    show(history.model());
    lend_if_dark();
    for (const EditStep& step : history.steps()) {
        log_step(step);
    }
    left.insert(left.end(), result.left.begin(), result.left.end());
    return result;
}

Rebased EditSession::reload() {
    State& s = *state_;
    s.check_no_gesture("reload");
    if (s.path.empty()) {
        throw InputError("reload: the room is in no file yet, expected one that is saved");
    }
    State::Loaded loaded = s.load(s.path);
    std::vector<EditStep> unsaved;
    std::vector<LeftCommand> undone;
    const std::vector<EditStep>& steps = s.history.steps();
    const std::size_t saved = s.saved_position.value_or(0);
    for (std::size_t i = saved; i < s.history.position(); ++i) {
        unsaved.push_back(steps[i]);
    }
    for (std::size_t i = s.history.position(); i < saved; ++i) {
        for (const Command& command : steps[i].commands) {
            undone.push_back({command, "was undone after it was saved, and the file is another one now", {}});
        }
    }
    std::vector<std::string> selected;
    for (const std::uint32_t node : s.selection) {
        selected.push_back(path_of(node));
    }
    const workbench::CameraPose pose = s.pose;
    s.log.discard();
    s.take(std::move(loaded), s.path);
    Rebased result = s.redo_all(unsaved);
    result.left.insert(result.left.end(), undone.begin(), undone.end());
    s.left.insert(s.left.end(), undone.begin(), undone.end());
    set_pose(pose);
    std::vector<std::uint32_t> nodes;
    nodes.reserve(selected.size());
    for (const std::string& path : selected) {
        nodes.push_back(find_node(model(), path));
    }
    select(std::move(nodes));
    return result;
}

Rebased EditSession::recover(const fs::path& file) {
    State& s = *state_;
    const LeftLog log = read_log(file);
    const std::vector<EditStep> steps = steps_of(log);
    if (log.edited.empty()) {
        new_room();
    } else if (log.base.empty()) {
        open(log.edited);
    } else {
        open(log.base);
        s.path = log.edited;
        s.saved_position.reset();
        s.saved_text.clear();
    }
    const bool is_same = log.edited.empty() || !log.base.empty() || s.saved_hash == log.hash;
    Rebased result;
    if (is_same) {
        for (const EditStep& step : steps) {
            try {
                s.history.add(step, s.context());
                s.log_step(s.history.steps().back());
                result.kept += step.commands.size();
            } catch (const InputError& error) {
                for (const Command& command : step.commands) {
                    result.left.push_back({command, error.what(), {}});
                }
            }
        }
        s.show(s.history.model());
        s.lend_if_dark();
        s.left = result.left;
    } else {
        result = s.redo_all(steps);
    }
    discard_log(log);
    return result;
}

// By a lamp or a sky that somebody has put there. Suns without a sky are lent one.
bool EditSession::State::is_lit() const {
    const EditModel& model = history.model();
    bool found = world.has_sky();
    for (std::uint32_t i = 0; i < model.nodes.size() && !found; ++i) {
        const Light* light = light_of(model, i);
        found = light != nullptr && model.is_shown(i) &&
                (light->type != LightType::directional || has_extra(model.node(i), kClearSky));
    }
    return found;
}

std::vector<EditSession::State::Sun> EditSession::State::suns() const {
    const EditModel& model = history.model();
    std::vector<Sun> found;
    for (std::uint32_t i = 0; i < model.nodes.size(); ++i) {
        if (light_of(model, i) != nullptr && model.is_shown(i)) {
            found.push_back({i, *light_of(model, i), glm::dmat3(model.world_matrix(i))});
        }
    }
    return found;
}

void EditSession::State::lend_if_dark() {
    if (!options.view.default_light) {
        return;
    }
    if (is_lit()) {
        if (lent) {
            world.lend({}, 0);
        }
        lent = false;
        decided_dark = false;
        return;
    }
    std::vector<Sun> now = suns();
    if (decided_dark && now == lent_to) {
        return;
    }
    lent_to = std::move(now);
    const Copy copy(history.document());  // what a program that opens it would lend
    const SceneData scene = workbench::load_scene(copy.file().string(), options.view);
    const std::size_t own = scene.file.nodes.size();
    world.lend(scene, own);
    lent = scene.nodes.size() > own;
    decided_dark = true;
}

const std::string& EditSession::recovery_problem() const {
    return state_->log.problem();
}

void EditSession::refresh_guests() {
    if (state_->lent) {
        state_->decided_dark = false;
        state_->lend_if_dark();
    }
}

void EditSession::adopt() {
    State& s = *state_;
    s.check_no_gesture("adopt");
    std::vector<std::string> lines;
    bool with_sky = false;
    std::string sun;  // that the lent sky is about
    for (const EditWorld::Guest& guest : s.world.lent()) {
        if (guest.node.light == kNone) {
            with_sky = with_sky || guest.node.sky != kNone;
            continue;
        }
        constexpr const char* kTypes[] = {"directional", "point", "spot"};
        const dvec3& at = guest.node.local.translation;
        const quat& turn = guest.node.local.rotation;
        const vec3& colour = guest.light.colour;
        std::string name = guest.node.name;
        for (int i = 2; find_node(model(), '/' + name) != kNone; ++i) {
            name = fmt::format("{}-{}", guest.node.name, i);
        }
        lines.push_back(fmt::format("add-light / {} {} {} {} {} {} [{},{},{}]", word(name),
                                    kTypes[static_cast<int>(guest.light.type)], number(at.x), number(at.y),
                                    number(at.z), number(guest.light.intensity), number(colour.x),
                                    number(colour.y), number(colour.z)));
        lines.push_back(fmt::format("rotate {} {} {} {} {}", word('/' + name), number(turn.x), number(turn.y),
                                    number(turn.z), number(turn.w)));
        sun = '/' + name;
    }
    if (with_sky && sun.empty()) {
        const std::vector<State::Sun> own = s.suns();
        const auto brightest = std::ranges::max_element(own, {}, [](const State::Sun& each) {
            return luminance(dvec3(each.light.colour)) * static_cast<double>(each.light.intensity);
        });
        sun = brightest == own.end() ? sun : path_of(brightest->node);
    }
    if (with_sky && !sun.empty()) {
        lines.push_back(fmt::format("set {} {}.intensity 1", word(sun), kClearSky));
    }
    if (lines.empty()) {
        throw InputError("adopt: no light is lent to this scene");
    }
    run("adopt the lent light", lines);
}

}  // namespace lanthorn::editor
