// What a system may ask for as parameters, and how the schedule learns from them what it reads and writes.
//
//   Query<...>               components as its terms say
//   Res<T>, ResMut<T>        a resource
//   EventReader<T>           events; each system has its own cursor
//   EventWriter<T>
//   Commands&                deferred structural changes
//   SystemTicks              when the system last ran, and now
//   World&                   everything: the system runs alone (see Schedule)
#pragma once

#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "lanthorn/ecs/commands.h"
#include "lanthorn/ecs/query.h"

namespace lanthorn::ecs {

// Changes since `since` are new to the system; what it writes is dated `now`.
struct SystemTicks {
    Tick since;
    Tick now;
};

// A system's parameter: a resource, read.
template <class T>
class Res {
  public:
    Res(const T& value, bool changed) : value_(&value), changed_(changed) {}
    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_; }
    // Written since the system ran last.
    bool changed() const { return changed_; }

  private:
    const T* value_;
    bool changed_;
};

// A system's parameter: a resource, read and written.
template <class T>
class ResMut {
  public:
    ResMut(T& value, Tick& changed, SystemTicks ticks) : value_(&value), changed_(&changed), ticks_(ticks) {}
    const T& read() const { return *value_; }  // notes no write
    // These count as a write.
    T& operator*() const {
        *changed_ = ticks_.now;
        return *value_;
    }
    T* operator->() const { return &**this; }
    // Written since the system ran last, by this run included.
    bool changed() const { return *changed_ > ticks_.since; }

  private:
    T* value_;
    Tick* changed_;
    SystemTicks ticks_;
};

// A system's parameter: reads each event once, a place in the queue of its own.
template <class T>
class EventReader {
  public:
    EventReader(const Events<T>& events, std::uint64_t& cursor) : events_(&events), cursor_(&cursor) {}
    // fn(const T&) for each event not yet read, oldest first. Returns the number lost because the reader came
    // too late.
    template <class Fn>
    std::uint64_t each(Fn&& fn) const {
        return events_->read(*cursor_, fn);
    }
    std::uint64_t unread() const { return events_->unread(*cursor_); }  // events not yet read by this system

  private:
    const Events<T>* events_;
    std::uint64_t* cursor_;
};

// A system's parameter: sends events.
template <class T>
class EventWriter {
  public:
    explicit EventWriter(Events<T>& events) : events_(&events) {}
    // To all readers, in this step or the next. Error inside Query::parallel_each.
    void send(T event) const { events_->send(std::move(event)); }

  private:
    Events<T>* events_;
};

// What a system touches.
struct SystemAccess {
    // What an Entry's type is: their ids are counted apart.
    enum class Kind { component, resource, events };
    static constexpr std::size_t kNoQuery = ~std::size_t{0};

    // One type that the system reads or writes.
    struct Entry {
        Kind kind;
        TypeId id;
        std::string_view name;
        bool write;
        std::size_t query = kNoQuery;  // into `queries`
    };
    // Which entities a query is about: two queries whose filters exclude each other do not conflict.
    struct Filter {
        std::vector<TypeId> with, without;
    };

    std::vector<Entry> entries;
    std::vector<Filter> queries;
    bool exclusive = false;
    bool commands = false;

    // Notes that a type is touched; `query` is the index of the query that does, if one does.
    void add(Kind kind, TypeId id, std::string_view name, bool write, std::size_t query = kNoQuery) {
        entries.push_back({kind, id, name, write, query});
    }
};

namespace detail {

struct RunContext {
    World& world;
    SystemTicks ticks;
    Commands* commands;
    const std::string& system;
};

[[noreturn]] void throw_system_needs(const std::string& system, std::string_view resource);

// Params::declare tells the schedule, ::prepare runs alone before systems run in parallel, ::get makes the
// argument.
template <class P>
struct Param {
    static_assert(sizeof(P) == 0,
                  "a system takes Query, Res, ResMut, EventReader, EventWriter, SystemTicks by value, "
                  "Commands&, World&");
};

template <class... Terms>
struct Param<Query<Terms...>> {
    static constexpr bool kQuery = true;
    using State = QueryState<Terms...>;

