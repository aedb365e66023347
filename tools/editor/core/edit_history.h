// The steps of an editing session: what undo goes back over.
#pragma once

#include <cstdint>
#include <map>
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
// before. Both are kept as they were after the steps around here and after every so many others; what lies
// between is computed again.
class EditHistory {
  public:
    EditHistory() = default;
    EditHistory(EditModel model, GltfDocument document);

    const EditModel& model() const { return model_; }              // after the steps up to position()
    const GltfDocument& document() const { return document_; }     // likewise
    const std::vector<EditStep>& steps() const { return steps_; }  // done and undone
    std::size_t position() const { return position_; }             // how many are done
    const GltfDocument& first_document() const { return kept_.at(0).document; }  // before any step

    // Does the step's commands, by their texts, and makes it the last: those that were undone are dropped.
    // Throws InputError as apply_command() and GltfDocument do; nothing has changed then.
    void add(EditStep step, const CommandContext& context);
    // To any position from 0 to steps().size(). O(steps since the nearest kept one).
    void go_to(std::size_t position, const CommandContext& context);

  private:
    struct Kept {
        EditModel model;
        GltfDocument document;
    };
    void keep();
    std::size_t interval() const;

    EditModel model_;
    GltfDocument document_;
    std::vector<EditStep> steps_;
    std::size_t position_ = 0;
    std::map<std::size_t, Kept> kept_;  // by position; 0 is always there
};

}  // namespace lanthorn::editor
