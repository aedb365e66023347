#include "tools/editor/window/kept_views.h"

#include <fmt/format.h>

#include <algorithm>

#include "lanthorn/core/error.h"

namespace lanthorn::edit_window {

using workbench::CameraPose;

KeptViews KeptViews::parse(std::string_view text, std::string_view source) {
    KeptViews result;
    int count = 0;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        ++count;
        const std::size_t second = line.find(' ', 2);
        if (line.size() < 2 || line[0] < '1' || line[0] > '9' || line[1] != ' ' ||
            second == std::string_view::npos || second + 1 == line.size()) {
            throw InputError(source, fmt::format("line {}", count), "no view: expected NUMBER POSE FILE");
        }
        const std::string file(line.substr(second + 1));
        if (result.files_.empty() || result.files_.back().first != file) {
            result.files_.emplace_back(file, Views{});
        }
        try {
            result.files_.back().second[static_cast<std::size_t>(line[0] - '1')] =
                workbench::pose_of(std::string(line.substr(2, second - 2)));
        } catch (const InputError& error) {
            throw InputError(source, fmt::format("line {}", count), error.what());
        }
    }
    return result;
}

std::string KeptViews::text() const {
    std::string result;
    for (const auto& [file, views] : files_) {
        const bool writable = !file.empty() && file.find('\n') == std::string::npos;
        for (std::size_t i = 0; i < views.size() && writable; ++i) {
            if (views[i]) {
                result += fmt::format("{} {} {}\n", i + 1, workbench::text_of(*views[i]), file);
            }
        }
    }
    return result;
}

KeptViews::Views& KeptViews::of(const std::string& file) {
    auto found = std::ranges::find(files_, file, &std::pair<std::string, Views>::first);
    if (found == files_.end()) {
        files_.emplace_back(file, Views{});
        found = files_.end() - 1;
    }
    std::rotate(files_.begin(), found, found + 1);
    files_.resize(std::min(files_.size(), kFiles));
    return files_.front().second;
}

void KeptViews::keep(const std::string& file, int number, const CameraPose& pose) {
    of(file).at(static_cast<std::size_t>(number - 1)) = pose;
}

const CameraPose* KeptViews::find(const std::string& file, int number) const {
    const auto found = std::ranges::find(files_, file, &std::pair<std::string, Views>::first);
    if (found == files_.end()) {
        return nullptr;
    }
    const auto& view = found->second.at(static_cast<std::size_t>(number - 1));
    return view ? &*view : nullptr;
}

void KeptViews::copy(const std::string& from, const std::string& to) {
    const auto found = std::ranges::find(files_, from, &std::pair<std::string, Views>::first);
    if (found != files_.end() && from != to) {
        const Views views = found->second;
        of(to) = views;
    }
}

void KeptViews::forget(const std::string& file) {
    std::erase_if(files_, [&](const auto& each) { return each.first == file; });
}

void ViewHistory::leave(const LookedAt& from, double now, bool jump) {
    if ((jump || now - moved_at_ > kRested) && (before_.empty() || !(before_.back() == from))) {
        before_.push_back(from);
        if (before_.size() > kMost) {
            before_.erase(before_.begin());
        }
    }
    after_.clear();
    moved_at_ = jump ? -1e9 : now;
}

std::optional<LookedAt> ViewHistory::back(const LookedAt& here, double now) {
    while (!before_.empty() && before_.back() == here) {
        before_.pop_back();
    }
    if (before_.empty()) {
        return std::nullopt;
    }
    const LookedAt view = before_.back();
    before_.pop_back();
    after_.push_back(here);
    moved_at_ = now - 2 * kRested;  // what comes next leaves this view
    return view;
}

std::optional<LookedAt> ViewHistory::forth(const LookedAt& here, double now) {
    if (after_.empty()) {
        return std::nullopt;
    }
    const LookedAt view = after_.back();
    after_.pop_back();
    before_.push_back(here);
    moved_at_ = now - 2 * kRested;
    return view;
}

}  // namespace lanthorn::edit_window
