#include "tools/lanthorn/replay/pictures/baseline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "engine/core/json.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "tools/replay_suite/files.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kMostPixels = 16384;  // a side
constexpr int kMostFrames = 10'000;

fs::path json_of(fs::path file) {
    return file.replace_extension(".json");
}

// Members of a baseline's file, each of its kind or a line that says what was expected.
class Members {
  public:
    Members(const json& from, std::string file) : from_(from), file_(std::move(file)) {}

    const json& of(const char* name, const char* what, bool (json::*is)() const noexcept) const {
        if (!from_.contains(name) || !(from_[name].*is)()) {
            throw InputError(file_, name, fmt::format("expected {}", what));
        }
        return from_[name];
    }
    std::string text(const char* name) const {
        return of(name, "a text", &json::is_string).get<std::string>();
    }
    int number(const char* name, int least, int most) const {
        const json& value = of(name, "a whole number", &json::is_number_integer);
        const auto n = value.get<std::int64_t>();
        if (n < least || n > most) {
            throw InputError(file_, name, fmt::format("found {}, expected {} to {}", n, least, most));
        }
        return static_cast<int>(n);
    }
    std::vector<double> numbers(const char* name) const {
        return numbers_in(of(name, "a list", &json::is_array), name);
    }
    std::vector<double> numbers_in(const json& list, const char* name) const {
        std::vector<double> result;
        for (const json& value : list) {
            if (!value.is_number()) {
                throw InputError(file_, name, "expected a list of numbers");
            }
            result.push_back(value.get<double>());
        }
        return result;
    }

  private:
    const json& from_;
    std::string file_;
};

Baseline baseline_of(const json& from, const std::string& file) {
    const Members members(from, file);
    Baseline b;
    b.view.size = {members.number("width", 1, kMostPixels), members.number("height", 1, kMostPixels)};
    b.view.frames = members.number("frames", 1, kMostFrames);
    b.view.seed = members.number("seed", 0, 1'000'000'000);
    b.view.preset = members.text("preset");
    for (const json& seed : members.of("seeds", "a list", &json::is_array)) {
        const Members of_seed(seed, file);
        if (!seed.is_object()) {
            throw InputError(file, "seeds", "expected a list of objects");
        }
        PictureFigures& figures = b.figures.emplace_back();
        figures.columns = (b.view.size.x + kTilePixels - 1) / kTilePixels;
        figures.light = of_seed.numbers("light");
        figures.detail = of_seed.numbers("detail");
    }
    b.direct = members.numbers("direct");
    for (const json& error : members.of("light_errors", "a list", &json::is_array)) {
        const std::vector<double> pair =
            error.is_array() ? members.numbers_in(error, "light_errors") : std::vector<double>();
        if (pair.size() != 2) {
            throw InputError(file, "light_errors", "expected pairs of relRMSE and flux");
        }
        b.errors.push_back({pair[0], pair[1]});
    }
    b.build = members.text("build");
    b.reason = members.text("reason");
    b.day = members.text("day");
    return b;
}

json json_of(const Baseline& b) {
    json errors = json::array(), seeds = json::array();
    for (const PictureFigures& one : b.figures) {
        seeds.push_back({{"light", one.light}, {"detail", one.detail}});
    }
    for (const LightError& error : b.errors) {
        errors.push_back({error.relrmse, error.flux});
    }
    return {{"width", b.view.size.x},
            {"height", b.view.size.y},
            {"frames", b.view.frames},
            {"seed", b.view.seed},
            {"preset", b.view.preset},
            {"seeds", seeds},
            {"direct", b.direct},
            {"light_errors", errors},
            {"build", b.build},
            {"reason", b.reason},
            {"day", b.day}};
}

}  // namespace

fs::path baseline_file(const fs::path& recording, const std::string& mark) {
    const bool is_plain = !mark.empty() && mark.front() != '.' && std::ranges::all_of(mark, [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.';
    });
    if (!is_plain) {
        throw InputError(
            recording.string(), "mark",
            fmt::format("found the name '{}', expected letters, digits, '-', '_' and '.'", mark));
    }
    return recording.parent_path() / "pictures" / recording.stem() / (mark + ".png");
}

std::optional<Baseline> read_baseline(const fs::path& recording, const std::string& mark) {
    const fs::path file = baseline_file(recording, mark), figures = json_of(file);
    std::error_code error;
    const bool has_picture = fs::exists(file, error), has_figures = fs::exists(figures, error);
    if (!has_picture && !has_figures) {
        return std::nullopt;
    }
    if (!has_picture || !has_figures) {
        throw InputError(
            (has_picture ? figures : file).string(), "",
            fmt::format("not there, expected beside {}", (has_picture ? file : figures).filename().string()));
    }
    Baseline b =
        baseline_of(parse_json_object(suite::read_if_there(figures), figures.string(), "a picture's figures"),
                    figures.string());
    b.shown = read_image(file);
    if (b.shown.width != b.view.size.x || b.shown.height != b.view.size.y || b.shown.channels < 3) {
        throw InputError(file.string(), "",
                         fmt::format("found {}x{} pixels of {} channels, expected {}x{} of 3", b.shown.width,
                                     b.shown.height, b.shown.channels, b.view.size.x, b.view.size.y));
    }
    return b;
}

void write_baseline(const fs::path& recording, const std::string& mark, const Baseline& baseline) {
    const fs::path file = baseline_file(recording, mark);
    suite::make_folder(file.parent_path());
    write_image(file, baseline.shown);
    write_file(json_of(file), json_of(baseline).dump(1) + "\n");
}

}  // namespace lanthorn::tools
