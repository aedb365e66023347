// lanthorn replay pack FILE: writes a recording again, packed, with what is to be said of it.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>

#include "lanthorn/core/error.h"
#include "tools/lanthorn/replay/expectations.h"
#include "tools/lanthorn/replay/replay_commands.h"
#include "tools/lanthorn/replay/seek.h"

namespace lanthorn::tools {

namespace {

struct PackOptions {
    std::string file, out, level;
    std::vector<std::string> notes, expectations, marks;
    std::uint64_t states = 0;
};

// "930:door-open" or "930:door-open:CAMERA".
replay::Mark mark_of(const std::string& text) {
    replay::Mark mark;
    const char* const end = text.data() + text.size();
    const auto [at, problem] = std::from_chars(text.data(), end, mark.step);
    if (problem != std::errc() || at == end || *at != ':' || at + 1 == end) {
        throw InputError(fmt::format("--mark: found '{}', expected STEP:NAME or STEP:NAME:CAMERA", text));
    }
    mark.name.assign(at + 1, end);
    if (const std::size_t colon = mark.name.find(':'); colon != std::string::npos) {
        mark.camera = mark.name.substr(colon + 1);
        mark.name.resize(colon);
    }
    return mark;
}

ExitCode pack(const PackOptions& options) {
    replay::Recording recording = replay::read_recording(options.file);
    replay::Annotations& a = recording.annotations;
    a.notes.insert(a.notes.end(), options.notes.begin(), options.notes.end());
    for (const std::string& line : options.expectations) {
        if (std::ranges::find(a.expectations, line) == a.expectations.end()) {
            a.expectations.push_back(line);
        }
    }
    const Expectations checked(options.file, a.expectations);
    for (const std::string& text : options.marks) {
        const replay::Mark mark = mark_of(text);
        if (mark.step > recording.steps.size()) {
            throw InputError(
                options.file, "--mark",
                fmt::format("found step {}, expected at most {}", mark.step, recording.steps.size()));
        }
        std::erase_if(a.marks, [&](const replay::Mark& before) { return before.name == mark.name; });
        a.marks.push_back(mark);
    }
    if (options.states > 0) {
        const auto level = read_level(options.file, recording.header, options.level);
        a.states =
            key_states(*level, options.file, std::make_shared<replay::Recording>(recording), options.states);
    }
    const std::string out = options.out.empty() ? options.file : options.out;
    const auto before = std::filesystem::file_size(options.file);
    replay::write_recording(out, recording);
    fmt::print("{}: {} steps in {} bytes, {} before\n", out, recording.steps.size(),
               std::filesystem::file_size(out), before);
    return ExitCode::ok;
}

}  // namespace

Command add_replay_pack(CLI::App& replay) {
    auto options = std::make_shared<PackOptions>();
    CLI::App* command = replay.add_subcommand(
        "pack", "Writes a recording again: packed, in today's format, with notes, expectations and marks.");
    command->add_option("FILE", options->file, "a recording (.rec)")->required();
    command->add_option("-o,--out", options->out, "file to write; default: FILE itself")->type_name("FILE");
    command->add_option("--note", options->notes, "repeatable: words for people")->allow_extra_args(false);
    command
        ->add_option(
            "--expect", options->expectations,
            "repeatable, verify checks it: \"WHAT before STEP\", \"WHAT after STEP\" or \"WHAT\", with WHAT "
            "\"solved\" or \"ENTITY COMPONENT.FIELD [=<> VALUE]\": \"door door.open after 300\"")
        ->allow_extra_args(false);
    command
        ->add_option("--mark", options->marks,
                     "repeatable: STEP:NAME[:CAMERA], a moment worth a picture; in place of one of that name")
        ->allow_extra_args(false);
    command
        ->add_option("--states", options->states,
                     "store the state before every Nth key step, for bisect; 0: none")
        ->type_name("N");
    command
        ->add_option("--level", options->level, "the level's file, for --states; default: as verify finds it")
        ->type_name("FILE");
    return [options] { return pack(*options); };
}

}  // namespace lanthorn::tools
