// The order of a schedule's systems, derived from what they touch and from what before/after says.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/ecs/system.h"

namespace lanthorn::ecs {

class ScheduleGraph {
  public:
    // A system: its access, and the order that it asks for.
    struct Node {
        std::string name;
        std::vector<std::string> before, after, groups;
        SystemAccess access;
        bool skip_if_empty = false;
        bool on_main_thread = false;
    };
    // `from` runs before `to`, and why.
    struct Edge {
        std::size_t from, to;  // nodes
        std::string reason;
        bool explicit_order;
    };

    std::vector<Node> nodes;          // as they were added
    std::vector<std::string> groups;  // that may be empty

    // Fills what follows; throws as Schedule::build says.
    void build(const std::string& schedule);

    std::vector<Edge> edges;
    std::vector<std::size_t> order;                   // nodes, first to last
    std::vector<std::vector<std::size_t>> followers;  // by position in `order`: positions that wait for it

    // As Schedule::to_dot, once built; `schedule` is the graph's name.
    std::string to_dot(const std::string& schedule) const;

  private:
    // reach[a][b]: there is a path from a to b.
    using Reach = std::vector<std::vector<bool>>;

    void add_explicit_edges(const std::string& schedule);
    void add_fence_edges(Reach& reach);  // keeps `reach` right
    void add_access_edges(const std::string& schedule, const Reach& reach);
    Reach closure(const std::string& schedule) const;
    [[noreturn]] void throw_cycle(const std::string& schedule, const std::vector<bool>& stuck) const;
    void find_order();
};

}  // namespace lanthorn::ecs
