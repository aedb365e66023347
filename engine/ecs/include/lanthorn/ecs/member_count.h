// How many members an aggregate has, counted by the compiler: the most initialisers that braces take.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

namespace lanthorn::ecs {

namespace detail {

struct AnyMember {
    template <class U>
    operator U() const;
};

template <class T, std::size_t... I>
constexpr bool takes(std::index_sequence<I...>) {
    return requires {
        T{(static_cast<void>(I), AnyMember{})...};
    };
}

template <class T, std::size_t N>
constexpr std::size_t count_members() {
    constexpr bool one_more = takes<T>(std::make_index_sequence<N + 1>{});
    if constexpr (one_more || !takes<T>(std::make_index_sequence<N>{})) {
        return count_members<T, N + 1>();
    } else {
        return N;
    }
}

}  // namespace detail

// Base classes count as a member each, elements of C arrays one by one (use std::array).
template <class T>
requires std::is_aggregate_v<T>
inline constexpr std::size_t kMemberCount = detail::count_members<T, 0>();

}  // namespace lanthorn::ecs
