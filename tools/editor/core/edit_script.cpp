#include "tools/editor/core/edit_script.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <span>
#include <utility>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/replay/content_hash.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tools/editor/core/edit_warnings.h"
#include "tools/editor/core/error_map.h"
#include "tools/editor/core/lights_table.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/node_value.h"
#include "tools/editor/core/review_page.h"
#include "tools/workbench/measure/light_words.h"

namespace lanthorn::editor {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_check(const std::string& line) {
    throw Error(ExitCode::check_failed, line);
}

int whole(const std::string& text, int low, int high, const char* what) {
    int value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || value < low || value > high) {
        throw InputError(fmt::format("found '{}', expected {} from {} to {}", text, what, low, high));
    }
    return value;
}

std::string hash_text(const FrameHashes& hashes) {
    return fmt::format("gbuffer {:016x}, direct {:016x}, indirect {:016x}, final {:016x}", hashes.gbuffer,
                       hashes.direct, hashes.indirect, hashes.final);
}

}  // namespace

void EditScript::expect_words(const std::vector<std::string>& words, std::size_t low, std::size_t high,
                              const char* usage) {
    if (words.size() < low || words.size() > high) {
        throw InputError(fmt::format("{}: found {} word{} behind it, expected {}", words[0], words.size() - 1,
                                     words.size() == 2 ? "" : "s", usage));
    }
}

CheckedFrames EditScript::frames_in(const std::vector<std::string>& words, std::size_t at) {
    CheckedFrames what;
    if (words.size() > at) {
        const std::size_t x = words[at].find('x');
        if (x == std::string::npos) {
            throw InputError(fmt::format("found '{}', expected WIDTHxHEIGHT", words[at]));
        }
        what.size = {whole(words[at].substr(0, x), 1, 8192, "a width"),
                     whole(words[at].substr(x + 1), 1, 8192, "a height")};
    }
    if (words.size() > at + 1) {
        what.frames = whole(words[at + 1], 1, 10000, "a number of frames");
    }
    return what;
}

std::string document_hash(const GltfDocument& document) {
    const std::string text = document.json_text();
    return fmt::format("{:016x}", replay::hash_bytes(std::as_bytes(std::span(text))));
}

EditScript::EditScript(SessionOptions options, const Settings& settings,
                       std::function<void(const std::string&)> print)
    : session_(std::move(options)), settings_(settings), print_(std::move(print)) {}

EditScript::~EditScript() = default;

void EditScript::run_file(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream || fs::is_directory(file)) {
        throw InputError(file.string(), "", "cannot be read, expected a script");
    }
    run_text(text, file.string());
}

void EditScript::run_text(const std::string& text, const std::string& name) {
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        ++number;
        try {
            run_line(text.substr(at, end - at));
        } catch (const Error& error) {
            throw Error(error.code(), fmt::format("{}:{}: {}", name, number, error.what()));
        }
        at = end + 1;
    }
    if (session_.in_gesture()) {
        session_.cancel();
        throw Error(ExitCode::bad_input,
                    fmt::format("{}:{}: found the end, expected commit or cancel", name, number));
    }
}

void EditScript::run_line(const std::string& line) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) {
        return;
    }
    const std::string& verb = words[0];
    if (verb == "open") {
        expect_words(words, 2, 2, "open FILE");
        session_.open(words[1]);
    } else if (verb == "new-room") {
        expect_words(words, 1, 1, "new-room alone");
        session_.new_room();
    } else if (verb == "save") {
        expect_words(words, 1, 2, "save [FILE]");
        session_.save(words.size() > 1 ? fs::path(words[1]) : fs::path());
    } else if (verb == "reload") {
        expect_words(words, 1, 1, "reload alone");
        session_.reload();
    } else if (verb == "recover") {
        expect_words(words, 2, 2, "recover LOG");
        session_.recover(words[1]);
    } else if (verb == "begin") {
        expect_words(words, 2, 2, "begin TEXT");
        session_.begin(words[1]);
        gathered_.clear();
    } else if (verb == "commit") {
        session_.commit();
    } else if (verb == "cancel") {
        session_.cancel();
    } else if (verb == "pose") {
        expect_words(words, 2, 2, "pose X,Y,Z,YAW,PITCH[,FOV]");
        session_.set_pose(workbench::pose_of(words[1]));
    } else if (verb == "expect") {
        expect(words);
    } else if (verb == "picture") {
        picture(words);
    } else if (verb == "clip") {
        show_clip(words);
    } else if (verb == "compare") {
        compare(words);
    } else if (verb == "technique") {
        choose_technique(words);
    } else if (verb == "trace") {
        trace(words);
    } else if (verb == "review") {
        review(words);
    } else if (verb == "same-as-game") {
        compare_with_game(words);
    } else if (verb == "print") {
        print(words);
    } else if (run_wishes(words)) {
        return;
    } else if (session_.in_gesture()) {
        std::vector<std::string> lines = gathered_;
        lines.push_back(line);
        session_.preview(lines);
        gathered_ = std::move(lines);
    } else {
        session_.run(line);
    }
}

