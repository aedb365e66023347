// Figures of the project's scenes, held under ceilings that only go down: a figure above its ceiling fails
// the test, and one so far below it that the ceiling is stale does, too, so that no gain is lost again.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "lanthorn/core/settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/measure_hits.h"
#include "lanthorn/workbench/metrics.h"

namespace lanthorn::workbench {

class HeldFigures : public testing::Test {
  protected:
    struct Row {
        std::string name;         // printed
        std::string scene;        // of assets/
        std::string camera = "";  // empty: the first
        std::string table;        // the file that its ceilings stand in
    };
    HeldFigures(Row row, ivec2 size);

    SceneView view() const;
    SceneData scene() const;

    // `stale`: what a figure is at least, or its ceiling has to go down.
    void hold(const char* what, double value, double ceiling, double stale) const;
    // Of the first frame's indirect irradiance, the reference's own noise taken off; `flux`: distance of its
    // ratio from 1. The reference has path.spp samples.
    struct Held {
        double ceiling = 0, stale = 0;
    };
    Difference hold_error(const Held& relrmse, const Held& flux) const;
    // 1 - hit agreement of the photons' image-space hits, of which there are enough to tell.
    PhotonFlights hold_misses(const Held& misses) const;

    Settings settings_;  // all at their defaults

  private:
    Row row_;
    ivec2 size_;
};

}  // namespace lanthorn::workbench
