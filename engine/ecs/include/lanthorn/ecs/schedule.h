// Schedule: systems, their order, and their running on several threads with the result of one.
//
//   Schedule schedule("simulation");
//   schedule.add("input", read_input);
//   schedule.add("move", [](Query<Write<Position>, Read<Velocity>> moving) { ... }).after("input");
//   schedule.run(world);
//
// Order. What a system touches is read off its parameters (system.h). A system that writes a component,
// resource or event type runs before those that only read it, unless before/after says otherwise. Two systems
// that write the same, or that each read what the other writes, must be ordered by before/after; queries that
// cannot share an entity (one asks With<X>, the other Without<X>) do not conflict. A system that takes
// World&, and a sync point, runs alone: after what was added before it and before what was added after it,
// unless before/after says otherwise.
//
// Time. Each system has a tick of its own, later than those before it in the order; a system that runs alone
// may move time on by World::mark(), and the next begins after that. Time never runs backwards: what is
// written during or after a run is newer than every mark made before.
//
// Commands are applied at the next such system or sync point and at the end of the run, in the systems'
// order. Results do not depend on the number of threads.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/ecs/schedule_graph.h"
#include "lanthorn/ecs/system.h"

namespace lanthorn::ecs {

class Schedule {
  public:
    explicit Schedule(std::string name = "schedule");
    Schedule(Schedule&&) noexcept;
    Schedule& operator=(Schedule&&) noexcept;
    ~Schedule();

    // Settings of a system just added; valid until the next add().
    class Config {
      public:
        // `other` is a system or a group, added before or later.
        Config& before(std::string_view other);
        // Likewise: this system begins when `other`, or all of that group, has ended.
        Config& after(std::string_view other);
        // Makes it one of a group, which before and after may name; a system may be in several.
        Config& in(std::string_view group);
        // Whether the system is skipped when one of its queries finds nothing (Changed and Added included).
        // Default: yes for a system with one query and no other parameter.
        Config& skip_if_empty(bool skip = true);
        // The system runs on the thread that calls run(), for what belongs to one thread (an OpenGL context).
        // It may overlap others, but for those that run there too: they come one by one, in the order of the
        // schedule. Systems that run alone are on that thread anyway.
        Config& on_main_thread();
        // Access that the parameters do not show.
        template <class T>
        Config& reads() {
            return access(SystemAccess::Kind::component, component_info<T>().id, name_of<T>(), false);
        }
        // Likewise, but writes it, and may read it.
        template <class T>
        Config& writes() {
            return access(SystemAccess::Kind::component, component_info<T>().id, name_of<T>(), true);
        }
        // The system reads the resource T.
        template <class T>
        Config& reads_resource() {
            return access(SystemAccess::Kind::resource, resource_id<T>(), name_of<T>(), false);
        }
        // The system writes the resource T, and may read it.
        template <class T>
        Config& writes_resource() {
            return access(SystemAccess::Kind::resource, resource_id<T>(), name_of<T>(), true);
        }

      private:
        friend class Schedule;
        Config(Schedule& schedule, std::size_t index) : schedule_(&schedule), index_(index) {}
        ScheduleGraph::Node& node();
        Config& access(SystemAccess::Kind kind, TypeId id, std::string_view name, bool write);
        Schedule* schedule_;
        std::size_t index_;
    };

    // `fn` is a function pointer, lambda or object with one operator(). Throws if the name is taken.
    template <class Fn>
    Config add(std::string name, Fn fn) {
        return add_system(std::move(name), detail::make_system(std::move(fn)));
    }
    // A group that before and after may name though nothing is in it.
    void add_group(std::string name);
    // Where commands written so far are applied.
    Config add_sync_point(std::string name);

    // Orders the systems; throws an Error that names the systems of a cycle, systems that conflict without an
    // order, or a name in before/after that does not exist. run() does it when needed.
    void build();
    // Runs every system once. If one throws, those that need not wait for it may still run; commands not yet
    // applied are dropped and the exception (of the first in order) comes out.
    void run(World& world);

    // 1: everything on the calling thread, what systems themselves run in parallel (Query::parallel_each)
    // included. 0 (default): as many as oneTBB has; never more than those.
    void set_threads(int threads) { threads_ = threads; }
    // Whether run() starts with World::update_events(); default yes. No for a second schedule over the same
    // step.
    void set_updates_events(bool updates) { updates_events_ = updates; }

    // Told after every system, and after the commands of each were applied (`commands`); may read the world.
    using Watcher = std::function<void(const std::string& system, bool commands, const World& world)>;
    // From the next run on. Systems run one by one meanwhile, in order. Empty: nobody watches.
    void watch(Watcher watcher) { watcher_ = std::move(watcher); }

    // Names in the order of a run on one thread. Builds if needed.
    std::vector<std::string> order();
    // The graph in Graphviz's language: an arrow is an order, its label the reason. Builds if needed.
    std::string to_dot();

    // What a system took.
    struct Report {
        std::string name;
        bool ran = false;
        double seconds = 0;
    };
    // Of the last run, in order.
    const std::vector<Report>& report() const { return report_; }
    std::size_t size() const { return graph_.nodes.size(); }  // systems, sync points included

  private:
    struct Runner;
    // Systems that may overlap, then (if any) the one that runs alone; positions in the order.
    struct Segment {
        std::size_t first, last;
        bool fence;
        std::vector<std::size_t> with_commands;
        std::vector<std::size_t> on_main_thread;
        std::vector<std::size_t> roots;  // wait for none of the segment
    };

    Config add_system(std::string name, std::unique_ptr<detail::SystemBase> system);
    void run_segments(World& world);
    void run_segment(World& world, const Segment& segment);
    void run_in_parallel(World& world, const Segment& segment);
    bool run_system(World& world, std::size_t position) noexcept;
    bool on_main_thread(std::size_t position) const;
    void apply_commands(World& world, std::size_t position);
    void tell(World& world, std::size_t position, bool commands) const;
    void discard_commands();

    std::string name_;
    ScheduleGraph graph_;
    std::vector<std::unique_ptr<detail::SystemBase>> systems_;
    std::unique_ptr<Runner> runner_;
    std::vector<Segment> segments_;
    std::vector<Report> report_;
    Watcher watcher_;
    int threads_ = 0;
    bool updates_events_ = true;
    bool built_ = false;
};

}  // namespace lanthorn::ecs
