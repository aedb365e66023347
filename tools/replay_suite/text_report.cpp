// The report for a terminal, and for programs that read JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "tools/replay_suite/summary.h"

namespace lanthorn::suite {

namespace {

using nlohmann::json;

std::string counts_line(const Summary& s) {
    const auto n = [&](State state) { return s.counts[static_cast<std::size_t>(state)]; };
    std::string line = fmt::format("{} runs {}: {} ok", s.rows.size(), s.facts.executor, n(State::ok));
    for (const State state : {State::failed, State::crashed, State::flaky, State::accepted}) {
        line += fmt::format(", {} {}", n(state), state_name(state));
    }
    return line + fmt::format("; {} not judged", n(State::not_judged));
}

std::string row_lines(const Row& row) {
    std::string text = fmt::format("  {:<10} {:<18} {}\n", row.word, row.result.id, row.result.line);
    const auto more = [&](const std::string& what) {
        if (!what.empty()) {
            text += fmt::format("  {:<10} {:<18} {}\n", "", "", what);
        }
    };
    more(row.result.repeats);
    more(row.note);
    if (row.red() && !row.result.failure.empty()) {
        more("failure " + row.result.failure);
    }
    return text;
}

std::string pictures_words(const Summary& s) {
    return s.facts.asked.pictures
               ? fmt::format("{} pictures", with_spaces(s.receipt.pictures))
               : fmt::format("no pictures (last time {})", with_spaces(s.ratchet.least.pictures));
}

std::string mutants_line(const Summary& s) {
    if (!s.facts.asked.mutants) {
        return fmt::format(" No mutants (last time {}).", s.ratchet.least.mutants);
    }
    std::string line = fmt::format(" Mutants {} of {}", s.receipt.mutants, s.made(ItemKind::mutant));
    if (s.facts.asked.pictures) {
        line += fmt::format(", in pictures {} of {}", s.receipt.blemishes, s.made(ItemKind::blemish));
    }
    return line + ".";
}

json row_json(const Row& row) {
    return {{"id", row.result.id},
            {"key", row.result.key},
            {"state", state_name(row.state)},
            {"verdict", verdict_name(row.result.verdict)},
            {"word", row.word},
            {"line", row.result.line},
            {"repeats", row.result.repeats},
            {"note", row.note},
            {"failure", row.result.failure},
            {"verify", row.result.verify},
            {"times", row.result.times}};
}

json covered_json(const std::vector<Covered>& list) {
    json to = json::object();
    for (const Covered& c : list) {
        to[c.name] = {{"steps", c.steps}, {"replays", c.replays}};
    }
    return to;
}

}  // namespace

std::string with_spaces(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (std::size_t at = text.size(); at > 3; at -= 3) {
        text.insert(at - 3, 1, ' ');
    }
    return text;
}

std::string text_report(const Summary& s) {
    std::string text = counts_line(s) + "\n";
    for (const Row& row : s.rows) {
        if (row.state != State::ok) {
            text += row_lines(row);
        }
    }
    for (const Row& row : s.mutants) {
        if (row.state != State::ok) {
            text += row_lines(row);
        }
    }
    for (const std::string& note : s.facts.notes) {
        text += note + "\n";
    }
    std::vector<std::string> never;
    for (const Covered& part : s.coverage.parts) {
        if (part.replays.empty()) {
            never.push_back(part.name);
        }
    }
    text += fmt::format("Compared {} steps, {} hashes, {}.", with_spaces(s.receipt.steps),
                        with_spaces(s.receipt.hashes), pictures_words(s));
    if (!s.coverage.parts.empty()) {
        text += fmt::format(" {} of {} parts changed{}{}.", s.receipt.parts, s.coverage.parts.size(),
                            never.empty() ? "" : "; never: ", fmt::join(never, ", "));
    }
    text += mutants_line(s) + "\n";
    text += fmt::format("Build {}, {}, {:.1f} s.\n", s.facts.build, s.facts.machine, s.facts.seconds);
    for (const std::string& fault : s.faults) {
        text += fault + "\n";
    }
    const char* const kVerdicts[] = {"green", "red", "", "", "not all judged"};
    return text + fmt::format("{}: {}\n", s.facts.folder, kVerdicts[s.exit_code()]);
}

std::string json_report(const Summary& s) {
    json receipt, least, rows = json::array(), mutants = json::array(), counts, worth = json::array();
    for (const Count& count : kCounts) {
        receipt[count.name] = s.receipt.*count.member;
        least[count.name] = s.ratchet.least.*count.member;
    }
    for (const Row& row : s.rows) {
        rows.push_back(row_json(row));
    }
    for (const Row& row : s.mutants) {
        mutants.push_back(row_json(row));
    }
    for (std::size_t i = 0; i < kStates; ++i) {
        counts[state_name(static_cast<State>(i))] = s.counts[i];
    }
    for (const Worth& w : s.coverage.worth) {
        worth.push_back({{"replay", w.replay}, {"steps", w.steps}, {"alone", w.alone}});
    }
    const json text = {{"exit_code", s.exit_code()},
                       {"red", s.red()},
                       {"counts", counts},
                       {"faults", s.faults},
                       {"receipt", receipt},
                       {"ratchet", s.ratchet.there ? least : json()},
                       {"run",
                        {{"folder", s.facts.folder},
                         {"build", s.facts.build},
                         {"machine", s.facts.machine},
                         {"command", s.facts.command},
                         {"day", s.facts.day},
                         {"executor", s.facts.executor},
                         {"notes", s.facts.notes},
                         {"seconds", s.facts.seconds}}},
                       {"rows", rows},
                       {"mutants", mutants},
                       {"coverage",
                        {{"parts", covered_json(s.coverage.parts)},
                         {"systems", covered_json(s.coverage.systems)},
                         {"worth", worth},
                         {"subset", s.coverage.subset}}}};
    return text.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace lanthorn::suite
