#include "tools/lanthorn/measure/measure_report.h"

#include <fmt/format.h>

#include <cmath>

#include "tools/lanthorn/common/text_table.h"

namespace lanthorn::tools {

namespace {

using nlohmann::ordered_json;

ordered_json colours(const dvec3& v) {
    return {v.r, v.g, v.b};
}

std::string percent(double share) {
    return fmt::format("{:.2f} %", 100 * share);
}

ordered_json json_of(const HitCounts& c) {
    return {{"segments", c.segments},
            {"agreement", c.share(c.agree)},
            {"near", c.share(c.near)},
            {"far", c.share(c.far)},
            {"missed", c.share(c.missed)},
            {"invented", c.share(c.invented)},
            {"left", c.left},
            {"before", c.before},
            {"behind", c.behind}};
}

std::string bounce_table(const std::vector<HitCounts>& bounces, const HitCounts& all) {
    TextTable table({"bounce", "segments", "agreement", "near", "far", "missed", "invented", "left"});
    const auto add = [&](const std::string& name, const HitCounts& c) {
        table.add({name, fmt::format("{}", c.segments), percent(c.share(c.agree)), percent(c.share(c.near)),
                   percent(c.share(c.far)), percent(c.share(c.missed)), percent(c.share(c.invented)),
                   fmt::format("{}", c.left)});
    };
    for (std::size_t b = 0; b < bounces.size(); ++b) {
        add(fmt::format("{}", b + 1), bounces[b]);
    }
    add("all", all);
    return table.text();
}

std::string histogram_table(const HitCounts& all) {
    TextTable table({"off by, of the diagonal", "too near", "too far"});
    double from = 0;
    for (std::size_t i = 0; i < all.before.size(); ++i) {
        const bool last = i == kHitBins.size();
        table.add({last ? fmt::format("above {:g} %", 100 * from)
                        : fmt::format("{:g} to {:g} %", 100 * from, 100 * kHitBins[i]),
                   percent(all.share(all.before[i])), percent(all.share(all.behind[i]))});
        from = last ? from : kHitBins[i];
    }
    table.add({"missed: by exact ray alone", percent(all.share(all.missed)), ""});
    table.add({"invented: by image alone", percent(all.share(all.invented)), ""});
    return table.text();
}

ordered_json json_of(const EnergyStep& s) {
    return {{"incoming", colours(s.incoming)},
            {"stored", colours(s.stored)},
            {"lost", colours(s.lost)},
            {"absorbed", colours(s.absorbed)},
            {"reflected", colours(s.reflected)}};
}

}  // namespace

ordered_json json_number(double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

MeasureReport report(const std::vector<HitCounts>& bounces) {
    HitCounts all;
    ordered_json by_bounce = ordered_json::array();
    for (const HitCounts& counts : bounces) {
        all += counts;
        by_bounce.push_back(json_of(counts));
    }
    MeasureReport result{bounce_table(bounces, all) + '\n' + histogram_table(all), json_of(all)};
    result.figures["tolerance"] = kHitTolerance;
    result.figures["bins"] = kHitBins;
    result.figures["bounces"] = std::move(by_bounce);
    return result;
}

MeasureReport report(const CoverageFigures& f) {
    TextTable table({"coverage", "standard error", "by eq. 1", "reached m2", "of m2", "points"});
    table.add({percent(f.coverage), percent(f.standard_error), percent(f.by_eq1),
               fmt::format("{:.4g}", f.reached_area), fmt::format("{:.4g}", f.area),
               fmt::format("{} of {}", f.reached, f.points)});
    TextTable random({fmt::format("{} at random of the candidates", f.seen_by_map.size()), "coverage"});
    random.add({fmt::format("mean of {} draws", kRandomDraws), percent(f.random.mean)});
    random.add({"their standard deviation", percent(f.random.deviation)});
    random.add({"least, most", percent(f.random.least) + ", " + percent(f.random.most)});
    TextTable maps({"map", "sees", "alone"});
    ordered_json by_map = ordered_json::array();
    for (std::size_t m = 0; m < f.seen_by_map.size(); ++m) {
        maps.add({fmt::format("{}", m), percent(f.seen_by_map[m]), percent(f.alone_by_map[m])});
        by_map.push_back({{"sees", f.seen_by_map[m]}, {"alone", f.alone_by_map[m]}});
    }
    return {table.text() + '\n' + random.text() + '\n' + maps.text(),
            {{"coverage", f.coverage},
             {"standard_error", f.standard_error},
             {"coverage_by_eq1", f.by_eq1},
             {"area_m2", f.area},
             {"reached_m2", f.reached_area},
             {"points", f.points},
             {"points_reached", f.reached},
             {"random",
              {{"draws", kRandomDraws},
               {"mean", f.random.mean},
               {"deviation", f.random.deviation},
               {"least", f.random.least},
               {"most", f.random.most}}},
             {"maps", std::move(by_map)}}};
}

MeasureReport report(const EnergyBalance& balance) {
    const EnergyStep& first = balance.first;
    const double emitted = luminous(first.incoming);
    const auto share = [&](const dvec3& flux) { return percent(luminous(flux) / emitted); };
    TextTable table(
        {"step", "comes in", "stored", "lost", "of it truly", "absorbed", "reflected", "stored/exact"});
    table.add({"first surface", share(first.incoming), share(first.stored), share(first.lost), "-",
               share(first.absorbed), share(first.reflected), "-"});
    ordered_json bounces = ordered_json::array();
    for (std::size_t b = 0; b < balance.bounces.size(); ++b) {
        const EnergyStep& s = balance.bounces[b];
        table.add({fmt::format("bounce {}", b + 1), share(s.incoming), share(s.stored), share(s.lost),
                   share(s.lost_true), share(s.absorbed), share(s.reflected),
                   fmt::format("{:.4f}", luminous(s.stored) / luminous(s.stored_exact))});
        ordered_json step = json_of(s);
        step["lost_true"] = colours(s.lost_true);
        step["stored_exact"] = colours(s.stored_exact);
        bounces.push_back(std::move(step));
    }
    return {fmt::format("emitted {:.4g} lm; shares of it, by luminance:\n", emitted) + table.text(),
            {{"unit", "lm"},
             {"emitted", colours(first.incoming)},
             {"first_surface", json_of(first)},
             {"bounces", std::move(bounces)}}};
}

MeasureReport report(const FlickerFigures& f) {
    const auto of_mean = [&](double change) {
        return std::isnan(change) ? std::string("lost in noise")
                                  : fmt::format("{:.3f} %", 100 * change / f.reference_mean);
    };
    TextTable table({"flicker", "change", "reference's", "standard error", "of a mean of"});
    table.add({std::isnan(f.ratio) ? "unknown (more --spp)" : fmt::format("{:.3f}", f.ratio),
               of_mean(f.change), of_mean(f.reference_change), of_mean(f.reference_error),
               fmt::format("{:.4g} lx", f.reference_mean)});
    return {table.text(),
            {{"flicker", json_number(f.ratio)},
             {"change", f.change},
             {"reference_change", json_number(f.reference_change)},
             {"reference_error", json_number(f.reference_error)},
             {"reference_mean", f.reference_mean},
             {"by_frame", f.by_frame}}};
}

MeasureReport report(const Effects& effects) {
    TextTable table({"effect", "of the picture", "mean", "reference's", "unit", "ratio"});
    ordered_json rows = ordered_json::array();
    for (const Effect& e : effects.parts) {
        table.add({e.name, percent(e.share), fmt::format("{:.4g}", e.technique),
                   fmt::format("{:.4g}", e.reference), e.unit, fmt::format("{:.3f}", e.ratio())});
        rows.push_back({{"effect", e.name},
                        {"share", e.share},
                        {"mean", e.technique},
                        {"reference", e.reference},
                        {"unit", e.unit},
                        {"ratio", json_number(e.ratio())}});
    }
    std::string text = table.text();
    ordered_json peak;
    if (effects.peak) {
        text +=
            fmt::format("brightest place of caustics: {} of the diagonal off; the reference's halves {}\n",
                        percent(effects.peak->off), percent(effects.peak->halves));
        peak = {{"off", effects.peak->off}, {"halves", effects.peak->halves}};
    }
    return {std::move(text), {{"effects", std::move(rows)}, {"caustic_peak", std::move(peak)}}};
}

}  // namespace lanthorn::tools
