#include "tools/lanthorn/trade/advice_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "lanthorn/core/printable.h"
#include "tools/lanthorn/common/text_table.h"
#include "tools/lanthorn/trade/trade_report.h"

namespace lanthorn::tools {

namespace {

using nlohmann::ordered_json;

struct Wish {
    Budget budget;
    double limit;
};

std::vector<Wish> all_of(const Wishes& wishes) {
    std::vector<Wish> list;
    for (const double ms : wishes.ms) {
        list.push_back({Budget::ms, ms});
    }
    for (const double error : wishes.errors) {
        list.push_back({Budget::error, error});
    }
    return list;
}

std::string words(const Wish& wish) {
    return wish.budget == Budget::ms ? fmt::format("{:g} ms", wish.limit)
                                     : fmt::format("error {:g}", wish.limit);
}

std::string nothing_fits(const Wish& wish, const Advice& advice) {
    return wish.budget == Budget::ms ? fmt::format("nothing: the cheapest takes {:.3g} ms", advice.least)
                                     : fmt::format("nothing: the least error is {:.2g}", advice.least);
}

std::string memory(const WayFigures& f) {
    std::string text = f.gpu_mb > 0 ? fmt::format("{:.0f} MB", f.gpu_mb) : "-";
    return f.rss_mb > 0 ? text + fmt::format(", process {:.0f} MB", f.rss_mb) : text;
}

// What stands behind the wish, a cell a column.
std::vector<std::string> cells(const WayFigures& f, const std::string& options) {
    return {options,
            fmt::format("{:.2f}", f.error),
            fmt::format("{:.2f} ({})", f.most_error, f.worst),
            fmt::format("{:.3g} ms", f.ms),
            fmt::format("{:.3g} ms ({})", f.most_ms, f.slowest),
            memory(f)};
}

const std::vector<std::string> kHeading = {"for",   "set",           "error to expect", "worst scene",
                                           "takes", "slowest scene", "GPU memory"};

}  // namespace

std::string reading(const Wishes& wishes) {
    const std::string scenes = wishes.share == 1
                                   ? std::string("every scene")
                                   : fmt::format("at least {:.3g} % of the scenes", 100 * wishes.share);
    return fmt::format(
        "Of all that keeps within the limit in {}, each row names what has the least {}. The error is "
        "relRMSE of "
        "the indirect light, 0.1 being a tenth of its mean; it and the time are geometric means over the "
        "scenes.",
        scenes,
        wishes.errors.empty() ? "error"
        : wishes.ms.empty()   ? "time"
                              : "of the other");
}

std::string advice_text(const std::vector<ChartRow>& rows, const Wishes& wishes, bool by_scene) {
    TextTable table(kHeading);
    for (const Wish& wish : all_of(wishes)) {
        const Advice advice = advise(rows, wish.budget, wish.limit, wishes.share);
        std::vector<std::string> row = {words(wish)};
        const auto found = advice.best ? cells(*advice.best, advice.best->way.options())
                                       : std::vector<std::string>{nothing_fits(wish, advice)};
        row.insert(row.end(), found.begin(), found.end());
        table.add(std::move(row));
    }
    std::string text = table.text() + reading(wishes) + '\n';
    if (!by_scene) {
        return text;
    }
    for (const Wish& wish : all_of(wishes)) {
        TextTable scenes({words(wish) + ", each scene by itself", "set", "error", "takes", "GPU memory"});
        for (const std::string& scene : scenes_of(rows)) {
            const Advice advice = advise(of_scenes(rows, {scene}), wish.budget, wish.limit);
            if (advice.best) {
                scenes.add({scene, advice.best->way.options(), fmt::format("{:.2f}", advice.best->error),
                            fmt::format("{:.3g} ms", advice.best->ms), memory(*advice.best)});
            } else {
                scenes.add({scene, nothing_fits(wish, advice)});
            }
        }
        text += '\n' + scenes.text();
    }
    return text;
}

std::string advice_markdown(const std::vector<ChartRow>& rows, const Wishes& wishes) {
    std::string text = "|";
    for (const std::string& name : kHeading) {
        text += ' ' + name + " |";
    }
    text += "\n|---|---|---|---|---|---|---|\n";
    for (const Wish& wish : all_of(wishes)) {
        const Advice advice = advise(rows, wish.budget, wish.limit, wishes.share);
        if (!advice.best) {
            text += fmt::format("| {} | {} | | | | | |\n", words(wish), nothing_fits(wish, advice));
            continue;
        }
        text += fmt::format("| {} |", words(wish));
        for (const std::string& cell : cells(*advice.best, '`' + advice.best->way.options() + '`')) {
            text += ' ' + cell + " |";
        }
        text += '\n';
    }
    return text + '\n' + reading(wishes) + '\n';
}

std::string advice_html(const std::vector<ChartRow>& rows, const Wishes& wishes) {
    std::string html = "<table><tr>";
    for (const std::string& name : kHeading) {
        html += "<td class=\"text\"><b>" + name + "</b></td>";
    }
    html += "</tr>\n";
    for (const Wish& wish : all_of(wishes)) {
        const Advice advice = advise(rows, wish.budget, wish.limit, wishes.share);
        html += "<tr><td class=\"text\">" + words(wish) + "</td>";
        const auto found = advice.best ? cells(*advice.best, advice.best->way.options())
                                       : std::vector<std::string>{nothing_fits(wish, advice)};
        for (const std::string& cell : found) {
            html += "<td class=\"text\">" + markup_text(cell) + "</td>";
        }
        html += "</tr>\n";
    }
    return html + "</table>\n";
}

ordered_json advice_json(const std::vector<ChartRow>& rows, const Wishes& wishes) {
    const auto figures = [](const WayFigures& f) {
        return ordered_json{{"technique", f.way.technique},
                            {"preset", f.way.preset},
                            {"settings", f.way.settings},
                            {"ms", f.ms},
                            {"error", f.error},
                            {"most_ms", f.most_ms},
                            {"slowest_scene", f.slowest},
                            {"most_error", f.most_error},
                            {"worst_scene", f.worst},
                            {"gpu_mb", f.gpu_mb},
                            {"rss_mb", f.rss_mb}};
    };
    ordered_json list = ordered_json::array();
    for (const Wish& wish : all_of(wishes)) {
        const Advice advice = advise(rows, wish.budget, wish.limit, wishes.share);
        list.push_back({{"for", wish.budget == Budget::ms ? "ms" : "error"},
                        {"limit", wish.limit},
                        {"best", advice.best ? figures(*advice.best) : ordered_json(nullptr)},
                        {"least", advice.least},
                        {"least_by", figures(advice.nearest)}});
    }
    return {{"scenes", scenes_of(rows)}, {"share", wishes.share}, {"wishes", std::move(list)}};
}

std::string unmet(const std::vector<ChartRow>& rows, const Wishes& wishes) {
    std::string text;
    for (const Wish& wish : all_of(wishes)) {
        const Advice advice = advise(rows, wish.budget, wish.limit, wishes.share);
        if (!advice.best) {
            text += fmt::format("{}{}: {}, by {}", text.empty() ? "" : "; ", words(wish),
                                nothing_fits(wish, advice), advice.nearest.way.options());
        }
    }
    return text;
}

}  // namespace lanthorn::tools
