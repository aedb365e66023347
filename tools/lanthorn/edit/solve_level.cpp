#include "tools/lanthorn/edit/solve_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/recording.h"
#include "tools/lanthorn/common/child_process.h"
#include "tools/lanthorn/replay/solving.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;

constexpr const char* kResult = "solving.json";
constexpr const char* kProgress = "progress";
constexpr const char* kLength = "steps";

fs::path found_recording(const editor::EditSession& session) {
    fs::path file = session.path().empty() ? fs::path() : recording_of(session.path());
    if (file.empty()) {
        const std::string name = session.path().empty() ? "room.glb" : session.path().filename().string();
        throw InputError(
            fmt::format("still solvable?: found no recording of {}, expected {} beside it; `lanthorn "
                        "replay record` makes one",
                        name, fs::path(name).stem().string() + ".rec"));
    }
    return file;
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

double number_in(const fs::path& file) {
    const std::string text = text_of(file);
    return std::strtod(text.c_str(), nullptr);
}

}  // namespace

std::vector<std::string> solve_command(const editor::EditSession& session, const fs::path& folder) {
    const fs::path recording = found_recording(session);
    const fs::path level = folder / "level.glb";
    session.document().write(level);
    write_file(folder / kLength, std::to_string(replay::read_recording(recording.string()).steps.size()));
    return {own_executable(), "replay",
            "solve",          recording.string(),
            "--level",        level.string(),
            "--result",       (folder / kResult).string(),
            "--progress",     (folder / kProgress).string()};
}

edit_window::SolveShown solve_found(const fs::path& folder) {
    edit_window::SolveShown shown;
    shown.share =
        std::clamp(number_in(folder / kProgress) / std::max(1.0, number_in(folder / kLength)), 0.0, 1.0);
    const fs::path result = folder / kResult;
    if (!fs::exists(result)) {
        return shown;
    }
    const nlohmann::json json = parse_json_object(text_of(result), result.string(), "what was found");
    shown.solved = json.value("solved", false);
    shown.words = json.value("words", "");
    for (const nlohmann::json& read : json.at("readings")) {
        const double needed = read.value("needed_lux", 0.0), most = read.value("most_lux", 0.0);
        const std::string name = read.value("name", "");
        shown.rows.push_back(
            {name,
             fmt::format("{}: at most {:.3g} lx at step {}, needs {:.3g} lx ({:+.0f} %)", name, most,
                         read.value("most_at", 0), needed, 100 * (most / std::max(1e-9, needed) - 1)),
             most >= needed});
    }
    for (const nlohmann::json& event : json.at("events")) {
        const auto at = [&](const char* key) {
            return event.at(key).is_null() ? std::string("never")
                                           : fmt::format("step {}", event.at(key).get<int>());
        };
        shown.rows.push_back(
            {"",
             fmt::format("{}: {}{}", event.value("what", ""), at("now"),
                         event.at("recorded").is_null() ? "" : ", recorded " + at("recorded")),
             !event.at("now").is_null()});
    }
    return shown;
}

editor::EditScript::Solved solve_now(const editor::EditSession& session, const fs::path& recording) {
    const editor::EditSession::Copy copy(session.document());
    const Solving solving =
        solve_again((recording.empty() ? found_recording(session) : recording).string(), copy.file().string(),
                    [](std::uint64_t, std::uint64_t) { return true; });
    return {solving.solved_at.has_value(), solving.words()};
}

}  // namespace lanthorn::tools
