// What each lamp of the scene that is edited costs.
#pragma once

#include <memory>

#include "lanthorn/core/settings.h"
#include "tools/editor/core/edit_session.h"
#include "tools/workbench/measure/light_costs.h"

namespace lanthorn::editor {

// By frames of a fresh App of the document's bytes, seen from the session's pose. The numbers of entities are
// those of the session's world. Needs a current OpenGL context that outlives the result.
std::unique_ptr<workbench::LightCosts> document_light_costs(const EditSession& session,
                                                            const Settings& settings, ivec2 size);

}  // namespace lanthorn::editor
