// The report as one HTML page: no network, a list without scripts.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "lanthorn/core/printable.h"
#include "tools/replay_suite/html_parts.h"
#include "tools/replay_suite/html_pictures.h"
#include "tools/replay_suite/summary.h"
#include "tools/replay_suite/timeline.h"

namespace lanthorn::suite {

namespace {

using nlohmann::json;

constexpr const char* kChecks[] = {"live", "state", "sensors", "expectations", "pictures", "light"};
constexpr const char* kSigns[kStates] = {"✓", "✗", "⚡", "≈", "!", "?"};
constexpr const char* kClasses[kStates] = {"ok", "failed", "crashed", "flaky", "accepted", "lost"};

std::size_t index(State state) {
    return static_cast<std::size_t>(state);
}

// A name that a link may hold.
std::string anchor(const std::string& id) {
    std::string name = "r-";
    for (const char c : id) {
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
    }
    return name;
}

std::string state_cell(const Row& row) {
    return fmt::format("<td data-n=\"{}\"><span class=\"sign {}\">{}</span> {}</td>",
                       row.red() ? index(row.state) : 10 + index(row.state), kClasses[index(row.state)],
                       kSigns[index(row.state)], markup_text(row.word));
}

std::string check_cell(const Row& row, const char* name) {
    if (row.result.verify.is_object()) {
        for (const json& check : row.result.verify.value("checks", json::array())) {
            if (!check.is_object() || check.value("name", "") != name) {
                continue;
            }
            const std::string verdict = check.value("verdict", "none");
            const char* sign = verdict == "ok" ? "✓" : verdict == "failed" ? "✗" : "–";
            return fmt::format("<td data-n=\"{}\" title=\"{}\"><span class=\"sign {}\">{}</span></td>",
                               verdict == "failed" ? 0
                               : verdict == "ok"   ? 2
                                                   : 1,
                               markup_text(check.value("text", "")),
                               verdict == "ok"       ? "ok"
                               : verdict == "failed" ? "failed"
                                                     : "none",
                               sign);
        }
    }
    return "<td data-n=\"1\" title=\"not checked\"><span class=\"sign none\">–</span></td>";
}

std::string number_cell(std::uint64_t n) {
    return fmt::format("<td class=\"n\" data-n=\"{}\">{}</td>", n, with_spaces(n));
}

double speed_of(const Row& row) {
    return row.result.times.is_object() ? row.result.times.value("simulated_steps_per_second", 0.0) : 0.0;
}

std::string table(const Summary& s) {
    std::string html = "<table id=\"runs\"><thead><tr><th>verdict</th><th>replay</th>";
    for (const char* check : kChecks) {
        html += fmt::format("<th>{}</th>", check);
    }
    html +=
        "<th class=\"n\">steps</th><th class=\"n\">hashes</th><th "
        "class=\"n\">steps/s</th></tr></thead>\n<tbody>\n";
    for (const Row& row : s.rows) {
        html += fmt::format("<tr data-state=\"{0}\" data-of=\"{1}\">{2}<td><a href=\"#{1}\">{3}</a>",
                            kClasses[index(row.state)], anchor(row.result.id), state_cell(row),
                            markup_text(row.result.id));
        if (row.state != State::ok) {
            html += fmt::format("<br><span class=\"small\">{}</span>", markup_text(row.result.line));
        }
        html += "</td>";
        for (const char* check : kChecks) {
            html += check_cell(row, check);
        }
        html += number_cell(row.result.count("steps")) + number_cell(row.result.count("hashes_compared")) +
                number_cell(static_cast<std::uint64_t>(speed_of(row))) + "</tr>\n";
    }
    return html + "</tbody></table>\n";
}

std::string copy_line(const std::string& line) {
    return fmt::format("<button class=\"copy\">copy</button><pre>{}</pre>\n", markup_text(line));
}

// What to do next about a result that is not well.
std::string commands(const Row& row, const std::string& folder) {
    const std::string file = (std::filesystem::path(folder) / row.result.id).string();
    std::string html;
    const json divergences =
        row.result.verify.is_object() ? row.result.verify.value("divergences", json::array()) : json::array();
    if (!divergences.empty()) {
        html += copy_line(fmt::format("lanthorn replay bisect {}", file));
        html += copy_line(fmt::format("lanthorn replay play {} --from {}", file,
                                      divergences.front().value("step", std::uint64_t{0})));
    } else {
        html += copy_line(fmt::format("lanthorn replay verify {}", file));
    }
    if (row.result.verify.is_object()) {
        for (const json& picture : row.result.verify.value("pictures", json::array())) {
            if (picture.is_object() &&
                (picture.value("failed", false) || picture.value("light_failed", false))) {
                html += copy_line(fmt::format("lanthorn replay accept {}:{} --suite {} --reason \"...\"",
                                              row.result.id, picture.value("mark", ""), folder));
            }
        }
    }
    if (row.red() && !row.result.failure.empty()) {
        html +=
            copy_line(fmt::format("lanthorn replay accept {} --suite {} --reason \"...\" --until YYYY-MM-DD",
                                  row.result.failure, folder));
    }
    return html;
}

std::string paragraph(const std::string& text) {
    return text.empty() ? "" : fmt::format("<p>{}</p>\n", markup_text(text));
}

std::string detail(const Row& row, const std::string& folder) {
    std::string html = fmt::format(
        "<details id=\"{}\"{}{}><summary><span class=\"sign {}\">{}</span> {} <span "
        "class=\"small\">{}</span></summary>\n",
        anchor(row.result.id), row.red() ? " open data-red" : "", "", kClasses[index(row.state)],
        kSigns[index(row.state)], markup_text(row.result.id), markup_text(row.word));
    html += paragraph(row.result.line) + paragraph(row.result.repeats) + paragraph(row.note);
    html += timeline_svg(row.result);
    if (row.result.verify.is_object()) {
        html += "<pre>";
        for (const json& check : row.result.verify.value("checks", json::array())) {
            if (check.is_object()) {
                html += markup_text(fmt::format("{:<13} {:<7} {}\n", check.value("name", ""),
                                                check.value("verdict", ""), check.value("text", "")));
            }
        }
        for (const json& part : row.result.verify.value("parts_not_compared", json::array())) {
            html += markup_text(
                fmt::format("not compared  {}\n", part.is_string() ? part.get<std::string>() : part.dump()));
        }
        html += "</pre>\n";
        const json divergences = row.result.verify.value("divergences", json::array());
        if (!divergences.empty()) {
            html +=
                "<table><thead><tr><th class=\"n\">step</th><th class=\"n\">seconds</th><th>parts that "
                "differ</th></tr></thead><tbody>\n";
            for (const json& d : divergences) {
                std::vector<std::string> parts;
                for (const json& part : d.value("parts", json::array())) {
                    parts.push_back(part.is_string() ? part.get<std::string>() : part.dump());
                }
                html += fmt::format("<tr>{}<td class=\"n\">{:.2f}</td><td>{}</td></tr>\n",
                                    number_cell(d.value("step", std::uint64_t{0})), d.value("seconds", 0.0),
                                    markup_text(fmt::format("{}", fmt::join(parts, ", "))));
            }
            html += "</tbody></table>\n";
        }
    }
    html += pictures_html(row.result);
    if (row.result.crash) {
        html += "<pre>";
        for (const std::string& frame : row.result.crash->frames) {
            html += markup_text(frame) + "\n";
        }
        html += "</pre>\n";
    } else if (row.result.times.is_object() && row.result.times.contains("frames")) {
        html += fmt::format("<p>Where it was, after step {}:</p><pre>",
                            row.result.times.value("step", std::uint64_t{0}));
        for (const json& frame : row.result.times["frames"]) {
            html += markup_text(frame.get<std::string>()) + "\n";
        }
        html += "</pre>\n";
    }
    if (row.state != State::ok) {
        html += commands(row, folder);
    }
    return html + "</details>\n";
}

std::string strip(const Summary& s) {
    const int code = s.exit_code();
    std::string html = fmt::format("<div class=\"strip {}\"><div class=\"verdict\">{} {}</div>\n",
                                   code == 0   ? ""
                                   : code == 1 ? "red"
                                               : "lost",
                                   code == 0   ? "✓"
                                   : code == 1 ? "✗"
                                               : "?",
                                   code == 0   ? "All as expected"
                                   : code == 1 ? "Something is wrong"
                                               : "Not all could be judged");
    for (const std::string& fault : s.faults) {
        html += paragraph(fault);
    }
    html += "<ul class=\"receipt\">";
    for (const Count& count : kCounts) {
        std::string of;
        if (count.member == &Receipt::mutants && s.facts.asked.of(count)) {
            of = fmt::format(" of {}", s.made(ItemKind::mutant));
        } else if (count.member == &Receipt::blemishes && s.facts.asked.of(count)) {
            of = fmt::format(" of {}", s.made(ItemKind::blemish));
        } else if (count.member == &Receipt::parts && !s.coverage.parts.empty()) {
            of = fmt::format(" of {}", s.coverage.parts.size());
        } else if (count.member == &Receipt::systems && !s.coverage.systems.empty()) {
            of = fmt::format(" of {}", s.coverage.systems.size());
        }
        const std::string last = s.ratchet.there ? fmt::format(" title=\"last time {}\"",
                                                               with_spaces(s.ratchet.least.*count.member))
                                                 : "";
        html += fmt::format("<li{}><b>{}</b>{} <span>{}</span></li>", last,
                            s.facts.asked.of(count) ? with_spaces(s.receipt.*count.member) : "–", of,
                            count.member == &Receipt::parts       ? "parts changed"
                            : count.member == &Receipt::systems   ? "systems ran"
                            : count.member == &Receipt::mutants   ? "mutants caught"
                            : count.member == &Receipt::blemishes ? "in pictures"
                                                                  : count.name);
    }
    html += fmt::format("</ul>\n<div class=\"small\">{}, {}, {}; {} runs {}, {:.1f} s</div>\n",
                        markup_text(s.facts.build), markup_text(s.facts.machine), markup_text(s.facts.day),
                        s.rows.size() + s.mutants.size(), markup_text(s.facts.executor), s.facts.seconds);
    for (const std::string& note : s.facts.notes) {
        html += fmt::format("<div class=\"small\">{}</div>\n", markup_text(note));
    }
    return html + copy_line(s.facts.command) + "</div>\n";
}

std::string counters(const Summary& s) {
    std::string html = "<div class=\"counters\">";
    for (std::size_t i = 0; i < kStates; ++i) {
        html += fmt::format(
            "<button data-state=\"{0}\"><span class=\"sign {0}\">{1}</span> <b>{2}</b>{3}</button>",
            kClasses[i], kSigns[i], s.counts[i], state_name(static_cast<State>(i)));
    }
    return html +
           "</div>\n<div class=\"tools\"><input id=\"filter\" type=\"search\" placeholder=\"filter by text ( "
           "/ )\" aria-label=\"filter by text\">"
           "<span class=\"small\" id=\"shown\"></span><span class=\"small\">n, p: next and previous "
           "failure</span></div>\n";
}

std::string coverage(const Summary& s) {
    if (s.coverage.parts.empty()) {
        return "";
    }
    std::string html = "<h2 id=\"coverage\">What the replays exercise</h2>\n<pre>";
    for (const std::string& line : coverage_lines(s.coverage)) {
        html += markup_text(line) + "\n";
    }
    return html + "</pre>\n";
}

std::string mutants(const Summary& s) {
    if (s.mutants.empty()) {
        return "";
    }
    std::string html = fmt::format(
        "<h2 id=\"mutants\">Mutants: {} of {} caught by "
        "name{}</h2>\n<table><thead><tr><th>verdict</th><th>mutant</th>"
        "<th>found as</th></tr></thead><tbody>\n",
        s.receipt.mutants, s.made(ItemKind::mutant),
        s.facts.asked.pictures
            ? fmt::format("; in pictures {} of {}", s.receipt.blemishes, s.made(ItemKind::blemish))
            : "");
    for (const Row& row : s.mutants) {
        html += fmt::format("<tr>{}<td>{}</td><td>{}</td></tr>\n", state_cell(row),
                            markup_text(row.result.id), markup_text(row.result.line));
    }
    return html + "</tbody></table>\n";
}

}  // namespace

std::string html_report(const Summary& s) {
    std::string html = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\">"
        "<title>{} {}</title>\n<style>{}</style></head><body>\n<h1>Replay suite {}</h1>\n",
        s.exit_code() == 0 ? "green:" : "red:", markup_text(s.facts.folder), kPageStyle,
        markup_text(s.facts.folder));
    html += strip(s) + counters(s) + table(s) + "<h2>Replays</h2>\n";
    for (const Row& row : s.rows) {
        html += detail(row, s.facts.folder);
    }
    html += coverage(s) + mutants(s);
    return html + "<script>" + kPageScript + "</script></body></html>\n";
}

}  // namespace lanthorn::suite
