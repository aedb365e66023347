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
    if (result.problem.empty()) {
        result.path = folder / names.front();
    }
    return result;
}

}  // namespace lanthorn
