#include "lanthorn/replay/player.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "lanthorn/core/error.h"

namespace lanthorn::replay {

std::string Divergence::describe() const {
    const std::string where = fmt::format(
        "step {}: {}: not as recorded", step,
        parts.empty() ? "a part whose tag is the same" : fmt::format("{}", fmt::join(parts, ", ")));
    return expected == actual ? where
                              : fmt::format("{} (root {:016x}, expected {:016x})", where, actual, expected);
}

Player::Player(const std::string& file, std::shared_ptr<const Recording> recording,
               const RecordingHeader& header)
    : recording_(std::move(recording)) {
    const RecordingHeader& recorded = recording_->header;
    const auto fail = [&](const char* place, const auto& found, const auto& expected) {
        throw InputError(file, place,
                         fmt::format("recorded with {}, but this program has {}", found, expected));
    };
    if (recorded.level != header.level) {
        fail("level", recorded.level, header.level);
    }
    if (recorded.level_hash != header.level_hash) {
        fail("level", fmt::format("contents {:016x} of {}", recorded.level_hash, header.level),
             fmt::format("{:016x}", header.level_hash));
    }
    if (recorded.step_rate != header.step_rate) {
        fail("step_rate", recorded.step_rate, header.step_rate);
    }
    if (recorded.input_format != header.input_format || recorded.input_size != header.input_size) {
        fail("input_format", fmt::format("{} ({} bytes)", recorded.input_format, recorded.input_size),
             fmt::format("{} ({} bytes)", header.input_format, header.input_size));
    }
    if (recorded.sensors != header.sensors) {
        fail("sensors", fmt::format("{}", fmt::join(recorded.sensors, " ")),
             fmt::format("{}", fmt::join(header.sensors, " ")));
    }
    find_common(file, header);
    tags_.assign(recorded.parts.size(), 0);
}

void Player::find_common(const std::string& file, const RecordingHeader& header) {
    const RecordingHeader& recorded = recording_->header;
    Comparison& c = comparison_;
    for (std::size_t i = 0; i < recorded.parts.size(); ++i) {
        const auto own = std::ranges::find(header.parts, recorded.parts[i]);
        const auto k = static_cast<std::size_t>(own - header.parts.begin());
        if (own == header.parts.end()) {
            c.not_compared.push_back(recorded.parts[i] + ": this program has none");
        } else if (recorded.schemas[i] != 0 && recorded.schemas[i] != header.schemas[k]) {
            c.not_compared.push_back(recorded.parts[i] + ": its fields have changed");
        } else {
            common_.push_back({i, k});
            c.parts.push_back(recorded.parts[i]);
        }
    }
    c.roots = c.not_compared.empty();
    for (const std::string& own : header.parts) {
        if (std::ranges::find(recorded.parts, own) == recorded.parts.end()) {
            c.not_compared.push_back(own + ": the recording has none");
        }
    }
    c.changed.assign(common_.size(), 0);
    if (common_.empty() && !(recorded.parts.empty() && header.parts.empty())) {
        throw InputError(
            file, "parts",
            fmt::format("recorded with {}, of which this program has none, expected some part in "
                        "common to compare",
                        fmt::join(recorded.parts, " ")));
    }
}

std::vector<std::string> Player::differing(std::span<const std::uint64_t> hashes,
                                           const std::vector<bool>& changed) const {
    std::vector<std::string> parts;
    for (const Pair& part : common_) {
        const std::uint64_t hash = hashes[part.own];
        if (static_cast<std::uint8_t>(hash) != tags_[part.recorded] ||
            (!before_.empty() && (hash != before_[part.own]) != changed[part.recorded])) {
            parts.push_back(recording_->header.parts[part.recorded]);
        }
    }
    return parts;
}

void Player::count_changes(std::span<const std::uint64_t> hashes) {
    bool any = false;
    for (std::size_t i = 0; !before_.empty() && i < common_.size(); ++i) {
        const bool changed = hashes[common_[i].own] != before_[common_[i].own];
        comparison_.changed[i] += changed ? 1 : 0;
        any = any || changed;
    }
    comparison_.live += any ? 1 : 0;
}

bool Player::check(std::span<const std::uint64_t> hashes) {
    assert(!done());
    const RecordedStep& step = recording_->steps[next_];
    if (!step.is_state_known()) {
        count_changes(hashes);
        before_.assign(hashes.begin(), hashes.end());
        ++comparison_.unknown;
        ++next_;
        return true;
    }
    std::vector<bool> changed(tags_.size(), false);
    for (const ChangedPart& part : step.changed) {
        tags_[part.part] = part.tag;
        changed[part.part] = true;
    }
    std::uint64_t root = 0;
    if (comparison_.roots) {
        std::vector<std::uint64_t> of_recorded;
        of_recorded.reserve(common_.size());
        for (const Pair& part : common_) {
            of_recorded.push_back(hashes[part.own]);
        }
        root = root_of(of_recorded);
    }
    const bool same_root = comparison_.roots && root == step.root;
    const std::vector<std::string> parts =
        same_root ? std::vector<std::string>() : differing(hashes, changed);
    const bool same = comparison_.roots ? same_root : parts.empty();
    if (!same) {
        note(parts, root);
    }
    apart_ = !same;
    count_changes(hashes);
    before_.assign(hashes.begin(), hashes.end());
    ++comparison_.steps;
    comparison_.hashes += common_.size();
    comparison_.equal += comparison_.divergences.empty() ? 1 : 0;
    ++next_;
    return same;
}

void Player::note(const std::vector<std::string>& parts, std::uint64_t root) {
    std::vector<Divergence>& all = comparison_.divergences;
    if (apart_ && !all.empty()) {
        all.back().last = next_;
    } else if (all.size() < Comparison::kMostDivergences) {
        all.push_back({next_, next_, parts, comparison_.roots ? recording_->steps[next_].root : 0, root});
    }
}

std::optional<Divergence> Player::divergence() const {
    return comparison_.divergences.empty() ? std::nullopt : std::optional(comparison_.divergences.front());
}

void Player::go_to(std::uint64_t step) {
    const auto to = static_cast<std::size_t>(std::min<std::uint64_t>(step, recording_->steps.size()));
    before_.clear();
    apart_ = false;
    if (to < next_) {
        std::ranges::fill(tags_, 0);
        next_ = 0;
    }
    for (; next_ < to; ++next_) {
        for (const ChangedPart& part : recording_->steps[next_].changed) {
            tags_[part.part] = part.tag;
        }
    }
}

}  // namespace lanthorn::replay
