// The same room elsewhere, larger, smaller, brighter, darker: nothing else may change.
#include <fmt/format.h>

#include <cmath>

#include "tests/extremes/row.h"
#include "tests/extremes/scenes.h"

namespace lanthorn::extremes {

namespace {

Row like_ordinary(std::string name) {
    Row row;
    row.name = std::move(name);
    row.stage = room;
    row.right = Right::ordinary;
    return row;
}

Stage lit_by(float factor) {
    Stage stage = room();
    stage.lights[0].light.intensity *= factor;
    return stage;
}

}  // namespace

std::vector<Row> rows_of_placement() {
    std::vector<Row> rows{like_ordinary("ordinary room")};
    rows.back().unlike = 0;
    for (const double scale : {1e-4, 1e5}) {
        rows.push_back(like_ordinary(fmt::format("scaled by {:.0e}", scale)));
        rows.back().placement.scale = scale;
        rows.back().unlike = 0.03;  // rounding sends a photon in a hundred to another texel
    }
    for (const int exponent :
         {-13, 17}) {  // floating point scales exactly: whatever differs is an absolute length
        rows.push_back(like_ordinary(fmt::format("scaled by 2^{}", exponent)));
        rows.back().placement.scale = std::ldexp(1.0, exponent);
        rows.back().unlike = 1e-6;
    }
    for (const double metres : {1e2, 1e4, 1e6}) {
        rows.push_back(like_ordinary(fmt::format("moved by {:.0e} m", metres)));
        rows.back().placement.offset = metres * dvec3(1, -0.5, -1);
        rows.back().unlike = 1e-6;
    }
    rows.push_back(like_ordinary("moved by 300 m, same origin"));
    rows.back().placement.walk = dvec3(200, 100, -200);
    rows.back().unlike = 0.03;
    for (const float factor : {1e-6f, 1e9f}) {
        rows.push_back(like_ordinary(fmt::format("light x {:.0e}", factor)));
        rows.back().stage = [factor] { return lit_by(factor); };
        rows.back().gain = static_cast<double>(factor);
        rows.back().unlike = 1e-5;
    }
    return rows;
}

}  // namespace lanthorn::extremes
