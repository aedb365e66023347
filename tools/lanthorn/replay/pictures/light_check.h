// Whether indirect light has become better or worse against the path tracer since a baseline was made: with
// an interval, so that noise is not taken for a change, and a better picture is never red.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "tools/lanthorn/replay/pictures/baseline.h"

namespace lanthorn::tools {

// What is measured: small, since error is a mean over pixels, and references are dear.
inline constexpr ivec2 kLightSize{96, 54};
inline constexpr int kLightSpp = 256;
inline constexpr int kMostSeeds = 16;

// relRMSE^2 = mean((l - a)(l - b)) / mean^2 over pixels and channels, the pair's noise taken off
// (image_error.h); not below 0.
LightError light_error(const ImageF& indirect, const workbench::ReferencePair& truth);

// A mean with its interval: of 98.3 %, so that three looks at growing numbers of seeds are wrong in 5 % of
// all cases together (Bonferroni).
struct Interval {
    double mean = 0, low = 0, high = 0;
};
// Of differences that are independent and about normal, by Student's t; a single one has no bounds.
Interval interval_of(const std::vector<double>& differences);

enum class LightVerdict { same, better, worse, undecided };

// Errors of the same seeds, before and now, as many as the shorter list has. Equivalence within a margin
// (two one-sided tests, Schuirmann 1987) of 0.01 relRMSE and of 0.01 in the distance of flux from 1; `worse`
// if either is beyond it for sure, `better` if one is better than by it for sure and neither may be worse,
// else `undecided`.
struct LightComparison {
    LightVerdict verdict = LightVerdict::undecided;
    Interval relrmse, off_flux;  // now minus before
    double before = 0, now = 0;  // mean relRMSE
    double flux_before = 0, flux_now = 0;
    std::size_t seeds = 0;  // that were compared
};
LightComparison compare_light(const std::vector<LightError>& before, const std::vector<LightError>& now);

// The same for errors that are still to be found: `next` is asked for one seed after the other. Looked at are
// 4, 8 and 16 of them, or as many as `before` has, until a look tells.
LightComparison compare_until_sure(const std::vector<LightError>& before,
                                   const std::function<LightError()>& next);

const char* verdict_word(LightVerdict verdict);
// "relRMSE to path 0.131 -> 0.158: +0.027 [+0.019, +0.035], flux 0.99 -> 0.98, 4 seeds, margin 0.010".
std::string light_words(const LightComparison& comparison);

}  // namespace lanthorn::tools
