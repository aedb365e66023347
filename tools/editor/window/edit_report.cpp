#include "tools/editor/window/edit_report.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "lanthorn/core/error.h"

namespace lanthorn::edit_window {

using Json = nlohmann::ordered_json;

namespace {
double monotonic() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
}  // namespace

EditReport::EditReport(const std::filesystem::path& file) {
    if (file.empty()) {
        return;
    }
    out_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (out_ < 0) {
        throw InputError(file.string(), "", "cannot be written, expected a place for the report");
    }
}

EditReport::~EditReport() {
    if (out_ >= 0) {
        ::close(out_);
    }
}

void EditReport::write(const std::string& line) {
    const std::string whole = line + "\n";
    [[maybe_unused]] const auto written = ::write(out_, whole.data(), whole.size());
}

void EditReport::line(const EditorState& state) {
    if (out_ < 0) {
        return;
    }
    const PictureFacts& facts = state.picture.facts();
    Json line;
    line["ui"] = state.figures.ui_frames;
    line["frames"] = state.picture.frames();
    line["quality"] = name_of(state.pace.due() ? facts.quality : Quality::still);
    line["refinement"] = state.refinement.words();
    if (state.traced.grows()) {
        line["progress"] = {state.traced.progress().done, state.traced.progress().wanted};
        line["seconds_left"] = state.traced.seconds_left().value_or(0);
    }
    line["technique"] = facts.technique;
    line["preset"] = facts.preset;
    line["view"] = facts.view;
    line["picture"] = {facts.size.x, facts.size.y};
    line["changed"] = facts.changed;
    line["ms"] = facts.ms;
    if (state.other_side) {
        const PictureFacts& other = state.picture.other_facts();
        line["other_side"] = {{"technique", state.kept_picture() != nullptr ? "" : other.technique},
                              {"preset", other.preset},
                              {"ms", other.ms},
                              {"new", state.picture.other_is_new()},
                              {"divider", state.divider}};
    }
    line["solving"] = state.solving;
    line["solve"] = state.solve.words;
    line["moment"] = {state.session.moment(), state.timeline.playing};
    line["longest_ms"] = facts.longest_ms;
    line["ui_ms"] = state.figures.ui_ms;
    line["open"] = state.session.is_open() ? state.session.path().string() : "";
    line["edits"] = state.session.steps().position();
    line["dirty"] = state.dirty;
    Json chosen = Json::array();
    for (const std::uint32_t node : state.chosen) {
        if (state.session.model().find(node) != nullptr) {
            chosen.push_back(state.session.path_of(node));
        }
    }
    line["chosen"] = chosen;
    line["sheet"] = static_cast<int>(state.sheet);
    line["problem"] = state.problem;
    line["toast"] = state.toast;
    const Box& box = state.layout.picture;
    line["box"] = {box.x, box.y, box.width, box.height};
    line["playing"] = state.playing;
    line["played"] = state.played.size();
    line["beside"] = state.beside.rows.size();
    if (!state.wishes.rows.empty()) {
        Json wishes = Json::array();
        for (const WishRow& row : state.wishes.rows) {
            const bool known = row.found && !state.wishes.old(state.session.version());
            wishes.push_back({{"asked", asked_words(row.wish)},
                              {"radius", row.wish.radius},
                              {"has", known ? Json(row.found->before) : Json()},
                              {"met", known && row.found->met_with(row.found->before)}});
        }
        line["wishes"] = wishes;
    }
    if (state.error && state.error_of_frame == state.picture.frames()) {
        line["error"] = {state.error->local, state.error->uncertainty};
    }
    if (state.why) {
        const editor::WhyAnswer& why = state.why->answer;
        line["why"] = {{"on", state.why->name(why.point.entity)},
                       {"lux", why.split.direct.value() + why.split.indirect().value()},
                       {"traced_ms", why.traced_ms},
                       {"built_ms", why.built_ms}};
    }
    // Where lights stand in the window: what a script clicks on.
    Json lights = Json::object();
    for (const auto& [name, at] : state.light_places) {
        lights[name] = {at.x, at.y};
    }
    line["lights"] = lights;
    const std::string text = line.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text != before_) {
        before_ = text;
        line["seconds"] = monotonic();
        write(line.dump(-1, ' ', false, Json::error_handler_t::replace));
    }
}

void EditReport::answer(double ms, bool in_frame) {
    if (out_ >= 0) {
        write(fmt::format("{{\"answer_ms\":{:.3f},\"in_frame\":{},\"seconds\":{:.6f}}}", ms, in_frame,
                          monotonic()));
    }
}

void EditReport::followed(double ms) {
    if (out_ >= 0) {
        write(fmt::format("{{\"follow_ms\":{:.3f},\"seconds\":{:.6f}}}", ms, monotonic()));
    }
}

}  // namespace lanthorn::edit_window
