// lanthorn replay info FILE...: what is in a recording, without playing it.
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "lanthorn/replay/recording.h"
#include "tools/lanthorn/common/text_table.h"
#include "tools/lanthorn/replay/replay_commands.h"

namespace lanthorn::tools {

namespace {

struct InfoOptions {
    std::vector<std::string> files;
    bool json = false;
};

// How often each part was changed.
std::vector<std::uint64_t> changes(const replay::Recording& recording) {
    std::vector<std::uint64_t> counts(recording.header.parts.size(), 0);
    for (std::size_t i = 1; i < recording.steps.size(); ++i) {
        for (const replay::ChangedPart& changed : recording.steps[i].changed) {
            ++counts[changed.part];
        }
    }
    return counts;
}

struct Counts {
    std::size_t readings = 0, input_changes = 0;
};

Counts counts_of(const replay::Recording& recording) {
    Counts counts;
    for (std::size_t i = 0; i < recording.steps.size(); ++i) {
        counts.readings += recording.steps[i].sensors.size();
        counts.input_changes += i > 0 && recording.steps[i].input != recording.steps[i - 1].input ? 1 : 0;
    }
    return counts;
}

nlohmann::ordered_json json_of(const std::string& file, const replay::Recording& r) {
    const replay::RecordingHeader& h = r.header;
    const Counts counts = counts_of(r);
    nlohmann::ordered_json parts = nlohmann::ordered_json::object();
    const std::vector<std::uint64_t> changed = changes(r);
    for (std::size_t i = 0; i < h.parts.size(); ++i) {
        parts[h.parts[i]] = changed[i];
    }
    nlohmann::ordered_json marks = nlohmann::ordered_json::array();
    for (const replay::Mark& mark : r.annotations.marks) {
        marks.push_back({{"step", mark.step}, {"name", mark.name}, {"camera", mark.camera}});
    }
    return {{"file", file},
            {"level", h.level},
            {"build", h.build},
            {"seed", h.seed},
            {"steps", r.steps.size()},
            {"seconds", static_cast<double>(r.steps.size()) / h.step_rate},
            {"bytes", std::filesystem::file_size(file)},
            {"cut_off", r.cut_off},
            {"input", h.input_format},
            {"input_changes", counts.input_changes},
            {"sensors", h.sensors},
            {"sensor_readings", counts.readings},
            {"parts_changed", parts},
            {"marks", marks},
            {"expectations", r.annotations.expectations},
            {"notes", r.annotations.notes},
            {"log", r.annotations.log},
            {"states", r.annotations.states.size()},
            {"ancestors", r.annotations.line.size()}};
}

void print_lines(const char* title, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        fmt::print("  {:<10}{}\n", title, line);
    }
}

void print(const std::string& file, const replay::Recording& r) {
    const replay::RecordingHeader& h = r.header;
    const Counts counts = counts_of(r);
    fmt::print("{}: {} steps ({:.1f} s), level {}, by {}\n", file, r.steps.size(),
               static_cast<double>(r.steps.size()) / h.step_rate, h.level, h.build);
    const double seconds = static_cast<double>(std::max<std::size_t>(r.steps.size(), 1)) / h.step_rate;
    const auto bytes = static_cast<double>(std::filesystem::file_size(file));
    fmt::print("  file      {:.1f} kB, {:.2f} MB an hour{}{}\n", bytes / 1e3, bytes / seconds * 3600 / 1e6,
               r.cut_off.empty() ? "" : "; ", r.cut_off);
    fmt::print("  input     {}, {} bytes a step, another one in {} steps; seed {}\n", h.input_format,
               h.input_size, counts.input_changes, h.seed);
    fmt::print("  sensors   {} readings of {} sensors\n", counts.readings, h.sensors.size());
    const std::vector<std::uint64_t> changed = changes(r);
    const auto ever = std::ranges::count_if(changed, [](std::uint64_t n) { return n > 0; });
    fmt::print("  state     {} of {} parts change\n", ever, h.parts.size());
    TextTable table({"part", "changes in steps"});
    std::string never;
    for (std::size_t i = 0; i < h.parts.size(); ++i) {
        if (changed[i] > 0) {
            table.add({h.parts[i], fmt::format("{}", changed[i])});
        } else {
            never += (never.empty() ? "" : " ") + h.parts[i];
        }
    }
    fmt::print("{}", table.text());
    fmt::print("  never     {}\n", never.empty() ? "-" : never);
    for (const replay::Mark& mark : r.annotations.marks) {
        fmt::print("  mark      step {} '{}'\n", mark.step, mark.name);
    }
    print_lines("expected", r.annotations.expectations);
    print_lines("note", r.annotations.notes);
    print_lines("log", r.annotations.log);
    for (const replay::StoredState& state : r.annotations.states) {
        fmt::print("  snapshot  step {}, {} bytes\n", state.step, state.bytes.size());
    }
    for (const replay::Ancestor& one : r.annotations.line) {
        fmt::print("  replaces  one by {}: {}\n", one.build, one.reason);
    }
}

ExitCode info(const InfoOptions& options) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const std::string& file : options.files) {
        const replay::Recording recording = replay::read_recording(file);
        if (options.json) {
            all.push_back(json_of(file, recording));
        } else {
            print(file, recording);
        }
    }
    if (options.json) {
        fmt::print("{}\n", (all.size() == 1 ? all[0] : all)
                               .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    }
    return ExitCode::ok;
}

}  // namespace

Command add_replay_info(CLI::App& replay) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = replay.add_subcommand("info", "What is in recordings, without playing them.");
    command->add_option("FILE", options->files, "recordings (.rec)")->required();
    command->add_flag("--json", options->json, "print JSON: an object, a list for several files");
    return [options] { return info(*options); };
}

}  // namespace lanthorn::tools
