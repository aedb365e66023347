// What every imported scene must satisfy, whatever the file said.
#pragma once

#include <filesystem>

#include "lanthorn/core/error.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// Expects finite numbers, unit normals and tangents, indices in range, parents before children.
void expect_scene_invariants(const SceneData& scene);

// Expects one line "FILE: PLACE: PROBLEM".
void expect_places_in(const InputError& error, const std::filesystem::path& file);

}  // namespace lanthorn
