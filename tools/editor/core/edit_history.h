// The steps of an editing session: what undo goes back over.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/assets/gltf_document.h"
#include "tools/editor/core/command.h"
#include "tools/editor/core/edit_model.h"

namespace lanthorn::editor {

// One gesture: what one undo takes back.
struct EditStep {
    std::string text;  // for people: "move lamp_2"
    std::vector<Command> commands;
    std::vector<std::uint32_t> selection;  // as it was when the step was done
    double seconds = 0;                    // since the epoch
};

// Model and document after any number of the steps. The document after n steps is a function of the file's
// bytes and the n steps alone, so undoing all gives the file's bytes again, and redoing the same bytes as
// before. Every so many steps both are kept; what lies between is computed again.
class EditHistory {
  public:
    EditHistory() = default;
    EditHistory(EditModel model, GltfDocument document);

    const EditModel& model() const { return model_; }           // after the steps up to position()
    const GltfDocument& document() const { return document_; }  // likewise
    const std::vector<EditStep>& steps() const { return steps_; }  // done and undone
    std::size_t position() const { return position_; }             // how many are done

    // The step becomes the last: those that were undone are dropped. `after` is the model with it.
    void add(EditStep step, EditModel after);
    // To any position from 0 to steps().size(). O(steps since the nearest kept one).
    void go_to(std::size_t position, const CommandContext& context);

  private:
    struct Kept {
        std::size_t position;
        EditModel model;
        GltfDocument document;
    };
    std::size_t interval() const;

    EditModel model_;
    GltfDocument document_;
    std::vector<EditStep> steps_;
    std::size_t position_ = 0;
    std::vector<Kept> kept_;  // by position; the first is 0
};

}  // namespace lanthorn::editor
