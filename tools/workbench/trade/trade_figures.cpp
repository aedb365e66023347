// Figures as JSON: what a finished point leaves behind.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/workbench/trade_point.h"
#include "tools/workbench/scene/median.h"

namespace lanthorn::workbench {

namespace {

using nlohmann::ordered_json;

constexpr std::pair<const char*, Spread TradeFigures::*> kSpreads[] = {
    {"gi_ms", &TradeFigures::gi},
    {"gi_cpu_ms", &TradeFigures::gi_cpu},
    {"frame_ms", &TradeFigures::frame},
    {"direct_ms", &TradeFigures::direct},
    {"gi_over_direct", &TradeFigures::ratio},
    {"gi_over_direct_cpu", &TradeFigures::ratio_cpu}};

constexpr std::pair<const char*, double TradeFigures::*> kNumbers[] = {
    {"cost_ms", &TradeFigures::cost_ms},
    {"relrmse", &TradeFigures::relrmse},
    {"flux", &TradeFigures::flux},
    {"relrmse_all", &TradeFigures::relrmse_all},
    {"flux_all", &TradeFigures::flux_all},
    {"flip", &TradeFigures::flip},
    {"reference_noise", &TradeFigures::reference_noise},
    {"photons_stored", &TradeFigures::photons_stored},
    {"photons_lost", &TradeFigures::photons_lost},
    {"gpu_mb", &TradeFigures::gpu_mb},
    {"rss_mb", &TradeFigures::rss_mb},
    {"nan_count", &TradeFigures::nan_count}};

}  // namespace

std::string figures_json(const TradeFigures& figures) {
    ordered_json root;
    for (const auto& [name, member] : kSpreads) {
        const Spread& s = figures.*member;
        root[name] = {{"median", s.median}, {"p95", s.p95}, {"min", s.min}};
    }
    for (const auto& [name, member] : kNumbers) {
        root[name] = figures.*member;
    }
    root["renderer"] = figures.renderer;
    return root.dump(2) + '\n';
}

TradeFigures figures_from_json(const std::string& json, const std::string& source) {
    TradeFigures figures;
    try {
        const ordered_json root = parse_ordered_json(json, source);
        for (const auto& [name, member] : kSpreads) {
            const ordered_json& s = root.at(name);
            figures.*member = {s.at("median"), s.at("p95"), s.at("min")};
        }
        for (const auto& [name, member] : kNumbers) {
            figures.*member = root.at(name);
        }
        figures.relrmse_least = figures.relrmse_most = figures.relrmse;
        figures.renderer = root.at("renderer");
    } catch (const ordered_json::exception& error) {
        throw InputError(source, "", fmt::format("is no finished point: {}", error.what()));
    }
    return figures;
}

TradeResult over_seeds(const std::vector<TradeResult>& of_seeds) {
    TradeResult result = of_seeds.front();
    for (const TradeResult& one : of_seeds) {
        if (!one.measured()) {
            result.lost = one.lost;
            return result;
        }
    }
    const auto all = [&](const auto& value) {
        std::vector<double> values;
        values.reserve(of_seeds.size());
        for (const TradeResult& one : of_seeds) {
            values.push_back(value(one.figures));
        }
        return values;
    };
    TradeFigures& f = result.figures;
    for (const auto& [name, member] : kSpreads) {
        for (double Spread::*part : {&Spread::median, &Spread::p95, &Spread::min}) {
            f.*member.*part =
                median(all([m = member, part](const TradeFigures& one) { return one.*m.*part; }));
        }
    }
    for (const auto& [name, member] : kNumbers) {
        f.*member = median(all([m = member](const TradeFigures& one) { return one.*m; }));
    }
    const std::vector<double> errors = all([](const TradeFigures& one) { return one.relrmse; });
    f.seeds = static_cast<double>(errors.size());
    f.relrmse_least = std::ranges::min(errors);
    f.relrmse_most = std::ranges::max(errors);
    return result;
}

}  // namespace lanthorn::workbench
