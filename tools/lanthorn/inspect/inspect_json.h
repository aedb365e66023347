// `lanthorn inspect --json`: the contents of a scene as one object, for scripts. docs/inspect.md lists its
// keys.
#pragma once

#include <nlohmann/json.hpp>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn::tools {

// Every key is there in every scene; what a thing has not is null or an empty array.
nlohmann::ordered_json contents_json(const SceneData& scene);

}  // namespace lanthorn::tools
