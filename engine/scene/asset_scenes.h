// Whole files in an AssetStore: found again by their content, or taken apart into assets.
#pragma once

#include "engine/scene/asset_state.h"
#include "engine/scene/scene_digest.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// The scene of that source and content, whatever was edited since; a null handle if there is none. O(scenes).
SceneHandle find_same_scene(const AssetState& state, const SceneData& scene, const SceneDigest& digest);

// Adds its assets and it; importers have checked them. O(nodes + assets), and O(data) of nothing.
SceneHandle join_scene(AssetState& state, SceneData&& scene, const SceneDigest& digest);

}  // namespace lanthorn
