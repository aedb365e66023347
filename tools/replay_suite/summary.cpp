#include "tools/replay_suite/summary.h"

#include <fmt/format.h>

#include <algorithm>

namespace lanthorn::suite {

namespace {

State state_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::ok:
            return State::ok;
        case Verdict::failed:
        case Verdict::bad_input:
            return State::failed;
        case Verdict::crashed:
        case Verdict::timed_out:
        case Verdict::stuck:
            return State::crashed;
        case Verdict::flaky:
            return State::flaky;
        case Verdict::not_judged:
            break;
    }
    return State::not_judged;
}

const Acceptance* find(const std::vector<Acceptance>& accepted, const std::string& failure) {
    const auto found = std::ranges::find(accepted, failure, &Acceptance::failure);
    return found == accepted.end() ? nullptr : &*found;
}

Row row_of(Result result, const std::vector<Acceptance>& accepted, std::string_view today) {
    Row row{std::move(result), State::ok, "", ""};
    row.state = state_of(row.result.verdict);
    row.word = verdict_words(row.result.verdict);
    if (row.red()) {
        if (const Acceptance* a = find(accepted, row.result.failure)) {
            const bool holds = a->until >= today;
            row.state = holds ? State::accepted : row.state;
            row.word = holds ? "accepted" : "EXPIRED";
            row.note = fmt::format("accepted until {}: \"{}\"", a->until, a->reason);
        }
    }
    for (const Acceptance& a : accepted) {
        if (recording_of(a.failure) != row.result.id || a.failure == row.result.failure) {
            continue;
        }
        if (row.state == State::ok) {
            row.state = State::failed;
            row.word = "NEEDLESS";
            row.result.line =
                fmt::format("passes, though {} is accepted: take it out of {}", a.failure, kAcceptedFile);
            row.note = fmt::format("accepted until {}: \"{}\"", a.until, a.reason);
        } else if (row.red() && row.note.empty()) {
            row.note = fmt::format("another failure is accepted, {}", a.failure);
        }
    }
    return row;
}

}  // namespace

const char* state_name(State state) {
    constexpr const char* kNames[kStates] = {"ok", "failed", "crashed", "flaky", "accepted", "not judged"};
    return kNames[static_cast<std::size_t>(state)];
}

std::size_t Summary::made(ItemKind kind) const {
    return static_cast<std::size_t>(
        std::ranges::count(mutants, kind, [](const Row& row) { return row.result.kind; }));
}

bool Summary::red() const {
    const auto is_red = [](const Row& row) { return row.red(); };
    return !faults.empty() || std::ranges::any_of(rows, is_red) || std::ranges::any_of(mutants, is_red);
}

int Summary::exit_code() const {
    const auto lost = [](const Row& row) { return row.state == State::not_judged; };
    return red() ? 1 : std::ranges::any_of(rows, lost) || std::ranges::any_of(mutants, lost) ? 4 : 0;
}

Summary summarise(RunFacts facts, std::vector<Result> results, const std::vector<Acceptance>& accepted,
                  const Ratchet& ratchet, std::string_view today, bool whole) {
    Summary summary;
    summary.facts = std::move(facts);
    summary.ratchet = ratchet;
    summary.receipt = receipt_of(results);
    summary.coverage = coverage_of(results);
    std::vector<std::string> ids;
    for (Result& result : results) {
        ids.push_back(result.id);
        if (result.good() && (result.kind == ItemKind::watch || (is_fault(result.kind) && !result.made()))) {
            continue;  // it only asked, or found nothing to alter
        }
        const bool mutant = is_fault(result.kind);
        Row row = row_of(std::move(result), accepted, today);
        if (mutant && row.state == State::failed) {
            row.word = "SURVIVED";
        }
        (mutant ? summary.mutants : summary.rows).push_back(std::move(row));
    }
    if (static_cast<double>(summary.receipt.blemishes) >=
        kCaught * static_cast<double>(summary.made(ItemKind::blemish))) {
        for (Row& row : summary.mutants) {
            if (row.result.kind == ItemKind::blemish && row.state == State::failed) {
                row.state = State::accepted;
                row.note = fmt::format("{:.0f} % of the faults of pictures must be caught", 100 * kCaught);
            }
        }
    }
    const auto order = [](const Row& a, const Row& b) {
        const auto rank = [](const Row& row) {
            return row.red() ? 0 : row.state == State::not_judged ? 1 : row.state == State::accepted ? 2 : 3;
        };
        return std::pair(rank(a), a.result.id) < std::pair(rank(b), b.result.id);
    };
    std::ranges::sort(summary.rows, order);
    std::ranges::sort(summary.mutants, order);
    for (const Row& row : summary.rows) {
        ++summary.counts[static_cast<std::size_t>(row.state)];
    }
    if (whole) {
        for (const Acceptance& a : accepted) {
            if (std::ranges::find(ids, recording_of(a.failure)) == ids.end()) {
                summary.faults.push_back(fmt::format("{}: {} is accepted, but there is no such recording",
                                                     kAcceptedFile, a.failure));
            }
        }
        for (const std::string& slip : slips(summary.receipt, ratchet, summary.facts.asked)) {
            summary.faults.push_back("ratchet: " + slip);
        }
    }
    if (summary.receipt.hashes == 0 &&
        summary.counts[static_cast<std::size_t>(State::not_judged)] < summary.rows.size()) {
        summary.faults.push_back("no hash was compared: nothing was checked");
    }
    return summary;
}

}  // namespace lanthorn::suite