    static void declare(SystemAccess& access) {
        const std::size_t query = access.queries.size();
        access.queries.emplace_back();
        (declare_term<Terms>(access, query, static_cast<typename TermTraits<Terms>::Types*>(nullptr)), ...);
    }
    static void prepare(State& state, World& world) { state.update(world); }
    static Query<Terms...> get(State& state, const RunContext& c) {
        return Query<Terms...>(c.world, state, c.ticks.since, c.ticks.now);
    }

  private:
    template <class Term, class... Ts>
    static void declare_term(SystemAccess& access, std::size_t query, std::tuple<Ts...>*) {
        SystemAccess::Filter& filter = access.queries[query];
        for (const TypeId id : std::initializer_list<TypeId>{component_info<Ts>().id...}) {
            if (kKind<Term> == TermKind::data || kKind<Term> == TermKind::with) {
                filter.with.push_back(id);
            }
            if (kKind<Term> == TermKind::without) {
                filter.without.push_back(id);
            }
        }
        if constexpr (kIsData<Term>) {
            (access.add(SystemAccess::Kind::component, component_info<Ts>().id, name_of<Ts>(),
                        TermTraits<Term>::Fetch::kWrites, query),
             ...);
        } else if constexpr (kIsRowFilter<Term>) {
            (access.add(SystemAccess::Kind::component, component_info<Ts>().id, name_of<Ts>(), false, query),
             ...);
        }
    }
};

struct NoState {};

template <class T>
struct Param<Res<T>> {
    static constexpr bool kQuery = false;
    using State = NoState;
    static void declare(SystemAccess& access) {
        access.add(SystemAccess::Kind::resource, resource_id<T>(), name_of<T>(), false);
    }
    static void prepare(State&, World&) {}
    static Res<T> get(State&, const RunContext& c) {
        const T* value = c.world.try_resource<T>();
        if (!value) {
            throw_system_needs(c.system, name_of<T>());
        }
        return {*value, c.world.resource_changed<T>(c.ticks.since)};
    }
};

template <class T>
struct Param<ResMut<T>> {
    static constexpr bool kQuery = false;
    using State = NoState;
    static void declare(SystemAccess& access) {
        access.add(SystemAccess::Kind::resource, resource_id<T>(), name_of<T>(), true);
    }
    static void prepare(State&, World&) {}
    static ResMut<T> get(State&, const RunContext& c) {
        Tick* changed = nullptr;
        T* value = c.world.find_resource_mut<T>(&changed);
        if (!value) {
            throw_system_needs(c.system, name_of<T>());
        }
        return {*value, *changed, c.ticks};
    }
};

template <class T>
struct Param<EventReader<T>> {
    static constexpr bool kQuery = false;
    struct State {
        const Events<T>* events = nullptr;
        std::uint64_t cursor = 0;
    };
    static void declare(SystemAccess& access) {
        access.add(SystemAccess::Kind::events, event_id<T>(), name_of<T>(), false);
    }
    static void prepare(State& state, World& world) { state.events = &world.events<T>(); }
    static EventReader<T> get(State& state, const RunContext&) { return {*state.events, state.cursor}; }
};

template <class T>
struct Param<EventWriter<T>> {
    static constexpr bool kQuery = false;
    struct State {
        Events<T>* events = nullptr;
    };
    static void declare(SystemAccess& access) {
        access.add(SystemAccess::Kind::events, event_id<T>(), name_of<T>(), true);
    }
    static void prepare(State& state, World& world) { state.events = &world.events<T>(); }
    static EventWriter<T> get(State& state, const RunContext&) { return EventWriter<T>(*state.events); }
};

template <>
struct Param<Commands&> {
    static constexpr bool kQuery = false;
    using State = NoState;
    static void declare(SystemAccess& access) { access.commands = true; }
    static void prepare(State&, World&) {}
    static Commands& get(State&, const RunContext& c) { return *c.commands; }
};

template <>
struct Param<SystemTicks> {
    static constexpr bool kQuery = false;
    using State = NoState;
    static void declare(SystemAccess&) {}
    static void prepare(State&, World&) {}
    static SystemTicks get(State&, const RunContext& c) { return c.ticks; }
};

template <>
struct Param<World&> {
    static constexpr bool kQuery = false;
    using State = NoState;
    static void declare(SystemAccess& access) { access.exclusive = true; }
    static void prepare(State&, World&) {}
    static World& get(State&, const RunContext& c) { return c.world; }
};

class SystemBase {
  public:
    virtual ~SystemBase() = default;
    virtual void declare(SystemAccess& access) const = 0;
    virtual void prepare(World& world) = 0;
    // Each query has a match.
    virtual bool matches(const RunContext& context) = 0;
    virtual void run(const RunContext& context) = 0;
    // One query and nothing else.
    virtual bool only_a_query() const = 0;
    // State that belongs to one world is forgotten.
    virtual void reset() = 0;
};

template <class Fn, class... Params>
class System final : public SystemBase {
  public:
    explicit System(Fn fn) : fn_(std::move(fn)) {}
    void declare(SystemAccess& access) const override { (Param<Params>::declare(access), ...); }
    void prepare(World& world) override {
        std::apply([&](auto&... s) { (Param<Params>::prepare(s, world), ...); }, states_);
    }
    bool matches(const RunContext& context) override {
        return std::apply([&](auto&... s) { return (has_match<Params>(s, context) && ...); }, states_);
    }
    void run(const RunContext& context) override {
        std::apply([&](auto&... s) { std::invoke(fn_, Param<Params>::get(s, context)...); }, states_);
    }
    bool only_a_query() const override { return sizeof...(Params) == 1 && (Param<Params>::kQuery && ...); }
    void reset() override { states_ = {}; }

