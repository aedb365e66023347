// Rendering a scene with the path tracer: what `lanthorn render --technique path` does between reading and
// writing files.
#pragma once

#include <functional>
#include <string>

#include "lanthorn/workbench/render_job.h"

namespace lanthorn::reference {
class PathTracer;
struct PathPiece;
}  // namespace lanthorn::reference

namespace lanthorn::workbench {

// Like render_scene(). OpenGL is needed for `final` alone: its exposure and tone map are the rasteriser's.
// `checkpoint`: a file to continue from if it is there, and to keep up to date; empty: none; that
// it cannot be written does not end the work. `progressed` is told the share of the work that is done. A
// signal that a StopSignal notes ends the work with what there is; throws Stopped if that is nothing yet.
RenderOutcome path_trace_scene(SceneData scene, const Settings& settings, const RenderJob& job,
                               const std::string& checkpoint, const std::function<void(double)>& progressed);

// The same, traced by `trace`, which leaves all samples in the tracer: of pieces, say, that others traced.
RenderOutcome path_trace_scene(SceneData scene, const Settings& settings, const RenderJob& job,
                               const std::function<void(reference::PathTracer&)>& trace);

// One of such pieces (reference/path_tracer.h), into a file. `progressed` as above; a signal ends it without
// a file: throws Stopped.
void path_trace_piece(SceneData scene, const Settings& settings, const RenderJob& job,
                      const reference::PathPiece& piece, const std::string& file,
                      const std::function<void(double)>& progressed);

}  // namespace lanthorn::workbench
