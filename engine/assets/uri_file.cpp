#include "engine/assets/uri_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "engine/assets/uri.h"
#include "lanthorn/core/printable.h"

namespace lanthorn {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> readings(std::string_view uri) {
    std::vector<std::string> all;
    for (std::string text : {percent_decoded(uri), std::string(uri)}) {
        for (const bool slashes : {false, true}) {
            if (slashes) {
                std::ranges::replace(text, '\\', '/');
            }
            if (std::ranges::find(all, text) == all.end()) {
                all.push_back(text);
            }
        }
    }
    return all;
}

fs::path home_of(const fs::path& folder) {
    return folder.empty() ? fs::path(".") : folder;
}

// Below `folder` or, `itself`, the folder.
bool stands_in(const fs::path& folder, const fs::path& path, bool itself = false) {
    std::error_code error;
    const fs::path home = fs::weakly_canonical(home_of(folder), error);
    const fs::path place = error ? fs::path() : fs::weakly_canonical(path, error);
    if (error) {
        return false;
    }
    const auto [end, rest] = std::mismatch(home.begin(), home.end(), place.begin(), place.end());
    return end == home.end() && (itself || rest != place.end());
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return text;
}

// `name` as it is written on disk, as systems find it that do not tell cases apart; empty if there is none,
// or more than one.
fs::path in_any_case(const fs::path& folder, const fs::path& name, bool allow_outside, FolderNames& names) {
    constexpr std::size_t kLongest = 4096;  // bytes: what systems allow for a path
    std::error_code error;
    fs::path place = fs::canonical(home_of(folder), error);  // of `found`
    fs::path found;
    if (error || name.native().size() > kLongest) {
        return {};
    }
    for (const fs::path& part : name) {
        fs::path own = part;
        if (part != "." && part != ".." && !fs::exists(place / part, error)) {
            if (!allow_outside && !stands_in(folder, place, true)) {
                return {};
            }
            own = names.in_any_case(place, part.string());
            if (own.empty()) {
                return {};
            }
        }
        found /= own;
        place = fs::canonical(place / own, error);
        if (error) {
            return {};
        }
    }
    return found;
}

}  // namespace

std::string FolderNames::in_any_case(const fs::path& folder, const std::string& name) {
    const std::scoped_lock lock(mutex_);
    const auto [known, added] = folders_.try_emplace(folder);
    Entries& entries = known->second;
    if (added) {
        std::error_code error;
        for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
             entry.increment(error)) {
            const std::string own = entry->path().filename().string();
            const auto [alike, first] = entries.try_emplace(lower(own), own);
            if (!first) {
                alike->second.clear();
            }
        }
    }
    const auto found = entries.find(lower(name));
    return found == entries.end() ? std::string() : found->second;
}

UriFile find_uri_file(const fs::path& folder, std::string_view uri, bool allow_outside,
                      FolderNames& folder_names) {
    std::vector<std::string> names = readings(uri);
    UriFile result;
    if (names.front().find('\0') != std::string::npos) {
        result.problem = fmt::format("'{}' is no file's name", printable(names.front()));
        return result;
    }
    for (const std::string& name : names) {
        const fs::path path = folder / name;
        if (!allow_outside && !stands_in(folder, path)) {
            result.problem = fmt::format(
                "'{}' leads out of the file's folder, where nothing is read (--allow-outside reads it)",
                printable(name));
            continue;
        }
        std::error_code ignored;
        if (fs::exists(path, ignored)) {
            return {path,
                    name == names.front() ? "" : fmt::format("is taken for the file '{}'", printable(name)),
                    ""};
        }
    }
    std::erase_if(
        names, [&](const std::string& name) { return !allow_outside && !stands_in(folder, folder / name); });
    for (const std::string& name : names) {
        const fs::path found = in_any_case(folder, name, allow_outside, folder_names);
        if (!found.empty() && (allow_outside || stands_in(folder, folder / found))) {
            return {folder / found, fmt::format("is taken for the file '{}'", printable(found.string())), ""};
        }
    }
    if (result.problem.empty()) {
        result.path = folder / names.front();
    }
    return result;
}

}  // namespace lanthorn
