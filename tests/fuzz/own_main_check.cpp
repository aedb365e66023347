// Targets that do wrong on purpose, under own_main.cpp: check_own_main.sh looks at what becomes of them.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "tests/fuzz/target.h"

namespace lanthorn::fuzz {

namespace {

std::vector<std::string> one_seed() {
    return {"seed"};
}

void refuse_b(std::string_view input) {
    if (input == "b") {
        throw Finding("b");
    }
    if (input == "c") {
        std::raise(SIGSEGV);
    }
}

void wait_for_ever(std::string_view) {
    std::this_thread::sleep_for(std::chrono::hours(1));
}

void work_for_ever(std::string_view input) {
    volatile std::size_t sum = 0;
    while (!input.empty()) {
        sum = sum + input.size();
    }
}

void leak(std::string_view input) {
    volatile char sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const char* lost = static_cast<char*>(std::calloc(1000 + input.size(), 1));
        sum = static_cast<char>(sum + lost[i]);
    }
}

void take_memory(std::string_view) {
    std::vector<char> bytes(200u << 20u, 'x');
    volatile char last = bytes.back();
    static_cast<void>(last);
}

void keep_once(std::string_view) {
    static const std::string kept(1000, 'k');
    static_cast<void>(kept);
}

constexpr Target kTargets[] = {
    {"refuses", "some inputs end it", refuse_b, one_seed, nullptr},
    {"waits", "without processor time", wait_for_ever, one_seed, nullptr},
    {"works", "with it", work_for_ever, one_seed, nullptr},
    {"leaks", "blocks of memory", leak, one_seed, nullptr},
    {"takes", "200 MB", take_memory, one_seed, nullptr},
    {"sound", "nothing wrong", keep_once, one_seed, nullptr},
};

}  // namespace

std::span<const Target> targets() {
    return kTargets;
}

}  // namespace lanthorn::fuzz
