#include "lanthorn/ecs/schedule_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <queue>

#include "engine/ecs/schedule_trial.h"
#include "lanthorn/ecs/error.h"

namespace lanthorn::ecs {
namespace {

using Entry = SystemAccess::Entry;

bool intersects(const std::vector<TypeId>& a, const std::vector<TypeId>& b) {
    return std::any_of(a.begin(), a.end(),
                       [&](TypeId id) { return std::find(b.begin(), b.end(), id) != b.end(); });
}

// No entity can be in both queries.
bool disjoint(const SystemAccess& a, std::size_t qa, const SystemAccess& b, std::size_t qb) {
    if (qa == SystemAccess::kNoQuery || qb == SystemAccess::kNoQuery) {
        return false;
    }
    return intersects(a.queries[qa].with, b.queries[qb].without) ||
           intersects(a.queries[qa].without, b.queries[qb].with);
}

std::string describe(const Entry& entry) {
    switch (entry.kind) {
        case SystemAccess::Kind::component:
            return "component " + std::string(entry.name);
        case SystemAccess::Kind::resource:
            return "resource " + std::string(entry.name);
        case SystemAccess::Kind::events:
            return "events " + std::string(entry.name);
    }
    return {};
}

// What two systems contend for; null where they do not.
struct Conflict {
    const Entry* both_write = nullptr;
    const Entry* a_feeds_b = nullptr;
    const Entry* b_feeds_a = nullptr;
};

Conflict conflict_of(const SystemAccess& a, const SystemAccess& b) {
    Conflict conflict;
    for (const Entry& x : a.entries) {
        for (const Entry& y : b.entries) {
            if (x.kind != y.kind || x.id != y.id || !(x.write || y.write)) {
                continue;
            }
            if (disjoint(a, x.query, b, y.query)) {
                continue;
            }
            const Entry*& kind = x.write && y.write ? conflict.both_write
                                 : x.write          ? conflict.a_feeds_b
                                                    : conflict.b_feeds_a;
            if (!kind) {
                kind = &x;
            }
        }
    }
    return conflict;
}

// A number that looks random, from a counter (Steele et al. 2014, splitmix64).
std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::string in_quotes(const std::string& name) {
    return "'" + name + "'";
}

}  // namespace

void ScheduleGraph::build(const std::string& schedule) {
    edges.clear();
    add_explicit_edges(schedule);
    Reach reach = closure(schedule);
    add_fence_edges(reach);
    add_access_edges(schedule, reach);
    find_order();
}

void ScheduleGraph::add_explicit_edges(const std::string& schedule) {
    const auto named = [&](const std::string& name, std::size_t asker) {
        std::vector<std::size_t> found;
        bool exists = std::ranges::find(groups, name) != groups.end();
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const auto& groups = nodes[i].groups;
            if (nodes[i].name != name && std::find(groups.begin(), groups.end(), name) == groups.end()) {
                continue;
            }
            exists = true;
            if (i != asker || nodes[i].name == name) {
                found.push_back(i);
            }
        }
        if (!exists) {
            throw Error(schedule + ": system " + in_quotes(nodes[asker].name) +
                        " is to run before or after " + in_quotes(name) +
                        ", but there is no system or group of that name");
        }
        return found;
    };
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const std::string& name : nodes[i].before) {
            for (const std::size_t other : named(name, i)) {
                edges.push_back({i, other, "before", true});
            }
        }
        for (const std::string& name : nodes[i].after) {
            for (const std::size_t other : named(name, i)) {
                edges.push_back({other, i, "after", true});
            }
        }
    }
}

void ScheduleGraph::add_fence_edges(Reach& reach) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (std::size_t j = i + 1; j < nodes.size(); ++j) {
            if (!nodes[i].access.exclusive && !nodes[j].access.exclusive) {
                continue;
            }
            if (reach[i][j] || reach[j][i]) {
                continue;
            }
            const std::string& alone = nodes[nodes[i].access.exclusive ? i : j].name;
            edges.push_back({i, j, in_quotes(alone) + " runs alone, in the order of adding", false});
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                if (k != i && !reach[k][i]) {
                    continue;
                }
                reach[k][j] = true;
                for (std::size_t m = 0; m < nodes.size(); ++m) {
                    if (reach[j][m]) {
                        reach[k][m] = true;
                    }
                }
            }
        }
    }
}

void ScheduleGraph::add_access_edges(const std::string& schedule, const Reach& before) {
    struct Pair {
        std::size_t a, b;
        Conflict conflict;
    };
    std::vector<Pair> unordered;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
        for (std::size_t b = a + 1; b < nodes.size(); ++b) {
            if (before[a][b] || before[b][a]) {
                continue;
            }
            const Conflict c = conflict_of(nodes[a].access, nodes[b].access);
            if (c.both_write || (c.a_feeds_b && c.b_feeds_a)) {
                unordered.push_back({a, b, c});
            } else if (c.a_feeds_b) {
                edges.push_back({a, b, "writes " + describe(*c.a_feeds_b), false});
            } else if (c.b_feeds_a) {
                edges.push_back({b, a, "writes " + describe(*c.b_feeds_a), false});
            }
        }
    }
    const Reach after = closure(schedule);
    std::string problems;
    for (const Pair& pair : unordered) {
        if (after[pair.a][pair.b] || after[pair.b][pair.a]) {
            continue;
        }
        const std::string a = in_quotes(nodes[pair.a].name);
        const std::string b = in_quotes(nodes[pair.b].name);
        if (!problems.empty()) {
            problems += '\n';
        }
        problems += fmt::format("{}: systems {} and {}", schedule, a, b);
        if (pair.conflict.both_write) {
            problems += " both write " + describe(*pair.conflict.both_write);
        } else {
            problems += fmt::format(
                " need an order: {0} writes {2} that {1} reads, and {1} writes {3} that {0} reads", a, b,
                describe(*pair.conflict.a_feeds_b), describe(*pair.conflict.b_feeds_a));
        }
        problems += "; say which runs first with before or after";
    }
    if (!problems.empty()) {
        throw Error(problems);
    }
}

