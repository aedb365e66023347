// Query: all entities that have (or lack) certain components.
//
//   world.query<Write<Position>, Read<Velocity>, Without<Frozen>>().each([](Position& p, const Velocity& v) {
//   ... });
//
// The function takes the terms' data in their order, and the Entity first if it wants it. Order of visit:
// tables in the order of their making, rows in the order of their storage; the same in every run. Structural
// changes throw while iterating. A query is cheap to make (one look at each table) and stays valid; it sees
// tables made after it only when made again. KeptQuery (kept_query.h) saves the looking. A const World
// answers queries whose terms only read.
#pragma once

#include <type_traits>

#include "lanthorn/ecs/parallel.h"
#include "lanthorn/ecs/query_terms.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::ecs {

namespace detail {

// A table that fits, and where it keeps the terms' components (one entry a component type named by any term).
template <std::size_t N>
struct Match {
    Archetype* archetype;
    std::array<const Archetype::Column*, N == 0 ? 1 : N> columns;
};

template <class... Terms>
struct QueryState {
    static constexpr std::size_t kTypes =
        (std::size_t{0} + ... + std::tuple_size_v<typename TermTraits<Terms>::Types>);
    std::vector<Match<kTypes>> matches;
    std::size_t seen = 0;  // tables looked at

    // Looks at the tables made since the last time.
    void update(const World& world) {
        const auto& tables = world.archetypes();
        for (; seen < tables.size(); ++seen) {
            Match<kTypes> match{tables[seen].get(), {}};
            std::size_t at = 0;
            if ((fits<Terms>(match, at, static_cast<typename TermTraits<Terms>::Types*>(nullptr)) && ...)) {
                matches.push_back(match);
            }
        }
    }

  private:
    template <class Term, class... Ts>
    static bool fits(Match<kTypes>& match, std::size_t& at, std::tuple<Ts...>*) {
        const Archetype& a = *match.archetype;
        std::size_t found = 0;
        const auto look = [&](TypeId id) {
            const int column = a.column(id);
            match.columns[at++] =
                column == Archetype::kNoColumn ? nullptr : &a.columns()[static_cast<std::size_t>(column)];
            found += column != Archetype::kNoColumn;
        };
        (look(component_info<Ts>().id), ...);
        switch (kKind<Term>) {
            case TermKind::data:
            case TermKind::with:
                return found == sizeof...(Ts);
            case TermKind::without:
                return found == 0;
            case TermKind::optional:
                return true;
            case TermKind::changed:
            case TermKind::added:
                return found > 0;
        }
        return false;
    }
};

}  // namespace detail

// All entities that fit its terms, with their components.
template <class... Terms>
class Query {
    using State = detail::QueryState<Terms...>;
    using Match = detail::Match<State::kTypes>;
    using Data = detail::DataTerms<Terms...>;
    static constexpr bool kFiltersRows = (detail::kIsRowFilter<Terms> || ...);
    template <class Tuple>
    struct FetchesOf;
    template <class... Ts>
    struct FetchesOf<std::tuple<Ts...>> {
        using type = std::tuple<typename detail::TermTraits<Ts>::Fetch...>;
    };
    using Fetches = typename FetchesOf<Data>::type;
    static constexpr std::size_t kData = std::tuple_size_v<Data>;

  public:
    // Of the world as it is now. Writes are dated `now`, Changed and Added compare with `since`.
    Query(World& world, Tick since, Tick now)
        : world_(&world), since_(world.relative(since)), now_(world.row_tick(now)) {
        own_.update(world);
    }
    Query(const World& world, Tick since, Tick now) requires detail::kReadOnly<Terms...>
        : world_(&world), since_(world.relative(since)), now_(world.row_tick(now)) {
        own_.update(world);
    }
    // With matches kept elsewhere (a system's, or a KeptQuery's).
    Query(World& world, const State& state, Tick since, Tick now)
        : world_(&world), kept_(&state), since_(world.relative(since)), now_(world.row_tick(now)) {}
    Query(const World& world, const State& state, Tick since, Tick now) requires detail::kReadOnly<Terms...>
        : world_(&world), kept_(&state), since_(world.relative(since)), now_(world.row_tick(now)) {}