void EditScript::expect_value(const std::string& what, const std::string& found, const std::string& wanted) {
    const bool is_text = found.size() >= 2 && found.front() == '"';
    const bool is_same = means_the_same(found, wanted) || (is_text && found == '"' + wanted + '"');
    if (!is_same) {
        fail_check(fmt::format("{} is {}, expected {}", what, found, wanted));
    }
}

void EditScript::expect(const std::vector<std::string>& words) {
    expect_words(words, 2, 1000, "what is expected");
    const std::string& what = words[1];
    const auto need = [&](std::size_t count, const char* usage) { expect_words(words, count, count, usage); };
    if (what == "hash") {
        need(3, "hash HEX");
        expect_value("the document's hash", '"' + document_hash(session_.document()) + '"', words[2]);
    } else if (what == "changes") {
        need(3, "changes TEXT");
        expect_value("what saving changes", '"' + summary(session_.changes(), session_.file_bytes()) + '"',
                     words[2]);
    } else if (what == "dirty" || what == "clean") {
        need(2, "dirty or clean");
        expect_value("the document", session_.is_dirty() ? "\"dirty\"" : "\"clean\"", what);
    } else if (what == "steps") {
        need(3, "steps N");
        expect_value("the number of steps", std::to_string(session_.steps().position()), words[2]);
    } else if (what == "nodes") {
        need(3, "nodes N");
        expect_value("the number of nodes", std::to_string(session_.model().node_count()), words[2]);
    } else if (what == "left") {
        need(3, "left N");
        expect_value("the number of commands left out", std::to_string(session_.left().size()), words[2]);
    } else if (what == "gone") {
        need(3, "gone PATH");
        if (find_node(session_.model(), words[2]) != kNone) {
            fail_check(fmt::format("'{}' is there, expected it gone", words[2]));
        }
    } else if (what == "warning" || what == "no-warning") {
        need(3, "warning KIND");
        bool is_found = false;
        for (const EditWarning& warning : edit_warnings(session_)) {
            is_found = is_found || warning.kind == words[2];
        }
        if (is_found != (what == "warning")) {
            fail_check(fmt::format("{} warning '{}', expected {}", is_found ? "found the" : "found no",
                                   words[2], is_found ? "none" : "one"));
        }
    } else if (what == "wishes") {
        need(3, "wishes met|missed");
        expect_wishes(words[2]);
    } else if (what == "solvable") {
        if (const Solved found = solve(words); !found.solved) {
            fail_check(found.words);
        }
    } else if (what == "technique" || what == "progress") {
        expect_progress(words);
    } else if (what == "clip" || what == "starts-with") {
        expect_clip(words);
    } else if (what == "selection") {
        std::vector<std::string> selected;
        for (const std::uint32_t node : session_.selection()) {
            selected.push_back(session_.path_of(node));
        }
        const std::vector<std::string> wanted(words.begin() + 2, words.end());
        if (selected != wanted) {
            fail_check(fmt::format("the selection is '{}', expected '{}'", fmt::join(selected, " "),
                                   fmt::join(wanted, " ")));
        }
    } else if (what == "material") {
        need(5, "material NAME FIELD VALUE");
        expect_value(fmt::format("material {} {}", words[2], words[3]),
                     material_value(session_.model(), words[2], words[3]), words[4]);
    } else if (what.starts_with('/')) {
        need(4, "PATH FIELD VALUE");
        const std::uint32_t node = session_.node_at(what);
        expect_value(fmt::format("{} {}", what, words[2]),
                     node_value(session_.model(), session_.registry(), node, words[2]), words[3]);
    } else {
        throw InputError(fmt::format(
            "expect: found '{}', expected a path, material, hash, changes, dirty, clean, "
            "steps, nodes, left, gone, warning, no-warning, wishes, clip, starts-with, solvable, technique, "
            "progress or selection",
            what));
    }
}