ScheduleGraph::Reach ScheduleGraph::closure(const std::string& schedule) const {
    const std::size_t n = nodes.size();
    std::vector<std::vector<std::size_t>> next(n);
    std::vector<std::size_t> waits(n, 0);
    for (const Edge& edge : edges) {
        next[edge.from].push_back(edge.to);
        ++waits[edge.to];
    }
    std::vector<std::size_t> sorted;
    for (std::size_t i = 0; i < n; ++i) {
        if (waits[i] == 0) {
            sorted.push_back(i);
        }
    }
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        for (const std::size_t to : next[sorted[k]]) {
            if (--waits[to] == 0) {
                sorted.push_back(to);
            }
        }
    }
    if (sorted.size() < n) {
        std::vector<bool> stuck(n);
        for (std::size_t i = 0; i < n; ++i) {
            stuck[i] = waits[i] > 0;
        }
        throw_cycle(schedule, stuck);
    }
    Reach reach(n, std::vector<bool>(n, false));
    for (auto it = sorted.rbegin(); it != sorted.rend(); ++it) {
        for (const std::size_t to : next[*it]) {
            reach[*it][to] = true;
            for (std::size_t j = 0; j < n; ++j) {
                if (reach[to][j]) {
                    reach[*it][j] = true;
                }
            }
        }
    }
    return reach;
}

void ScheduleGraph::throw_cycle(const std::string& schedule, const std::vector<bool>& stuck) const {
    // Every stuck node waits for a stuck one: walking backwards must come round.
    std::vector<const Edge*> incoming(nodes.size(), nullptr);
    for (const Edge& edge : edges) {
        if (stuck[edge.from] && stuck[edge.to] && !incoming[edge.to]) {
            incoming[edge.to] = &edge;
        }
    }
    std::size_t at = static_cast<std::size_t>(std::find(stuck.begin(), stuck.end(), true) - stuck.begin());
    for (std::size_t step = 0; step < nodes.size(); ++step) {
        at = incoming[at]->from;
    }
    std::vector<const Edge*> loop;
    const std::size_t start = at;
    do {
        loop.push_back(incoming[at]);
        at = incoming[at]->from;
    } while (at != start);
    std::string text = schedule + ": cycle: " + in_quotes(nodes[start].name);
    for (auto it = loop.rbegin(); it != loop.rend(); ++it) {
        text += " -> " + in_quotes(nodes[(*it)->to].name) + " (" + (*it)->reason + ")";
    }
    throw Error(text);
}

void ScheduleGraph::find_order() {
    const std::uint64_t seed = schedule_seed();
    const std::size_t n = nodes.size();
    std::vector<std::size_t> waits(n, 0), position(n, 0);
    for (const Edge& edge : edges) {
        ++waits[edge.to];
    }
    using Ready = std::pair<std::uint64_t, std::size_t>;  // the lowest first, and its node
    std::priority_queue<Ready, std::vector<Ready>, std::greater<>> ready;
    const auto push = [&](std::size_t node) {
        ready.emplace(seed == 0 ? node : mixed(seed + 0x9e3779b97f4a7c15u * (node + 1)), node);
    };
    for (std::size_t i = 0; i < n; ++i) {
        if (waits[i] == 0) {
            push(i);
        }
    }
    order.clear();
    while (!ready.empty()) {
        const std::size_t node = ready.top().second;
        ready.pop();
        position[node] = order.size();
        order.push_back(node);
        for (const Edge& edge : edges) {
            if (edge.from == node && --waits[edge.to] == 0) {
                push(edge.to);
            }
        }
    }
    followers.assign(n, {});
    for (const Edge& edge : edges) {
        followers[position[edge.from]].push_back(position[edge.to]);
    }
    for (auto& list : followers) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
}

std::string ScheduleGraph::to_dot(const std::string& schedule) const {
    const auto escaped = [](std::string text) {
        for (std::size_t at = 0; (at = text.find_first_of("\"\\", at)) != std::string::npos; at += 2) {
            text.insert(at, 1, '\\');
        }
        return text;
    };
    std::string dot = "digraph \"" + escaped(schedule) + "\" {\n    rankdir=LR;\n    node [shape=box];\n";
    for (std::size_t k = 0; k < order.size(); ++k) {
        const Node& node = nodes[order[k]];
        std::string label = escaped(std::to_string(k + 1) + " " + node.name);
        std::vector<std::string> lines;
        for (const Entry& entry : node.access.entries) {
            lines.push_back(escaped(std::string(entry.write ? "writes " : "reads ") + describe(entry)));
        }
        if (node.access.commands) {
            lines.push_back("commands");
        }
        std::sort(lines.begin(), lines.end());
        lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
        if (node.on_main_thread) {
            lines.insert(lines.begin(), "on the main thread");
        }
        for (const std::string& line : lines) {
            label += "\\n" + line;
        }
        dot += "    n" + std::to_string(order[k]) + " [label=\"" + label + "\"" +
               (node.access.exclusive ? ", style=bold" : "") + "];\n";
    }
    for (const Edge& edge : edges) {
        dot += "    n" + std::to_string(edge.from) + " -> n" + std::to_string(edge.to) + " [label=\"" +
               escaped(edge.reason) + "\"" + (edge.explicit_order ? "" : ", style=dashed") + "];\n";
    }
    return dot + "}\n";
}

}  // namespace lanthorn::ecs
