// What a model differs in, written into the document.
#pragma once

#include "lanthorn/assets/gltf_document.h"
#include "tools/editor/core/edit_model.h"

namespace lanthorn::editor {

// Makes `document`, which says what `before` does, say what `after` does; all else in it stays as it is, byte
// for byte. Nodes and lights that `after` has more are appended, so that indices agree. The same models give
// the same bytes. Throws InputError for a value that glTF does not allow. O(nodes), and the patches.
void write_changes(GltfDocument& document, const EditModel& before, const EditModel& after);

}  // namespace lanthorn::editor
