// bench_ecs --table: one table, beside EnTT where a copy is given. Else Google Benchmark's options.
#include <benchmark/benchmark.h>

#include <string_view>

#include "tests/bench/ecs/contender.h"

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == "--table") {
        lanthorn::ecs::print_table();
        return 0;
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
