#include "lanthorn/ecs/schedule.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <optional>

#include "engine/ecs/schedule_trial.h"

namespace lanthorn::ecs {

namespace detail {

void throw_system_needs(const std::string& system, std::string_view resource) {
    throw Error("system '" + system + "' needs a resource of type " + std::string(resource) +
                ", but there is none");
}

namespace {

class SyncPoint final : public SystemBase {
  public:
    void declare(SystemAccess& access) const override { access.exclusive = true; }
    void prepare(World&) override {}
    bool matches(const RunContext&) override { return true; }
    void run(const RunContext&) override {}
    bool only_a_query() const override { return false; }
    void reset() override {}
};

}  // namespace
}  // namespace detail

// What belongs to one world and lasts from run to run, by position in the order.
struct Schedule::Runner {
    Runner(std::uint64_t id, std::size_t n)
        : world_id(id), last_run(n, 0), now(n, 0), commands(n), errors(n), waits(n), needs(n, 0) {}

    std::uint64_t world_id;
    std::vector<Tick> last_run;  // 0: never
    std::vector<Tick> now;       // of the present run
    std::vector<std::unique_ptr<Commands>> commands;
    std::vector<std::exception_ptr> errors;
    std::vector<std::atomic<std::uint32_t>> waits;
    std::vector<std::uint32_t> needs;  // systems of its own segment that each waits for
    std::atomic<bool> failed{false};
    std::optional<detail::Workers> workers;
};

Schedule::Schedule(std::string name) : name_(std::move(name)) {}
Schedule::Schedule(Schedule&&) noexcept = default;
Schedule& Schedule::operator=(Schedule&&) noexcept = default;
Schedule::~Schedule() = default;

Schedule::Config Schedule::add_system(std::string name, std::unique_ptr<detail::SystemBase> system) {
    for (const ScheduleGraph::Node& node : graph_.nodes) {
        if (node.name == name) {
            throw Error(name_ + ": there already is a system '" + name + "'");
        }
    }
    ScheduleGraph::Node node;
    node.name = std::move(name);
    system->declare(node.access);
    node.skip_if_empty = system->only_a_query();
    graph_.nodes.push_back(std::move(node));
    systems_.push_back(std::move(system));
    built_ = false;
    return Config(*this, graph_.nodes.size() - 1);
}

void Schedule::add_group(std::string name) {
    graph_.groups.push_back(std::move(name));
    built_ = false;
}

Schedule::Config Schedule::add_sync_point(std::string name) {
    return add_system(std::move(name), std::make_unique<detail::SyncPoint>());
}

ScheduleGraph::Node& Schedule::Config::node() {
    schedule_->built_ = false;
    return schedule_->graph_.nodes[index_];
}

Schedule::Config& Schedule::Config::before(std::string_view other) {
    node().before.emplace_back(other);
    return *this;
}

Schedule::Config& Schedule::Config::after(std::string_view other) {
    node().after.emplace_back(other);
    return *this;
}

Schedule::Config& Schedule::Config::in(std::string_view group) {
    node().groups.emplace_back(group);
    return *this;
}

Schedule::Config& Schedule::Config::skip_if_empty(bool skip) {
    node().skip_if_empty = skip;
    return *this;
}

Schedule::Config& Schedule::Config::on_main_thread() {
    node().on_main_thread = true;
    return *this;
}

Schedule::Config& Schedule::Config::access(SystemAccess::Kind kind, TypeId id, std::string_view name,
                                           bool write) {
    node().access.add(kind, id, name, write);
    return *this;
}

void Schedule::build() {
    if (built_) {
        return;
    }
    graph_.build(name_);
    segments_.clear();
    Segment segment{0, 0, false, {}, {}, {}};
    for (std::size_t k = 0; k < graph_.order.size(); ++k) {
        const SystemAccess& access = graph_.nodes[graph_.order[k]].access;
        segment.last = k;
        if (access.exclusive) {
            segment.fence = true;
            segments_.push_back(std::move(segment));
            segment = {k + 1, k + 1, false, {}, {}, {}};
        } else {
            if (access.commands) {
                segment.with_commands.push_back(k);
            }
            if (on_main_thread(k)) {
                segment.on_main_thread.push_back(k);
            }
            segment.last = k + 1;
        }
    }
    if (segment.last > segment.first) {
        segments_.push_back(std::move(segment));
    }
    report_.clear();
    for (const std::size_t node : graph_.order) {
        report_.push_back({graph_.nodes[node].name, false, 0});
    }
    runner_.reset();
    built_ = true;
}

std::vector<std::string> Schedule::order() {
    build();
    std::vector<std::string> names;
    for (const std::size_t node : graph_.order) {
        names.push_back(graph_.nodes[node].name);
    }
    return names;
}

std::string Schedule::to_dot() {
    build();
    return graph_.to_dot(name_);
}

void Schedule::run(World& world) {
    world.check_unlocked("run a schedule");
    build();
    const std::size_t n = systems_.size();
    if (!runner_ || runner_->world_id != world.id()) {
        for (const auto& system : systems_) {
            system->reset();
        }
        runner_ = std::make_unique<Runner>(world.id(), n);
        for (std::size_t k = 0; k < n; ++k) {
            if (graph_.nodes[graph_.order[k]].access.commands) {
                runner_->commands[k] = std::make_unique<Commands>(world);
            }
        }
        for (Segment& segment : segments_) {
            for (std::size_t k = segment.first; k < segment.last; ++k) {
                for (const std::size_t next : graph_.followers[k]) {
                    if (next < segment.last) {
                        ++runner_->needs[next];
                    }
                }
            }
            segment.roots.clear();
            for (std::size_t k = segment.first; k < segment.last; ++k) {
                if (runner_->needs[k] == 0) {
                    segment.roots.push_back(k);
                }
            }
        }
    }
    if (updates_events_) {
        world.update_events();
    }
    runner_->failed = false;
    for (Report& report : report_) {
        report.ran = false;
        report.seconds = 0;
    }
    try {
        run_segments(world);
    } catch (...) {
        discard_commands();
        world.mark();
        throw;
    }
    world.mark();
}

void Schedule::run_segments(World& world) {
    auto all = [&] {
        for (const Segment& segment : segments_) {
            run_segment(world, segment);
        }
    };
    if (threads_ == 1) {
        const detail::OnThisThread here;
        all();
        return;
    }
    std::optional<detail::Workers>& workers = runner_->workers;
    if (!workers || workers->threads() != threads_) {
        workers.emplace(threads_);
    }
    workers->lead(all);
}

bool Schedule::on_main_thread(std::size_t position) const {
    return graph_.nodes[graph_.order[position]].on_main_thread;
}

void Schedule::run_segment(World& world, const Segment& segment) {
    Runner& r = *runner_;
    if (segment.first < segment.last) {
        // One tick a system, in their order. The world's own present comes after them all.
        const Tick base = world.take_ticks(segment.last - segment.first);
        for (std::size_t k = segment.first; k < segment.last; ++k) {
            r.now[k] = base + (k - segment.first);
        }
        for (std::size_t k = segment.first; k < segment.last; ++k) {
            systems_[graph_.order[k]]->prepare(world);
        }
        for (const std::size_t k : segment.with_commands) {
            r.commands[k]->fill_pool();
        }
        const std::uint32_t page = world.entities().first_parallel_page();
        std::uint32_t slot = 0;
        for (const std::size_t k : segment.with_commands) {
            r.commands[k]->begin_parallel(page, slot++,
                                          static_cast<std::uint32_t>(segment.with_commands.size()));
        }
        {
            const World::Lock lock(world);
            if (threads_ == 1 || watcher_ || segment.last - segment.first == 1) {
                for (std::size_t k = segment.first; k < segment.last && !r.failed; ++k) {
                    run_system(world, k);
                    tell(world, k, false);
                }
            } else {
                run_in_parallel(world, segment);
            }
        }
        for (const std::size_t k : segment.with_commands) {
            r.commands[k]->end_parallel();
        }
        if (r.failed) {
            for (std::size_t k = segment.first; k < segment.last; ++k) {
                if (r.errors[k]) {
                    std::rethrow_exception(std::exchange(r.errors[k], nullptr));
                }
            }
        }
    }
    const std::size_t fence = segment.last;
    for (const std::size_t k : segment.with_commands) {
        apply_commands(world, k);
    }
    if (!segment.fence) {
        return;
    }
    systems_[graph_.order[fence]]->prepare(world);
    r.now[fence] = world.now();
    const bool ran = run_system(world, fence);
    if (r.errors[fence]) {
        std::rethrow_exception(std::exchange(r.errors[fence], nullptr));
    }
    // It may have moved time on with World::mark(): what it did lasts until its last tick.
    if (ran) {
        r.last_run[fence] = world.now();
    }
    tell(world, fence, false);
    if (r.commands[fence]) {
        apply_commands(world, fence);
    }
    world.mark();
}

void Schedule::run_in_parallel(World& world, const Segment& segment) {
    Runner& r = *runner_;
    for (std::size_t k = segment.first; k < segment.last; ++k) {
        r.waits[k].store(r.needs[k], std::memory_order_relaxed);
    }
    // Runs k and then, without a new task, one of those that it made ready. The main thread does not: one of
    // its own may be ready.
    r.workers->run(systems_.size(), segment.roots, segment.on_main_thread, [&](std::size_t k) {
        while (k < segment.last) {
            if (!r.failed.load(std::memory_order_relaxed)) {
                run_system(world, k);
            }
            std::size_t mine = segment.last;
            for (const std::size_t next : graph_.followers[k]) {
                if (next >= segment.last) {
                    continue;
                }
                if (r.waits[next].fetch_sub(1, std::memory_order_acq_rel) != 1) {
                    continue;
                }
                if (on_main_thread(next)) {
                    r.workers->spawn_on_caller(next);
                } else if (mine == segment.last && !on_main_thread(k)) {
                    mine = next;
                } else {
                    r.workers->spawn(next);
                }
            }
            k = mine;
        }
    });
}

bool Schedule::run_system(World& world, std::size_t position) noexcept {
    Runner& r = *runner_;
    const std::size_t node = graph_.order[position];
    const SystemTicks ticks{r.last_run[position], r.now[position]};
    const detail::RunContext context{world, ticks, r.commands[position].get(), graph_.nodes[node].name};
    try {
        if (graph_.nodes[node].name == left_out_system() ||
            (graph_.nodes[node].skip_if_empty && !systems_[node]->matches(context))) {
            return false;
        }
        using Clock = std::chrono::steady_clock;  // for reports: no system sees what it says
        const auto start = Clock::now();
        systems_[node]->run(context);
        report_[position].seconds = std::chrono::duration<double>(Clock::now() - start).count();
    } catch (...) {
        r.errors[position] = std::current_exception();
        r.failed = true;
        return false;
    }
    report_[position].ran = true;
    r.last_run[position] = ticks.now;
    return true;
}

void Schedule::tell(World& world, std::size_t position, bool commands) const {
    if (watcher_) {
        watcher_(graph_.nodes[graph_.order[position]].name, commands, world);
    }
}

void Schedule::apply_commands(World& world, std::size_t position) {
    try {
        runner_->commands[position]->apply();
    } catch (const Error& error) {
        throw Error("commands of system '" + graph_.nodes[graph_.order[position]].name +
                    "': " + error.what());
    }
    tell(world, position, true);
}

void Schedule::discard_commands() {
    for (const auto& commands : runner_->commands) {
        if (commands) {
            commands->discard();
        }
    }
    for (std::exception_ptr& error : runner_->errors) {
        error = nullptr;
    }
}

}  // namespace lanthorn::ecs