  private:
    template <class P>
    static bool has_match(typename Param<P>::State& state, const RunContext& context) {
        if constexpr (Param<P>::kQuery) {
            return !Param<P>::get(state, context).empty();
        } else {
            return true;
        }
    }

    Fn fn_;
    std::tuple<typename Param<Params>::State...> states_;
};

template <class T>
using ParamOf = std::conditional_t<std::is_reference_v<T> && !std::is_const_v<std::remove_reference_t<T>>, T,
                                   std::remove_cvref_t<T>>;

template <class Fn, class Signature>
struct SystemOf;
template <class Fn, class R, class... Args>
struct SystemOf<Fn, R (*)(Args...)> {
    using type = System<Fn, ParamOf<Args>...>;
};
template <class Fn, class R, class C, class... Args>
struct SystemOf<Fn, R (C::*)(Args...)> : SystemOf<Fn, R (*)(Args...)> {};
template <class Fn, class R, class C, class... Args>
struct SystemOf<Fn, R (C::*)(Args...) const> : SystemOf<Fn, R (*)(Args...)> {};
template <class Fn, class R, class... Args>
struct SystemOf<Fn, R (*)(Args...) noexcept> : SystemOf<Fn, R (*)(Args...)> {};
template <class Fn, class R, class C, class... Args>
struct SystemOf<Fn, R (C::*)(Args...) noexcept> : SystemOf<Fn, R (*)(Args...)> {};
template <class Fn, class R, class C, class... Args>
struct SystemOf<Fn, R (C::*)(Args...) const noexcept> : SystemOf<Fn, R (*)(Args...)> {};

template <class Fn>
std::unique_ptr<SystemBase> make_system(Fn fn) {
    if constexpr (std::is_pointer_v<Fn>) {
        return std::make_unique<typename SystemOf<Fn, Fn>::type>(std::move(fn));
    } else {
        return std::make_unique<typename SystemOf<Fn, decltype(&Fn::operator())>::type>(std::move(fn));
    }
}

}  // namespace detail
}  // namespace lanthorn::ecs