void EditScript::need_context() {
    if (!session_.is_open()) {
        throw InputError("found no scene, expected open FILE or new-room before it");
    }
    if (!context_) {
        context_ = gpu::create_headless_context();
    }
    traced_size_ = ivec2(0);
}

void EditScript::picture(const std::vector<std::string>& words) {
    expect_words(words, 2, 4, "picture FILE [WIDTHxHEIGHT [FRAMES]]");
    const CheckedFrames what = frames_in(words, 2);
    check_image_writable(words[1]);
    need_context();
    session_.refresh_guests();
    editor_frames(session_, settings_, what);
    ImageF image = std::as_const(session_.app()).world().resource<Renderer>().frame->read(render::Aov::final);
    if (holds_linear(words[1])) {
        image = std::as_const(session_.app()).world().resource<Renderer>().frame->read(render::Aov::radiance);
    }
    write_image(words[1], image);
}

void EditScript::compare_with_game(const std::vector<std::string>& words) {
    expect_words(words, 1, 3, "same-as-game [WIDTHxHEIGHT [FRAMES]]");
    const CheckedFrames what = frames_in(words, 1);
    need_context();
    const SameAsGame result = same_as_game(session_, settings_, what);
    if (!result.same()) {
        fail_check(fmt::format("the editor's picture is not the game's: {} differs first; editor {}; game {}",
                               result.first_difference, hash_text(result.editor), hash_text(result.game)));
    }
    print_(fmt::format("= game {:016x}", result.game.final));
}

void EditScript::print_why(const std::vector<std::string>& words) {
    expect_words(words, 3, 4, "print why X,Y [WIDTHxHEIGHT]");
    if (!session_.is_open()) {
        throw InputError("found no scene, expected open FILE or new-room before it");
    }
    const CheckedFrames what = frames_in(words, 3);
    const std::size_t comma = words[2].find(',');
    if (comma == std::string::npos) {
        throw InputError(fmt::format("found '{}', expected X,Y of a pixel", words[2]));
    }
    const ivec2 pixel(whole(words[2].substr(0, comma), 0, what.size.x - 1, "a column"),
                      whole(words[2].substr(comma + 1), 0, what.size.y - 1, "a row"));
    session_.refresh_guests();
    session_.app().show();
    const std::optional<WhyAnswer> answer =
        why_.ask(session_.world().resource<FrameScene>(), settings_, what.size, pixel);
    if (!answer) {
        throw InputError(
            fmt::format("found no surface at {},{}, expected one that is seen there", pixel.x, pixel.y));
    }
    const auto names = names_in(session_);
    print_(fmt::format("{} at {},{}", names(answer->point.entity), pixel.x, pixel.y));
    for (const std::string& line : workbench::why_lines(answer->split, names)) {
        print_(line);
    }
}

void EditScript::review(const std::vector<std::string>& words) {
    expect_words(words, 2, 4, "review FILE.html [WIDTHxHEIGHT [FRAMES]]");
    const CheckedFrames what = frames_in(words, 2);
    check_writable(words[1]);
    need_context();
    write_review(session_, settings_, {{"view", session_.pose()}}, what, words[1]);
}

void EditScript::print_error(const std::vector<std::string>& words) {
    expect_words(words, 2, 4, "print error [WIDTHxHEIGHT [FRAMES]]");
    constexpr int kSamples = 64;
    const CheckedFrames what = frames_in(words, 2);
    if (what.size.x < kErrorStride || what.size.y < kErrorStride) {
        throw InputError(fmt::format("found {}x{}, expected at least {} pixels each way", what.size.x,
                                     what.size.y, kErrorStride));
    }
    need_context();
    session_.refresh_guests();
    editor_frames(session_, settings_, what);
    const ecs::World& world = std::as_const(session_.app()).world();
    reference::SparsePaths paths(world.resource<FrameScene>(), what.size, kErrorStride,
                                 reference::path_settings(settings_));
    paths.trace(kSamples, {});
    const ErrorMap map = error_map(paths, world.resource<Renderer>().frame->read(render::Aov::indirect));
    print_(fmt::format("error {:.1f} % +- {:.1f} % of the indirect light, by {} samples in {} places{}",
                       100 * map.local, 100 * map.uncertainty, map.spp, map.error.size(),
                       map.within_noise ? ": within their noise" : ""));
}

