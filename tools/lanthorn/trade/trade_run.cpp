#include "tools/lanthorn/trade/trade_run.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <optional>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"

namespace lanthorn::tools {

namespace fs = std::filesystem;

namespace {

std::optional<std::string> bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return std::nullopt;
    }
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

fs::path with_ending(const fs::path& stem, const char* ending) {
    return stem.string() + ending;
}

// What a finished point left behind; a damaged one counts as not done.
bool load(const fs::path& stem, TradeResult& result) {
    const fs::path file = with_ending(stem, ".json");
    const auto figures = bytes_of(file), picture = bytes_of(with_ending(stem, ".png"));
    if (!figures || !picture) {
        return false;
    }
    try {
        result.figures = figures_from_json(*figures, file.string());
    } catch (const InputError&) {
        return false;
    }
    result.picture = *picture;
    return true;
}

// Throws InputError if a file of a point's size cannot be written beside `stem`: a full disk, say.
void check_room(const fs::path& stem) {
    AtomicFile(with_ending(stem, ".probe")).write(std::string(std::size_t{1} << 18, '0'));
}

}  // namespace

bool is_finished(const fs::path& stem) {
    TradeResult ignored;
    return load(stem, ignored);
}

TradeRun run_points(const std::vector<TradePoint>& points, const std::vector<fs::path>& stems,
                    const PointRunner& runner, const std::function<void(std::size_t)>& progressed,
                    const std::function<bool()>& stop) {
    TradeRun run;
    for (std::size_t i = 0; i < points.size(); ++i) {
        TradeResult result;
        result.point = points[i];
        if (load(stems[i], result)) {
            ++run.kept;
        } else {
            if (stop()) {
                run.interrupted = true;
                break;
            }
            const ChildOutcome outcome = runner(points[i], stems[i]);
            if (stop() && !outcome.ok()) {
                run.interrupted = true;
                break;
            }
            if (outcome.code == static_cast<int>(ExitCode::no_gl)) {
                throw Error(ExitCode::no_gl, outcome.last_line);
            }
            if (!outcome.ok() || !load(stems[i], result)) {
                check_room(stems[i]);
                result.lost = outcome.ok() ? "left no figures" : outcome.why();
                ++run.lost;
            }
        }
        run.results.push_back(std::move(result));
        progressed(i + 1);
    }
    return run;
}

}  // namespace lanthorn::tools