    // Calls fn for every entity that fits, one after another on this thread. Rows of a Write count as
    // changed.
    template <class Fn>
    void each(Fn&& fn) const {
        const World::Lock lock(*world_);
        for (const Match& match : matches()) {
            for (std::uint32_t c = 0; c < match.archetype->chunk_count(); ++c) {
                visit(match, c, fn);
            }
        }
    }

    // Like each, chunks in parallel on oneTBB; fn must not depend on other rows, nor on the order. Commands
    // and events refuse to be written by fn (Error): their order would differ from run to run.
    template <class Fn>
    void parallel_each(const Fn& fn) const {
        const World::Lock lock(*world_);
        std::vector<std::pair<const Match*, std::uint32_t>> work;
        for (const Match& match : matches()) {
            for (std::uint32_t c = 0; c < match.archetype->chunk_count(); ++c) {
                work.emplace_back(&match, c);
            }
        }
        detail::parallel_for(work.size(), [&](std::size_t i) {
            const detail::InParallelEach here;
            visit(*work[i].first, work[i].second, fn);
        });
    }

    // fn(std::span<const Entity>, spans...) or fn(spans...) once a chunk: const spans for Read, empty ones
    // for an Optional that is missing. All rows of a Write count as changed.
    template <class Fn>
    void each_chunk(Fn&& fn) const {
        static_assert(!kFiltersRows, "Changed and Added choose rows, each_chunk does not");
        const World::Lock lock(*world_);
        for (const Match& match : matches()) {
            for (std::uint32_t c = 0; c < match.archetype->chunk_count(); ++c) {
                const Fetches fetches = open(match, c);
                const std::uint32_t n = match.archetype->chunk_rows(c);
                const std::span<const Entity> entities(Archetype::entities(match.archetype->chunk(c)), n);
                std::apply(
                    [&](const auto&... f) {
                        (f.mark_all(), ...);
                        if constexpr (std::is_invocable_v<Fn&, std::span<const Entity>,
                                                          decltype(f.span(n))...>) {
                            fn(entities, f.span(n)...);
                        } else {
                            fn(f.span(n)...);
                        }
                    },
                    fetches);
            }
        }
    }

    // Number of entities. O(tables), or O(rows) with Changed or Added.
    std::size_t count() const {
        std::size_t n = 0;
        scan([&](const Match&, std::uint32_t, std::uint32_t rows) {
            n += rows;
            return true;
        });
        return n;
    }
    // No entity fits; stops at the first that does.
    bool empty() const {
        bool none = true;
        scan([&](const Match&, std::uint32_t, std::uint32_t rows) { return none = rows == 0; });
        return none;
    }
    // The entities, in the order of each().
    std::vector<Entity> entities() const {
        std::vector<Entity> all;
        all.reserve(count());
        for (const Match& match : matches()) {
            for (std::uint32_t c = 0; c < match.archetype->chunk_count(); ++c) {
                const Filter filter(*this, match, c);
                if (!filter.any()) {
                    continue;
                }
                const Entity* e = Archetype::entities(match.archetype->chunk(c));
                for (std::uint32_t i = 0; i < match.archetype->chunk_rows(c); ++i) {
                    if (filter(i)) {
                        all.push_back(e[i]);
                    }
                }
            }
        }
        return all;
    }

    // The data of one entity as a tuple of what each() hands out: auto [p, v] = query.get(e). Throws if the
    // entity is dead or the query does not match it.
    auto get(Entity e) const {
        const auto [match, row] = find(e);
        if (!match) {
            if (!world_->alive(e)) {
                World::throw_dead("query", e);
            }
            throw Error("query: " + to_string(e) + " does not match " + describe());
        }
        return at_row(*match, row);
    }
    bool contains(Entity e) const { return find(e).first != nullptr; }  // alive and fits; O(tables)

