#include "tools/editor/core/rebase.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lanthorn/core/error.h"
#include "lanthorn/core/value_info.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/operation.h"

namespace lanthorn::editor {

namespace {

// Which node of the new scene one of the old scene is, by the old document's index.
class Places {
  public:
    std::uint32_t find(const EditModel& model, const NodeMark& mark, const CommandContext& context) {
        if (const auto known = known_.find(mark.node); known != known_.end()) {
            if (model.find(known->second) != nullptr) {
                return known->second;
            }
        }
        const auto batch = made_with_.find(mark.node);
        if (mark.made && batch == made_with_.end()) {
            throw InputError(fmt::format("'{}' was made by a command that is left out", mark.path));
        }
        const std::uint32_t found = mark.made ? find_among(batch->second, model, mark, context)
                                              : find_marked(model, mark, context.mesh_hash);
        if (found == kNone || is_taken(found)) {
            throw InputError(fmt::format("'{}' is gone, or is one of several that it could be", mark.path));
        }
        known_[mark.node] = found;
        return found;
    }

    // A command was done on both. The first node that it made is the same; what a copy has below may stand in
    // another order.
    void made(const Command& old, const Command& now) {
        if (old.made.empty() || now.made.empty()) {
            return;
        }
        known_[old.made.front()] = now.made.front();
        for (const std::uint32_t node : old.made) {
            made_with_[node] = now.made;
        }
    }

  private:
    static std::uint32_t find_among(const std::vector<std::uint32_t>& nodes, const EditModel& model,
                                    const NodeMark& mark, const CommandContext& context) {
        std::uint32_t found = kNone;
        for (const std::uint32_t node : nodes) {
            if (model.find(node) != nullptr && is_marked(model, node, mark, context.mesh_hash)) {
                if (found != kNone) {
                    return kNone;
                }
                found = node;
            }
        }
        return found;
    }

    // No two nodes are one.
    bool is_taken(std::uint32_t node) const {
        return std::ranges::any_of(known_, [&](const auto& entry) { return entry.second == node; });
    }

    std::map<std::uint32_t, std::uint32_t> known_;
    std::map<std::uint32_t, std::vector<std::uint32_t>> made_with_;  // what may be it, of what commands made
};

// A material is known by its name; one that has none, or shares it, by what its factor was as well.
void check_material(const Command& old, const Command& now) {
    if (now.path.starts_with("material ") && now.path.find('#') != std::string::npos &&
        old.before != now.before) {
        throw InputError(fmt::format("'{}' is another one now", old.path));
    }
}

std::string nearest_to(const EditModel& model, const Command& command) {
    std::string nearest;
    if (command.marks.empty() || command.marks.front().name.empty()) {
        return nearest;
    }
    const NodeMark& mark = command.marks.front();
    std::size_t distance = std::max<std::size_t>(2, mark.name.size() / 3) + 1;
    for (std::uint32_t i = 0; i < model.nodes.size(); ++i) {
        if (model.nodes[i] != nullptr) {
            const std::size_t d = edit_distance(model.nodes[i]->name, mark.name);
            if (d < distance) {
                distance = d;
                nearest = path_of(model, i);
            }
        }
    }
    return nearest;
}

}  // namespace

Rebased rebase(const std::vector<EditStep>& steps, EditHistory& history, const CommandContext& context) {
    Rebased result;
    Places places;
    for (const EditStep& step : steps) {
        EditStep redone{step.text, {}, {}, step.seconds};
        EditModel model = history.model();
        for (const Command& command : step.commands) {
            std::size_t next = 0;
            CommandContext marked{context.registry,
                                  [&](const EditModel& at, std::string_view path) {
                                      return next < command.marks.size()
                                                 ? places.find(at, command.marks[next++], context)
                                                 : node_at(at, path);
                                  },
                                  context.mesh_hash};
            try {
                EditModel after = model;
                Command now = apply_command(after, marked, command.text);
                check_material(command, now);
                places.made(command, now);
                model = std::move(after);
                redone.commands.push_back(std::move(now));
                ++result.kept;
            } catch (const InputError& error) {
                result.left.push_back({command, error.what(), nearest_to(model, command)});
            }
        }
        if (redone.commands.empty()) {
            continue;
        }
        const std::vector<Command> commands = redone.commands;
        try {
            history.add(std::move(redone), context);
        } catch (const InputError& error) {  // what the new document does not allow
            result.kept -= commands.size();
            for (const Command& command : commands) {
                result.left.push_back({command, error.what(), {}});
            }
        }
    }
    return result;
}

}  // namespace lanthorn::editor
