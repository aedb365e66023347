#include "tests/fuzz/commands_target.h"

#include <algorithm>
#include <array>
#include <set>

#include "engine/manual/declared_options.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/gi/gi_settings.h"
#include "tests/fuzz/quiet.h"
#include "tests/fuzz/reading.h"
#include "tests/fuzz/target.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/command_line.h"
#include "tools/scene_generator/glb_bytes.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::fuzz {

namespace fs = std::filesystem;

namespace {

constexpr std::array kCommands = {tools::add_render,     tools::add_compare, tools::add_inspect,
                                  tools::add_convert,    tools::add_measure, tools::add_trade,
                                  tools::add_trade_point};
const std::set<std::string> kFiles = {"box.glb", "a.png", "b.png", "settings.json"};
const std::set<std::string> kDrawing = {"render", "measure", "trade", "trade-point"};

void write_image_file(const fs::path& path, float value) {
    ImageF image;
    image.width = image.height = 8;
    image.channels = 3;
    image.pixels.assign(8 * 8 * 3, value);
    write_image(path, image);
}

// With the files, or without any.
fs::path working_folder(bool with_files) {
    const fs::path path = folder() / (with_files ? "files" : "empty");
    if (fs::create_directories(path) && with_files) {
        write_file(path / "box.glb", scene_generator::glb_bytes(scene_generator::cornell()));
        write_image_file(path / "a.png", 0.5f);
        write_image_file(path / "b.png", 0.25f);
        write_file(path / "settings.json", R"({"gi.emc.count": 4})");
    }
    return path;
}

// Whatever the command wrote beside its files.
void clean(const fs::path& path, bool with_files) {
    for (const auto& entry : fs::directory_iterator(path)) {
        if (!with_files || !kFiles.contains(entry.path().filename())) {
            fs::remove_all(entry.path());
        }
    }
}

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.emplace_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += text.empty() ? line : "\n" + line;
    }
    return text;
}

void collect(const CLI::App& app, std::vector<std::string>& words) {
    for (const manual::DeclaredOption& option : manual::declared_options(app)) {
        words.insert(words.end(), option.names.begin(), option.names.end());
        words.insert(words.end(), option.choices.begin(), option.choices.end());
    }
    for (const CLI::App* command : manual::declared_commands(app)) {
        words.push_back(command->get_name());
        collect(*command, words);
    }
}

// Arguments worth trying.
const std::vector<std::string>& vocabulary() {
    static const std::vector<std::string> words = [] {
        CLI::App app;
        for (const auto add : kCommands) {
            add(app);
        }
        std::vector<std::string> all = {"",
                                        "-1",
                                        "0",
                                        "1e99",
                                        "nan",
                                        "inf",
                                        "99999999999999999999",
                                        "64x64",
                                        "0x0",
                                        "1x-1",
                                        "99999x99999",
                                        "low",
                                        "ultra",
                                        "gi.emc.count=4",
                                        "gi.seed=x",
                                        "=",
                                        "a=",
                                        "box.glb",
                                        "a.png",
                                        "b.png",
                                        "settings.json",
                                        "out.exr",
                                        "out.gltf",
                                        "--",
                                        "--size=1x1",
                                        "--set=a=b",
                                        "-oout.png",
                                        "\x1b[2J",
                                        "path.spp=1",
                                        "none",
                                        "emc",
                                        "render.gamma=1",
                                        "indirect",
                                        "auto"};
        collect(app, all);
        return all;
    }();
    return words;
}

}  // namespace

void run_commands(std::string_view input) {
    std::vector<std::string> arguments = lines_of(input);
    for (std::string& argument : arguments) {
        std::ranges::replace(argument, '/', '_');
        argument = argument.c_str();  // ends at a NUL
        if (argument == "..") {
            argument = ".";
        }
    }
    const bool draws =
        std::ranges::any_of(arguments, [](const std::string& a) { return kDrawing.contains(a); });
    const fs::path where = working_folder(!draws);
    fs::current_path(where);
    std::string name = "lanthorn";
    std::vector<char*> argv = {name.data()};
    std::ranges::transform(arguments, std::back_inserter(argv), [](std::string& a) { return a.data(); });
    const auto count = static_cast<int>(argv.size());
    argv.push_back(nullptr);
    int code = 0;
    std::string errors;
    {
        const Quiet quiet;
        code = tools::run_command_line("lanthorn", "Purpose.", kCommands, count, argv.data());
        errors = quiet.errors();
    }
    fs::current_path(folder());
    clean(where, !draws);
    if (code < 0 || code > 3) {
        throw Finding("exit code " + std::to_string(code));
    }
    const std::size_t last = errors.rfind('\n', errors.size() < 2 ? std::string::npos : errors.size() - 2);
    const std::string line = errors.substr(last == std::string::npos ? 0 : last + 1);
    if (code == 2 && (line.empty() || line.size() > 500 + input.size())) {
        throw Finding("refused with " + std::to_string(line.size()) + " characters: " + line);
    }
    if (line.find("internal error") != std::string::npos) {
        throw Finding(line);
    }
}

std::vector<std::string> command_inputs() {
    return {"inspect\nbox.glb\n--plan\n--json",
            "compare\na.png\nb.png\n--metric\nflip\n--max\n1\n--heatmap\nheat.png\n--json",
            "convert\nbox.glb\nout.gltf",
            "render\nbox.glb\n-o\nout.png\n--size\n64x64\n--preset\nlow\n--set\ngi.emc.count=4\n--"
            "aov\nfinal\n--settings\nsettings.json",
            "render\n--list-settings",
            "measure\nhits\nbox.glb\n--json",
            "trade\nbox.glb\n-o\nout\n--time\n1",
            "--help"};
}

std::string damage_commands(const std::string& input, Mutator& mutator) {
    std::vector<std::string> lines = lines_of(input);
    const auto word = [&] { return vocabulary()[mutator.below(vocabulary().size())]; };
    for (std::size_t count = 1 + mutator.below(3); count > 0; --count) {
        const auto at = static_cast<std::ptrdiff_t>(mutator.below(lines.size()));
        switch (mutator.below(5)) {
            case 0:
                if (lines.size() > 1) {
                    lines.erase(lines.begin() + at);
                }
                break;
            case 1:
                lines[static_cast<std::size_t>(at)] = word();
                break;
            case 2:
                std::swap(lines[static_cast<std::size_t>(at)], lines[mutator.below(lines.size())]);
                break;
            default:
                lines.insert(lines.begin() + at + 1, word());
        }
    }
    return joined(lines);
}

}  // namespace lanthorn::fuzz