    // The only entity that matches: its data as get() gives it; throws unless there is exactly one.
    auto single() const { return get(single_entity()); }
    // The only entity that matches; throws an Error unless there is exactly one. O(entities).
    Entity single_entity() const {
        const std::vector<Entity> all = entities();
        if (all.size() != 1) {
            throw Error("query " + describe() + ": expected exactly one entity, found " +
                        std::to_string(all.size()));
        }
        return all.front();
    }

    // Its terms: "<Write<Position>, Read<Velocity>>".
    static std::string describe() {
        std::string text;
        ((text += (text.empty() ? "<" : ", ") + short_name<Terms>()), ...);
        return text + ">";
    }

  private:
    // Which rows of a chunk pass Changed and Added.
    class Filter {
      public:
        Filter(const Query& query, const Match& match, std::uint32_t chunk) : since_(query.since_) {
            if constexpr (kFiltersRows) {
                chunk_ = match.archetype->chunk(chunk);
                match_ = &match;
            }
        }
        bool any() const {
            return check([this](const Archetype::Column& c, bool added) {
                const ChunkTicks& t = Archetype::ticks(chunk_, c);
                return (added ? t.max_added : t.max_changed) > since_;
            });
        }
        bool operator()(std::uint32_t i) const {
            return check([this, i](const Archetype::Column& c, bool added) {
                if (added) {
                    return Archetype::added(chunk_, c)[i] > since_;
                }
                return Archetype::changed(chunk_, c)[i] > since_ ||
                       Archetype::ticks(chunk_, c).bulk_changed > since_;
            });
        }

      private:
        template <class Test>
        bool check(const Test& test) const {
            if constexpr (!kFiltersRows) {
                return true;
            }
            std::size_t at = 0;
            return (check_term<Terms>(test, at) && ...);
        }
        template <class Term, class Test>
        bool check_term(const Test& test, std::size_t& at) const {
            constexpr std::size_t n = std::tuple_size_v<typename detail::TermTraits<Term>::Types>;
            const std::size_t first = at;
            at += n;
            if constexpr (detail::kIsRowFilter<Term>) {
                constexpr bool added = detail::kKind<Term> == detail::TermKind::added;
                for (std::size_t k = first; k < first + n; ++k) {
                    if (match_->columns[k] && test(*match_->columns[k], added)) {
                        return true;
                    }
                }
                return false;
            }
            return true;
        }
        std::byte* chunk_ = nullptr;
        const Match* match_ = nullptr;
        std::int64_t since_;
    };

    const std::vector<Match>& matches() const { return kept_ ? kept_->matches : own_.matches; }

    Fetches open(const Match& match, std::uint32_t chunk) const {
        Fetches fetches;
        std::size_t column = 0;
        open_terms<0, Terms...>(fetches, match, match.archetype->chunk(chunk), column);
        return fetches;
    }
    template <std::size_t D, class Term, class... Rest>
    void open_terms(Fetches& fetches, const Match& match, std::byte* chunk, std::size_t& column) const {
        const std::size_t here = column;
        column += std::tuple_size_v<typename detail::TermTraits<Term>::Types>;
        constexpr std::size_t next = D + (detail::kIsData<Term> ? 1 : 0);
        if constexpr (detail::kIsData<Term>) {
            std::get<D>(fetches).open(chunk, match.columns[here], now_);
        }
        if constexpr (sizeof...(Rest) > 0) {
            open_terms<next, Rest...>(fetches, match, chunk, column);
        }
    }

