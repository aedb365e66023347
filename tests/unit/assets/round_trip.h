// Writing a glTF file through GltfDocument and looking for what it lost.
#pragma once

#include <filesystem>

namespace lanthorn {

// Writes `file` into `folder` in its own container, in the other one, and from there back, and expects: the
// same bytes in its own container (if that is whole); elsewhere the same JSON, unknown members and their
// order included, but for where buffer 0 is; the same bytes of every buffer and image; the same scene when
// imported.
void expect_lossless(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace lanthorn
