#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/core/base64.h"
#include "lanthorn/core/printable.h"
#include "tools/lanthorn/trade/advice_report.h"
#include "tools/lanthorn/trade/trade_report.h"

namespace lanthorn::tools {

namespace {

struct Column {
    const char* title;
    const char* about;
    double (*value)(const TradeFigures&);
};
constexpr Column kColumns[] = {
    {"cost ms",
     "what the chart shows: processor time on a software rasteriser, else GL timer queries; median",
     [](const TradeFigures& f) { return f.cost_ms; }},
    {"GI ms", "wall clock of the indirect light, median", [](const TradeFigures& f) { return f.gi.median; }},
    {"p95", "95th percentile of it", [](const TradeFigures& f) { return f.gi.p95; }},
    {"GI / direct", "indirect over direct part of the same frames, processor time, median",
     [](const TradeFigures& f) { return f.ratio_cpu.median; }},
    {"relRMSE", "against the same number of bounces", [](const TradeFigures& f) { return f.relrmse; }},
    {"flux", "mean over the reference's, same bounces", [](const TradeFigures& f) { return f.flux; }},
    {"relRMSE all", "against all bounces", [](const TradeFigures& f) { return f.relrmse_all; }},
    {"flux all", "against all bounces", [](const TradeFigures& f) { return f.flux_all; }},
    {"FLIP", "of the final picture, all bounces", [](const TradeFigures& f) { return f.flip; }},
    {"GPU MB", "buffers and textures of the renderer", [](const TradeFigures& f) { return f.gpu_mb; }},
    {"process MB", "the most that the process had in memory", [](const TradeFigures& f) { return f.rss_mb; }},
    {"seeds", "over so many seeds each figure is the median", [](const TradeFigures& f) { return f.seeds; }},
    {"least", "relRMSE of the best seed", [](const TradeFigures& f) { return f.relrmse_least; }},
    {"most", "relRMSE of the worst seed", [](const TradeFigures& f) { return f.relrmse_most; }}};

constexpr const char* kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Error against time</title>
<style>
body{font:14px/1.45 sans-serif;color:#222;margin:24px auto;max-width:1180px;padding:0 16px}
h1{font-size:22px}h2{font-size:17px;margin-top:28px}
[hidden]{display:none}
.scene svg{max-width:100%;height:auto}
#card{position:fixed;right:16px;top:16px;width:320px;background:#fff;border:1px solid #bbb;padding:10px;box-shadow:0 2px 10px #0003;display:none}
#card img{width:100%;image-rendering:auto;display:block;margin-top:6px}
table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:13px}
th,td{padding:2px 9px;text-align:right;border-bottom:1px solid #eee}
th{cursor:pointer;position:sticky;top:0;background:#f4f4f4}
td.text,th.text{text-align:left}
tr.front td{background:#eef6ee}tr.lost td{color:#a33}tr:hover td,tr.lit td{background:#fdf3d8}
.lit circle,.lit path{stroke:#d00;stroke-width:2}
</style></head><body>
<h1>Error against time</h1>
)";

constexpr const char* kScript = R"(
const card=document.getElementById('card'),measure=document.getElementById('measure'),axis=document.getElementById('axis');
function light(i,on){
  document.querySelectorAll('[data-i="'+i+'"]').forEach(e=>e.classList.toggle('lit',on));
  card.style.display=on?'block':'none';
  if(!on)return;
  const p=points[i];
  card.querySelector('b').textContent=p.label;
  card.querySelector('span').textContent=p.text;
  const img=card.querySelector('img');
  img.style.display=p.picture?'block':'none';
  if(p.picture)img.src='data:image/png;base64,'+p.picture;
}
document.querySelectorAll('[data-i]').forEach(e=>{
  e.addEventListener('mouseenter',()=>light(e.dataset.i,true));
  e.addEventListener('mouseleave',()=>light(e.dataset.i,false));
});
function show(){document.querySelectorAll('[data-measure]').forEach(e=>
  e.hidden=e.dataset.measure!==measure.value||e.dataset.axis!==axis.value);}
measure.addEventListener('change',show);axis.addEventListener('change',show);show();
document.querySelectorAll('th').forEach((th,column)=>{
  let up=false;
  th.addEventListener('click',()=>{
    up=!up;
    const body=document.querySelector('tbody'),rows=[...body.rows];
    const key=r=>{const t=r.cells[column].textContent,n=parseFloat(t);return isNaN(n)?t:n;};
    rows.sort((a,b)=>{const x=key(a),y=key(b);
      const d=typeof x===typeof y?(x<y?-1:x>y?1:0):typeof x==='number'?-1:1;return up?d:-d;});
    body.append(...rows);
  });
});
)";

std::string charts(const std::vector<TradeResult>& results) {
    std::string html = "<p>Error: <select id=\"measure\">";
    for (std::size_t m = 0; m < trade_measures().size(); ++m) {
        html += fmt::format("<option value=\"{}\">{}, {}</option>", m, trade_measures()[m].name,
                            trade_measures()[m].about);
    }
    html += "</select> against: <select id=\"axis\">";
    for (std::size_t a = 0; a < trade_axes().size(); ++a) {
        html += fmt::format("<option value=\"{}\">{}</option>", a, trade_axes()[a].about);
    }
    html += "</select></p>\n";
    for (const std::string& scene : scenes_of(results)) {
        for (std::size_t m = 0; m < trade_measures().size(); ++m) {
            for (std::size_t a = 0; a < trade_axes().size(); ++a) {
                html += fmt::format("<div class=\"scene\" data-measure=\"{}\" data-axis=\"{}\"{}>{}</div>\n",
                                    m, a, m == 0 && a == 0 ? "" : " hidden",
                                    trade_chart(results, scene, trade_measures()[m], trade_axes()[a]));
            }
        }
    }
    return html;
}

std::string table(const std::vector<TradeResult>& results) {
    std::string html =
        "<table><thead><tr><th class=\"text\">scene</th><th class=\"text\">point</th><th>front</th>";
    for (const Column& column : kColumns) {
        html += fmt::format("<th title=\"{}\">{}</th>", column.about, column.title);
    }
    html += "</tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < results.size(); ++i) {
        const TradeResult& r = results[i];
        html += fmt::format(
            "<tr data-i=\"{}\" class=\"{}\"><td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}</td>",
            i,
            !r.measured() ? "lost"
            : r.on_front  ? "front"
                          : "",
            markup_text(r.point.scene_name()), markup_text(r.point.label()), r.on_front ? "1" : "");
        if (r.measured()) {
            for (const Column& column : kColumns) {
                html += fmt::format("<td>{:.3g}</td>", column.value(r.figures));
            }
        } else {
            html += fmt::format("<td class=\"text\" colspan=\"{}\">lost: {}</td>", std::size(kColumns),
                                markup_text(r.lost));
        }
        html += "</tr>\n";
    }
    return html + "</tbody></table>\n";
}

// What to set for a few budgets, by these points.
std::string advice(const std::vector<TradeResult>& results) {
    const std::vector<ChartRow> rows = chart_rows(results);
    if (!has_common_way(rows)) {
        return {};
    }
    Wishes wishes;
    wishes.ms = kPageBudgets;
    wishes.share = kPageShare;
    return "<h2>What to set</h2>\n" + advice_html(rows, wishes) + "<p>" + reading(wishes) + "</p>\n";
}

// The points as a script's constant; `</` would end the script.
std::string data(const std::vector<TradeResult>& results) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const TradeResult& r : results) {
        const TradeFigures& f = r.figures;
        list.push_back(
            {{"label", r.point.scene_name() + ": " + r.point.label()},
             {"text", r.measured() ? fmt::format("{:.3g} ms, relRMSE {:.3g}, flux {:.3g}, FLIP {:.3g}",
                                                 f.cost_ms, f.relrmse, f.flux, f.flip)
                                   : "lost: " + r.lost},
             {"picture", base64(r.picture)}});
    }
    std::string text = list.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    for (std::size_t i = 0; (i = text.find("</", i)) != std::string::npos; i += 3) {
        text.insert(i + 1, 1, '\\');
    }
    return text;
}

}  // namespace

std::string trade_html(const std::vector<TradeResult>& results, const TradeContext& context) {
    return kHead +
           fmt::format("<p>{}<br>{}<br>{}; {}<br>{}</p>\n", markup_text(context.method),
                       markup_text(context.reference), markup_text(context.machine),
                       markup_text(context.renderer), markup_text(context.build)) +
           advice(results) + charts(results) +
           "<p>Green rows are on the front of relRMSE. A click on a heading sorts. The card shows the "
           "picture and, "
           "beside it, the relative error of the indirect light: black none, white the mean or more.</p>\n" +
           table(results) +
           "<div id=\"card\"><b></b><br><span></span><img alt=\"\"></div>\n<script>\nconst points=" +
           data(results) + ";" + kScript + "</script>\n</body></html>\n";
}

}  // namespace lanthorn::tools
