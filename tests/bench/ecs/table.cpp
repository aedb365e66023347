#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <vector>

#include "tests/bench/ecs/contender.h"
#include "tests/support/median.h"

namespace lanthorn::ecs {
namespace {

constexpr std::array<const char*, 5> kWork = {"create", "iterate", "random access", "add, remove", "destroy"};
constexpr std::size_t kEntitiesInAll = 10'000'000;  // of a row's rounds

struct Column {
    const char* name;
    std::unique_ptr<Contender> (*make)();
    std::array<std::vector<double>, kWork.size()> times;  // ns an entity, a round each
};

// Of this thread, in ns: other programs disturb it less than the time of day.
double processor_time() {
    std::timespec t{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e9 + static_cast<double>(t.tv_nsec);
}

// One round: each work once, on a world of its own.
void run(Column& column, std::size_t count) {
    const std::unique_ptr<Contender> contender = column.make();
    const auto time = [&](std::size_t work, const auto& fn) {
        const double start = processor_time();
        fn();
        column.times[work].push_back((processor_time() - start) / static_cast<double>(count));
    };
    time(0, [&] { contender->create(count); });
    contender->iterate();  // what is prepared for it once
    time(1, [&] { contender->iterate(); });
    contender->shuffle();
    time(2, [&] { benchmark::DoNotOptimize(contender->get_in_random_order()); });
    time(3, [&] { contender->add_and_remove(); });
    time(4, [&] { contender->destroy(); });
}

}  // namespace

void print_table() {
    std::printf("Nanoseconds of processor time an entity, medians of rounds by turns\n\n%-9s %-14s",
                "entities", "");
    std::vector<Column> columns;
    columns.push_back({"Lanthorn", make_lanthorn, {}});
#ifdef LANTHORN_ENTT
    columns.push_back({"EnTT", make_entt, {}});
#endif
    for (const Column& column : columns) {
        std::printf(" %9s", column.name);
    }
    std::printf("\n");
    for (const std::size_t count : {std::size_t{10'000}, std::size_t{100'000}, std::size_t{1'000'000}}) {
        const std::size_t rounds = std::min<std::size_t>(kEntitiesInAll / count, 101);
        for (std::size_t round = 0; round < rounds; ++round) {
            for (std::size_t i = 0; i < columns.size(); ++i) {
                run(columns[(round + i) % columns.size()], count);
            }
        }
        for (std::size_t work = 0; work < kWork.size(); ++work) {
            std::printf("%-9zu %-14s", count, kWork[work]);
            for (Column& column : columns) {
                std::printf(" %9.2f", support::median(column.times[work]));
                column.times[work].clear();
            }
            std::printf("\n");
        }
    }
}

}  // namespace lanthorn::ecs
