#include "tools/replay_suite/accepted.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>

#include "engine/core/json.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "tools/replay_suite/files.h"

namespace lanthorn::suite {

using nlohmann::json;

bool is_day(std::string_view text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') {
        return false;
    }
    const auto number = [&](std::size_t at, std::size_t length, int& to) {
        const char* end = text.data() + at + length;
        return std::from_chars(text.data() + at, end, to).ptr == end;
    };
    int y = 0, m = 0, d = 0;
    return number(0, 4, y) && number(5, 2, m) && number(8, 2, d) && y > 0 && m > 0 && d > 0 &&
           std::chrono::year_month_day(std::chrono::year(y), std::chrono::month(static_cast<unsigned>(m)),
                                       std::chrono::day(static_cast<unsigned>(d)))
               .ok();
}

std::string today() {
    const std::chrono::year_month_day now(
        std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(now.year()), static_cast<unsigned>(now.month()),
                       static_cast<unsigned>(now.day()));
}

std::string recording_of(const std::string& failure) {
    const std::size_t dash = failure.rfind('-');
    return dash == std::string::npos ? failure : failure.substr(0, dash);
}

std::vector<Acceptance> read_accepted(const std::filesystem::path& folder) {
    const auto file = folder / kAcceptedFile;
    const std::string text = read_if_there(file);
    if (text.empty()) {
        return {};
    }
    const json from = parse_json_object(text, file.string(), "accepted failures");
    std::vector<Acceptance> list;
    try {
        for (const json& entry : from.at("accepted")) {
            Acceptance a{entry.at("failure"), entry.at("reason"), entry.at("until")};
            if (!is_day(a.until) || a.reason.empty()) {
                throw InputError(file.string(), a.failure,
                                 "expected a reason and a day, as in \"until\": \"2026-12-31\"");
            }
            list.push_back(std::move(a));
        }
    } catch (const json::exception& error) {
        throw InputError(file.string(), "",
                         std::string("expected {\"accepted\": [{\"failure\": ..., \"reason\": ..., "
                                     "\"until\": ...}]}: ") +
                             error.what());
    }
    return list;
}

void accept(const std::filesystem::path& folder, const Acceptance& acceptance, std::string_view today) {
    if (!is_day(acceptance.until) || acceptance.until < today) {
        throw InputError("--until: found '" + acceptance.until + "', expected a day from " +
                         std::string(today) + " on, as in 2026-12-31");
    }
    if (acceptance.reason.find_first_not_of(" \t") == std::string::npos) {
        throw InputError("--reason: found nothing, expected why this difference is right for now");
    }
    std::vector<Acceptance> list = read_accepted(folder);
    std::erase_if(list, [&](const Acceptance& a) { return a.failure == acceptance.failure; });
    list.push_back(acceptance);
    std::ranges::sort(list, {}, &Acceptance::failure);
    json entries = json::array();
    for (const Acceptance& a : list) {
        entries.push_back({{"failure", a.failure}, {"reason", a.reason}, {"until", a.until}});
    }
    write_file(folder / kAcceptedFile, json{{"accepted", entries}}.dump(2) + "\n");
}

}  // namespace lanthorn::suite
