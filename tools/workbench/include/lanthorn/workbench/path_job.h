// Rendering a scene with the path tracer: what `lanthorn render --technique path` does between reading and
// writing files.
#pragma once

#include <functional>
#include <string>

#include "lanthorn/workbench/render_job.h"

namespace lanthorn::workbench {

// Like render_scene(). OpenGL is needed for `final` alone: its exposure and tone map are the rasteriser's.
// `checkpoint`: a file to continue from if it is there, and to keep up to date; empty: none; that
// it cannot be written does not end the work. `progressed` is told the share of the work that is done. A
// signal that a StopSignal notes ends the work with what there is; throws Stopped if that is nothing yet.
RenderOutcome path_trace_scene(SceneData scene, const Settings& settings, const RenderJob& job,
                               const std::string& checkpoint, const std::function<void(double)>& progressed);

}  // namespace lanthorn::workbench
