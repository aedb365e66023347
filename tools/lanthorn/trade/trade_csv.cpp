#include <fmt/format.h>

#include <algorithm>

#include "tools/lanthorn/trade/trade_report.h"

namespace lanthorn::tools {

namespace {

std::string quoted(std::string text) {
    if (text.find_first_of(",\"\n") == std::string::npos) {
        return text;
    }
    for (std::size_t i = 0; (i = text.find('"', i)) != std::string::npos; i += 2) {
        text.insert(i, 1, '"');
    }
    return '"' + text + '"';
}

}  // namespace

std::string trade_csv(const std::vector<TradeResult>& results) {
    std::string csv =
        "scene,technique,preset,settings,front,cost_ms,gi_ms,gi_ms_p95,gi_cpu_ms,gi_cpu_ms_min,frame_ms,"
        "frame_ms_p95,direct_ms,gi_over_direct,gi_over_direct_cpu,relrmse,flux,relrmse_all,flux_all,flip,"
        "reference_noise,photons_stored,photons_lost,gpu_mb,nan_count,rss_mb,seeds,"
        "relrmse_least,relrmse_most,lost\n";
    for (const TradeResult& r : results) {
        const TradePoint& p = r.point;
        const TradeFigures& f = r.figures;
        csv += fmt::format("{},{},{},{},{}", quoted(p.scene_name()), p.technique, p.preset,
                           quoted(fmt::format("{}", fmt::join(p.assignments, " "))), r.on_front ? 1 : 0);
        const double numbers[] = {
            f.cost_ms,         f.gi.median,      f.gi.p95,        f.gi_cpu.median, f.gi_cpu.min,
            f.frame.median,    f.frame.p95,      f.direct.median, f.ratio.median,  f.ratio_cpu.median,
            f.relrmse,         f.flux,           f.relrmse_all,   f.flux_all,      f.flip,
            f.reference_noise, f.photons_stored, f.photons_lost,  f.gpu_mb,        f.nan_count,
            f.rss_mb,          f.seeds,          f.relrmse_least, f.relrmse_most};
        for (const double number : numbers) {
            csv += r.measured() ? fmt::format(",{:.6g}", number) : ",";
        }
        csv += ',' + quoted(r.lost) + '\n';
    }
    return csv;
}

}  // namespace lanthorn::tools
