// Each paper's technique as published, against path tracing of as many bounces.
#include <algorithm>
#include <ostream>
#include <string_view>

#include "lanthorn/workbench/measure_coverage.h"
#include "tests/gpu/papers/paper_figures.h"
#include "tests/gpu/tools/held_figures.h"

namespace lanthorn::workbench {

// For GoogleTest's messages.
void PrintTo(const PaperFigure& figure, std::ostream* out) {
    *out << figure.technique << " " << figure.scene;
}

namespace {

constexpr ivec2 kSize(96);
constexpr int kSpp = 128;  // of the reference

class Papers : public HeldFigures, public testing::WithParamInterface<PaperFigure> {
  protected:
    Papers() : HeldFigures({GetParam().technique, GetParam().scene, "", "paper_figures.h"}, kSize) {
        settings_.apply_preset(kPaperPreset);
        settings_.set_from_text("gi.technique", GetParam().technique);
        settings_.set<int>("path.spp", kSpp);
        // Lavignotte and Paulin's photons are scattered by the whole BSDF; the others' evenly.
        const bool whole = std::string_view(GetParam().technique) == "splat";
        settings_.set_from_text("path.transport", whole ? "full" : "diffuse");
    }
};

TEST_P(Papers, ErrorAndFlux) {
    const PaperFigure& figure = GetParam();
    const Difference difference =
        hold_error({figure.relrmse, kStalePaper * figure.relrmse}, {figure.flux, figure.flux - 0.03});
    EXPECT_GT(difference.flux, 0.2) << "the picture is not black";
}

TEST_P(Papers, HitsAndCoverage) {
    if (GetParam().misses == 0) {
        return;
    }
    settings_.set<int>("gi.photons", 20'000);  // a share, and enough of them to know it
    constexpr int kPoints = 4000;
    const PhotonFlights flights = hold_misses({GetParam().misses, kStalePaper * GetParam().misses});
    const CoverageFigures seen = measure_coverage(flights, kPoints, 1, [](std::uint64_t) {});
    hold("unseen", 1 - seen.coverage, GetParam().unseen, GetParam().unseen - 0.01);
}

std::string test_name(const testing::TestParamInfo<PaperFigure>& info) {
    std::string name = std::string(info.param.technique) + '_' + info.param.scene;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(AsPublished, Papers, testing::ValuesIn(kPaperFigures), test_name);

}  // namespace
}  // namespace lanthorn::workbench