EditScript::Solved EditScript::solve(const std::vector<std::string>& words) {
    expect_words(words, 2, 3, "solvable [RECORDING]");
    if (!session_.is_open()) {
        throw InputError("found no scene, expected open FILE or new-room before it");
    }
    if (!solver_) {
        throw InputError("solvable: this program has no game whose levels are solved");
    }
    Solved found = solver_(session_, words.size() > 2 ? fs::path(words[2]) : fs::path());
    if (context_) {
        context_->make_current();  // the game has drawn in one of its own
    }
    return found;
}

void EditScript::print(const std::vector<std::string>& words) {
    expect_words(words, 2, 4,
                 "print changes|clips|error [WIDTHxHEIGHT [FRAMES]]|hash|history|lights|left|nodes|progress "
                 "[MS]|render-line "
                 "[WIDTHxHEIGHT "
                 "[FRAMES]]|solvable [RECORDING]|warnings|why X,Y [WIDTHxHEIGHT]|wishes");
    const std::string& what = words[1];
    if (what == "changes") {
        const TextChanges changes = session_.changes();
        print_(summary(changes, session_.file_bytes()));
        for (const TextChanges::Line& line : changes.lines) {
            print_(fmt::format("{}{:6} {}", line.added ? '+' : '-', line.line, line.text));
        }
    } else if (what == "solvable") {
        print_(solve(words).words);
    } else if (what == "progress") {
        print_progress(words);
    } else if (what == "clips") {
        print_clips();
    } else if (what == "hash") {
        print_(document_hash(session_.document()));
    } else if (what == "history") {
        for (const HistoryRow& row : session_.history()) {
            print_(fmt::format("{}{} {}", row.current ? '>' : ' ', row.saved ? '*' : ' ', row.text));
        }
    } else if (what == "lights") {
        print_(fmt::format("{:<24} {:<12} {:>10} {:>10} {:>10} {:>6} {:>8}", "light", "type", "cd", "lm",
                           "lx at 1 m", "K", "range m"));
        for (const LightRow& row : lights_table(session_.model())) {
            constexpr const char* kTypes[] = {"directional", "point", "spot"};
            print_(fmt::format("{:<24} {:<12} {:>10.4g} {:>10.4g} {:>10.4g} {:>6.0f} {:>8.3g}", row.path,
                               kTypes[static_cast<int>(row.type)], row.candela, row.lumen, row.lux,
                               row.kelvin.kelvin, row.range));
        }
    } else if (what == "left") {
        for (const LeftCommand& left : session_.left()) {
            print_(fmt::format("{}: {}{}", left.command.text, left.why,
                               left.nearest.empty() ? "" : fmt::format(" ({} comes nearest)", left.nearest)));
        }
    } else if (what == "nodes") {
        for (const std::uint32_t node : session_.model().in_order()) {
            print_(session_.path_of(node));
        }
    } else if (what == "render-line") {
        print_(render_line(session_, settings_, frames_in(words, 2)));
    } else if (what == "warnings") {
        for (const EditWarning& warning : edit_warnings(session_)) {
            print_(fmt::format("{}: {}{}", warning.kind, warning.text,
                               warning.fix.empty() ? "" : fmt::format(" [{}]", warning.fix)));
        }
    } else if (what == "why") {
        print_why(words);
    } else if (what == "error") {
        print_error(words);
    } else if (what == "wishes") {
        const WishSolution found = solution();
        for (const WishOutcome& outcome : found.outcomes) {
            print_(outcome_words(outcome));
        }
    } else {
        throw InputError(fmt::format(
            "print: found '{}', expected changes, clips, error, hash, history, lights, left, nodes, "
            "progress, render-line, solvable, warnings, why or wishes",
            what));
    }
}

}  // namespace lanthorn::editor