    template <class Fn>
    void visit(const Match& match, std::uint32_t chunk, Fn& fn) const {
        const std::uint32_t n = match.archetype->chunk_rows(chunk);
        const Entity* entities = Archetype::entities(match.archetype->chunk(chunk));
        const Fetches fetches = open(match, chunk);
        if constexpr (kFiltersRows) {
            const Filter filter(*this, match, chunk);
            if (!filter.any()) {
                return;
            }
            std::apply(
                [&](const auto&... f) {
                    for (std::uint32_t i = 0; i < n; ++i) {
                        if (!filter(i)) {
                            continue;
                        }
                        (f.mark(i), ...);
                        call(fn, entities[i], f.at(i)...);
                    }
                },
                fetches);
        } else {
            std::apply(
                [&](const auto&... f) {
                    (f.mark_all(), ...);
                    rows(fn, n, entities, f...);
                },
                fetches);
        }
    }
    // By value, so that the compiler knows that no write in fn alters the columns' addresses.
    template <class Fn, class... Fetch>
    static void rows(Fn& fn, std::uint32_t n, const Entity* entities, Fetch... f) {
        for (std::uint32_t i = 0; i < n; ++i) {
            call(fn, entities[i], f.at(i)...);
        }
    }
    template <class Fn, class... Args>
    static void call(Fn& fn, Entity e, Args&&... args) {
        if constexpr (std::is_invocable_v<Fn&, Entity, Args...>) {
            fn(e, std::forward<Args>(args)...);
        } else {
            static_assert(std::is_invocable_v<Fn&, Args...>,
                          "the function must take the query's data, Entity first if at all");
            fn(std::forward<Args>(args)...);
        }
    }

    // Calls fn(match, chunk, passing rows) until it returns false.
    template <class Fn>
    void scan(Fn&& fn) const {
        for (const Match& match : matches()) {
            for (std::uint32_t c = 0; c < match.archetype->chunk_count(); ++c) {
                std::uint32_t n = match.archetype->chunk_rows(c);
                if constexpr (kFiltersRows) {
                    const Filter filter(*this, match, c);
                    if (!filter.any()) {
                        continue;
                    }
                    const std::uint32_t all = n;
                    n = 0;
                    for (std::uint32_t i = 0; i < all; ++i) {
                        n += filter(i);
                    }
                }
                if (!fn(match, c, n)) {
                    return;
                }
            }
        }
    }

    std::pair<const Match*, std::uint32_t> find(Entity e) const {
        const World::Row r = world_->row_of(e);
        if (!r) {
            return {nullptr, 0};
        }
        for (const Match& match : matches()) {
            if (match.archetype != r.archetype) {
                continue;
            }
            const std::uint32_t per = match.archetype->rows_per_chunk();
            const Filter filter(*this, match, r.row / per);
            if (kFiltersRows && !filter(r.row % per)) {
                break;
            }
            return {&match, r.row};
        }
        return {nullptr, 0};
    }
    auto at_row(const Match& match, std::uint32_t row) const {
        const std::uint32_t per = match.archetype->rows_per_chunk();
        const Fetches fetches = open(match, row / per);
        const std::uint32_t i = row % per;
        return std::apply(
            [i](const auto&... f) {
                (f.mark(i), ...);
                return std::tuple<decltype(f.at(i))...>(f.at(i)...);
            },
            fetches);
    }

    template <class Term>
    static std::string short_name() {
        std::string name(name_of<Term>());
        for (const std::string_view prefix : {"lanthorn::ecs::"}) {
            for (std::size_t at = name.find(prefix); at != std::string::npos; at = name.find(prefix)) {
                name.erase(at, prefix.size());
            }
        }
        return name;
    }

    const World* world_;
    const State* kept_ = nullptr;
    State own_;
    std::int64_t since_;
    RowTick now_;
};

template <class... Terms>
Query<Terms...> World::query(Tick since) {
    return Query<Terms...>(*this, since, tick_);
}

template <class... Terms>
Query<Terms...> World::query(Tick since) const requires detail::kReadOnly<Terms...> {
    return Query<Terms...>(*this, since, tick_);
}

}  // namespace lanthorn::ecs
