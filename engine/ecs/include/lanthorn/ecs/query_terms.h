// What a query may ask for.
//
//   Read<T>             const T&          the entity must have a T
//   Write<T>            T&                likewise; every visited row counts as changed
//   Mut<T>              MutRef<T>         likewise; only rows on which write() was called count as changed
//   Optional<Read<T>>   const T*          null without T; likewise Optional<Write<T>>: T*
//   With<Ts...>         -                 must have all
//   Without<Ts...>      -                 must have none
//   Changed<Ts...>      -                 has one of them that was written or added since the query's tick
//   Added<Ts...>        -                 likewise, that was added
#pragma once

#include <algorithm>
#include <span>
#include <tuple>

#include "lanthorn/ecs/archetype.h"

namespace lanthorn::ecs {

template <class T>
struct Read {};
template <class T>
struct Write {};
template <class T>
struct Mut {};
template <class Term>
struct Optional {};
template <class... Ts>
struct With {};
template <class... Ts>
struct Without {};
template <class... Ts>
struct Changed {};
template <class... Ts>
struct Added {};

// A component that notes the write only if there is one.
template <class T>
class MutRef {
  public:
    MutRef(T* value, RowTick* changed, ChunkTicks* ticks, RowTick now)
        : value_(value), changed_(changed), ticks_(ticks), now_(now) {}

    const T& read() const { return *value_; }  // the row does not count as changed
    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_; }
    // The row counts as changed now.
    T& write() const {
        *changed_ = now_;
        ticks_->max_changed = std::max(ticks_->max_changed, now_);
        return *value_;
    }
    // Writes only what differs, so that nothing is reported as changed that is not.
    bool set_if_different(const T& value) const {
        if (*value_ == value) {
            return false;
        }
        write() = value;
        return true;
    }

  private:
    T* value_;
    RowTick* changed_;
    ChunkTicks* ticks_;
    RowTick now_;
};

namespace detail {

enum class TermKind { data, optional, with, without, changed, added };

// One chunk's column as a term sees it.
template <class T>
struct ReadFetch {
    const T* data;
    void open(std::byte* chunk, const Archetype::Column* c, RowTick) {
        data = c ? reinterpret_cast<const T*>(chunk + c->data) : nullptr;
    }
    const T& at(std::uint32_t i) const { return data[i]; }
    std::span<const T> span(std::uint32_t n) const { return {data, data ? n : 0}; }
    static constexpr bool kWrites = false;
    void mark_all() const {}
    void mark(std::uint32_t) const {}
};

template <class T>
struct WriteFetch {
    T* data;
    RowTick* changed;
    ChunkTicks* ticks;
    RowTick now;
    void open(std::byte* chunk, const Archetype::Column* c, RowTick tick) {
        data = c ? reinterpret_cast<T*>(chunk + c->data) : nullptr;
        changed = c ? Archetype::changed(chunk, *c) : nullptr;
        ticks = c ? &Archetype::ticks(chunk, *c) : nullptr;
        now = tick;
    }
    T& at(std::uint32_t i) const { return data[i]; }
    std::span<T> span(std::uint32_t n) const { return {data, data ? n : 0}; }
    static constexpr bool kWrites = true;
    void mark_all() const {
        if (!ticks) {
            return;
        }
        ticks->bulk_changed = now;
        ticks->max_changed = now;
    }
    void mark(std::uint32_t i) const {
        if (!ticks) {
            return;
        }
        changed[i] = now;
        ticks->max_changed = now;
    }
};

template <class T>
struct MutFetch : WriteFetch<T> {
    MutRef<T> at(std::uint32_t i) const {
        return {this->data + i, this->changed + i, this->ticks, this->now};
    }
    void mark_all() const {}
    void mark(std::uint32_t) const {}
};

template <class Fetch>
struct OptionalFetch : Fetch {
    auto at(std::uint32_t i) const { return this->data ? this->data + i : nullptr; }
};

template <class Term>
struct TermTraits;

template <class T>
struct TermTraits<Read<T>> {
    static constexpr TermKind kKind = TermKind::data;
    using Types = std::tuple<T>;
    using Fetch = ReadFetch<T>;
};
template <class T>
struct TermTraits<Write<T>> {
    static constexpr TermKind kKind = TermKind::data;
    using Types = std::tuple<T>;
    using Fetch = WriteFetch<T>;
};
template <class T>
struct TermTraits<Mut<T>> {
    static constexpr TermKind kKind = TermKind::data;
    using Types = std::tuple<T>;
    using Fetch = MutFetch<T>;
};
template <class Term>
struct TermTraits<Optional<Term>> {
    static_assert(TermTraits<Term>::kKind == TermKind::data, "Optional takes Read or Write");
    static constexpr TermKind kKind = TermKind::optional;
    using Types = typename TermTraits<Term>::Types;
    using Fetch = OptionalFetch<typename TermTraits<Term>::Fetch>;
};
template <class T>
struct TermTraits<Optional<Mut<T>>> {
    static_assert(sizeof(T) == 0, "Optional takes Read or Write");
};
template <class... Ts>
struct TermTraits<With<Ts...>> {
    static constexpr TermKind kKind = TermKind::with;
    using Types = std::tuple<Ts...>;
};
template <class... Ts>
struct TermTraits<Without<Ts...>> {
    static constexpr TermKind kKind = TermKind::without;
    using Types = std::tuple<Ts...>;
};
template <class... Ts>
struct TermTraits<Changed<Ts...>> {
    static constexpr TermKind kKind = TermKind::changed;
    using Types = std::tuple<Ts...>;
};
template <class... Ts>
struct TermTraits<Added<Ts...>> {
    static constexpr TermKind kKind = TermKind::added;
    using Types = std::tuple<Ts...>;
};

template <class Term>
inline constexpr TermKind kKind = TermTraits<Term>::kKind;
template <class Term>
inline constexpr bool kIsData = kKind<Term> == TermKind::data || kKind<Term> == TermKind::optional;
// The term hands out nothing that can be written.
template <class Term>
inline constexpr bool kTermReads = [] {
    if constexpr (kIsData<Term>) {
        return !TermTraits<Term>::Fetch::kWrites;
    } else {
        return true;
    }
}();
template <class... Terms>
inline constexpr bool kReadOnly = (kTermReads<Terms> && ...);
template <class Term>
inline constexpr bool kIsRowFilter = kKind<Term> == TermKind::changed || kKind<Term> == TermKind::added;

// The terms that hand out data, as a tuple of terms.
template <class... Terms>
using DataTerms =
    decltype(std::tuple_cat(std::conditional_t<kIsData<Terms>, std::tuple<Terms>, std::tuple<>>{}...));
template <class... Terms>
using RowFilters =
    decltype(std::tuple_cat(std::conditional_t<kIsRowFilter<Terms>, std::tuple<Terms>, std::tuple<>>{}...));

}  // namespace detail
}  // namespace lanthorn::ecs
