// What `lanthorn trade` writes: a table, a drawing and a page.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/workbench/trade_point.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

// Where and how the figures came about.
struct TradeContext {
    std::string machine;    // processor and number of cores
    std::string renderer;   // GL_RENDERER
    std::string build;      // version, commit and type
    std::string method;     // size, frames
    std::string reference;  // what errors are relative to
};

// One of the errors that a chart can show.
struct TradeMeasure {
    const char* name;   // "relRMSE"
    const char* about;  // one line
    double TradeFigures::*error;
};
// The first is the one that the front and the drawing are made by.
const std::vector<TradeMeasure>& trade_measures();

// What a chart is drawn against.
struct TradeAxis {
    const char* name;   // "ms"
    const char* about;  // the axis's title
    double TradeFigures::*cost;
};
// The first is the one that the drawing is made against.
const std::vector<TradeAxis>& trade_axes();

// A line a point, lost ones included, numbers with six digits; RFC 4180.
std::string trade_csv(const std::vector<TradeResult>& results);

// A chart of one scene's points with logarithmic axes; marks are <g class="point" data-i="I"> with I the
// index into `results`.
std::string trade_chart(const std::vector<TradeResult>& results, const std::string& scene,
                        const TradeMeasure& measure, const TradeAxis& axis = trade_axes().front());

enum class TradeDrawing { time_and_memory, time };

// All scenes' charts, two a row, by the first measure, with the least and the largest error of several seeds:
// against time and, beside it, GPU memory; or against time alone.
std::string trade_svg(const std::vector<TradeResult>& results, const TradeContext& context,
                      TradeDrawing drawing = TradeDrawing::time_and_memory);

// One page that needs nothing else: charts with pictures on hover, and a table to sort.
std::string trade_html(const std::vector<TradeResult>& results, const TradeContext& context);

// In the order of their first point.
std::vector<std::string> scenes_of(const std::vector<TradeResult>& results);

}  // namespace lanthorn::tools
