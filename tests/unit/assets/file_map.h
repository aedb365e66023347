// Whether entities and the file's nodes, cameras, lights and materials find each other.
#pragma once

#include <filesystem>

namespace lanthorn {

// Imports and spawns the file; every node of its scene must have one entity, and back.
void expect_file_map(const std::filesystem::path& file);

}  // namespace lanthorn
