#include "tools/editor/core/edit_history.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "tools/editor/core/document_changes.h"

namespace lanthorn::editor {

namespace {

constexpr std::size_t kAround = 8;  // steps before and after the present one that are kept

// The command again, on both.
Command repeat(EditModel& model, GltfDocument& document, const CommandContext& context,
               const std::string& text) {
    EditModel after = model;
    Command done = apply_command(after, context, text);
    write_changes(document, model, after);
    model = std::move(after);
    return done;
}

}  // namespace

EditHistory::EditHistory(EditModel model, GltfDocument document)
    : model_(std::move(model)), document_(std::move(document)) {
    keep();
}

std::size_t EditHistory::interval() const {
    return std::clamp<std::size_t>(model_.nodes.size() / 64, 16, 1024);
}

void EditHistory::keep() {
    kept_.insert_or_assign(position_, Kept{model_, document_});
    std::erase_if(kept_, [&](const auto& entry) {
        const std::size_t at = entry.first;
        const std::size_t away = at > position_ ? at - position_ : position_ - at;
        return at % interval() != 0 && away > kAround;
    });
}

void EditHistory::add(EditStep step, const CommandContext& context) {
    EditModel model = model_;
    GltfDocument document = document_;
    for (const Command& command : step.commands) {
        repeat(model, document, context, command.text);
    }
    steps_.resize(position_);
    kept_.erase(kept_.upper_bound(position_), kept_.end());
    steps_.push_back(std::move(step));
    model_ = std::move(model);
    document_ = std::move(document);
    ++position_;
    keep();
}

void EditHistory::go_to(std::size_t position, const CommandContext& context) {
    assert(position <= steps_.size());
    const auto nearest = std::prev(kept_.upper_bound(position));
    const bool goes_on = position_ <= position && position_ >= nearest->first;
    if (!goes_on) {
        model_ = nearest->second.model;
        document_ = nearest->second.document;
        position_ = nearest->first;
    }
    while (position_ < position) {
        for (const Command& command : steps_[position_].commands) {
            repeat(model_, document_, context, command.text);
        }
        ++position_;
        if (position - position_ <= kAround || position_ % interval() == 0) {
            kept_.insert_or_assign(position_, Kept{model_, document_});
        }
    }
    keep();
}

}  // namespace lanthorn::editor
