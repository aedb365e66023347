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

bool is_below(const std::string& path, const std::string& above) {
    return path.size() > above.size() && path.starts_with(above) && path[above.size()] == '/';
}

// Which node of the new scene a path of the old one means.
class Places {
  public:
    std::uint32_t find(const EditModel& model, const NodeMark& mark, const CommandContext& context) const {
        if (const auto known = known_.find(mark.path); known != known_.end()) {
            if (model.find(known->second) != nullptr) {
                return known->second;
            }
        }
        // Under a node that commands have made, or put there, names alone are the same.
        for (auto at = known_.rbegin(); at != known_.rend(); ++at) {
            if (is_below(mark.path, at->first) && model.find(at->second) != nullptr) {
                const std::string rest = mark.path.substr(at->first.size());
                const std::uint32_t below = find_node(model, path_of(model, at->second) + rest);
                if (below != kNone && (mark.made || model.node(below).name == mark.name)) {
                    return below;
                }
                break;
            }
        }
        if (mark.made) {
            throw InputError(fmt::format("'{}' was made by a command that is left out", mark.path));
        }
        const std::uint32_t found = find_marked(model, mark, context.mesh_hash);
        if (found == kNone) {
            throw InputError(fmt::format("'{}' is gone, or is one of several that it could be", mark.path));
        }
        return found;
    }

    // A command was done on both.
    void done(const Command& old, const Command& now, const EditModel& before, const EditModel& after) {
        for (std::size_t i = 0; i < old.marks.size() && i < now.marks.size(); ++i) {
            const std::uint32_t node = find_node(before, now.marks[i].path);
            if (node != kNone) {
                known_[old.marks[i].path] = node;
            }
        }
        const bool goes_elsewhere = !old.marks.empty() && old.path_after != old.marks.front().path &&
                                    old.made.empty() && old.path == old.marks.front().path;
        if (goes_elsewhere) {  // renamed, put under another, deleted
            const std::string from = old.marks.front().path;
            std::map<std::string, std::uint32_t> moved;
            for (auto it = known_.begin(); it != known_.end();) {
                const bool is_it = it->first == from || is_below(it->first, from);
                if (is_it && !old.path_after.empty()) {
                    moved[old.path_after + it->first.substr(from.size())] = it->second;
                }
                it = is_it ? known_.erase(it) : std::next(it);
            }
            known_.merge(moved);
        }
        if (!now.touched.empty() && !old.path_after.empty() && after.find(now.touched.front()) != nullptr) {
            known_[old.path_after] = now.touched.front();
        }
    }

  private:
    std::map<std::string, std::uint32_t> known_;
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
                places.done(command, now, model, after);
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
