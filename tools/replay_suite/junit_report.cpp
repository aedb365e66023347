// The report as JUnit XML, which continuous integration reads. A flaky replay is a failure in it.
#include <fmt/format.h>

#include "lanthorn/core/printable.h"
#include "tools/replay_suite/summary.h"

namespace lanthorn::suite {

namespace {

double seconds_of(const Row& row) {
    return row.result.times.is_object() ? row.result.times.value("wall_s", 0.0) : 0.0;
}

std::string case_xml(const Row& row, const char* group) {
    std::string text = fmt::format("  <testcase classname=\"replay.{}\" name=\"{}\" time=\"{:.3f}\"", group,
                                   markup_text(row.result.id), seconds_of(row));
    const std::string message = markup_text(row.word + ": " + row.result.line);
    std::string body = row.result.repeats;
    for (const std::string& more : {row.note, row.result.failure}) {
        body += (body.empty() || more.empty() ? "" : "\n") + more;
    }
    if (row.result.crash) {
        for (const std::string& frame : row.result.crash->frames) {
            body += "\n" + frame;
        }
    }
    switch (row.state) {
        case State::ok:
            return text + "/>\n";
        case State::crashed:
            return text + fmt::format(">\n   <error message=\"{}\" type=\"{}\">{}</error>\n  </testcase>\n",
                                      message, verdict_name(row.result.verdict), markup_text(body));
        case State::failed:
        case State::flaky:
            return text +
                   fmt::format(">\n   <failure message=\"{}\" type=\"{}\">{}</failure>\n  </testcase>\n",
                               message, verdict_name(row.result.verdict), markup_text(body));
        case State::accepted:
        case State::not_judged:
            break;
    }
    return text + fmt::format(">\n   <skipped message=\"{}\">{}</skipped>\n  </testcase>\n", message,
                              markup_text(body));
}

}  // namespace

std::string junit_report(const Summary& s) {
    std::size_t failures = s.faults.size(), errors = 0, skipped = 0;
    double seconds = 0;
    std::string cases;
    const auto add = [&](const std::vector<Row>& rows, const char* group) {
        for (const Row& row : rows) {
            failures += row.state == State::failed || row.state == State::flaky ? 1 : 0;
            errors += row.state == State::crashed ? 1 : 0;
            skipped += row.state == State::accepted || row.state == State::not_judged ? 1 : 0;
            seconds += seconds_of(row);
            cases += case_xml(row, group);
        }
    };
    add(s.rows, "state");
    add(s.mutants, "mutants");
    for (const std::string& fault : s.faults) {
        cases += fmt::format(
            "  <testcase classname=\"replay.suite\" name=\"suite\">\n   <failure message=\"{}\"/>\n  "
            "</testcase>\n",
            markup_text(fault));
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n <testsuite name=\"{}\" tests=\"{}\" "
        "failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\">\n{} </testsuite>\n</testsuites>\n",
        markup_text(s.facts.folder), s.rows.size() + s.mutants.size() + s.faults.size(), failures, errors,
        skipped, seconds, cases);
}

}  // namespace lanthorn::suite
