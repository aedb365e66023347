// Figures as JSON: what a finished point leaves behind.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/workbench/trade_point.h"

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
        figures.renderer = root.at("renderer");
    } catch (const ordered_json::exception& error) {
        throw InputError(source, "", fmt::format("is no finished point: {}", error.what()));
    }
    return figures;
}

}  // namespace lanthorn::workbench
