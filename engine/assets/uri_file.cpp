#include "lanthorn/assets/uri_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "lanthorn/assets/uri.h"
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

bool stands_in(const fs::path& folder, const fs::path& path) {
    std::error_code error;
    const fs::path home = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
    const fs::path place = error ? fs::path() : fs::weakly_canonical(path, error);
    if (error) {
        return false;
    }
    const auto [end, rest] = std::mismatch(home.begin(), home.end(), place.begin(), place.end());
    return end == home.end() && rest != place.end();
}

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool same_but_for_case(const std::string& a, const std::string& b) {
    return std::ranges::equal(a, b, {}, lower, lower);
}

// The only file of that name in any case, as on the systems that do not tell cases apart; empty if there is
// none, or more than one.
fs::path in_any_case(const fs::path& folder, const fs::path& name) {
    fs::path found = folder.empty() ? fs::path(".") : folder;
    for (const fs::path& part : name) {
        std::error_code error;
        if (part == "." || part == ".." || fs::exists(found / part, error)) {
            found /= part;
            continue;
        }
        std::vector<fs::path> alike;
        for (fs::directory_iterator entry(found, error), end; !error && entry != end;
             entry.increment(error)) {
            if (same_but_for_case(entry->path().filename().string(), part.string())) {
                alike.push_back(entry->path());
            }
        }
        if (alike.size() != 1) {
            return {};
        }
        found = alike.front();
    }
    return found;
}

}  // namespace

UriFile find_uri_file(const fs::path& folder, std::string_view uri, bool allow_outside) {
    const std::vector<std::string> names = readings(uri);
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
    for (const std::string& name : names) {
        const fs::path path = in_any_case(folder, name);
        if (!path.empty() && (allow_outside || stands_in(folder, path))) {
            return {path, fmt::format("is taken for the file '{}'", printable(path.filename().string())), ""};
        }
    }
    if (result.problem.empty()) {
        result.path = folder / names.front();
    }
    return result;
}

}  // namespace lanthorn
