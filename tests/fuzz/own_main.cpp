// The targets under a fuzzer of our own, where clang and its libFuzzer are missing. It takes those of
// libFuzzer's arguments that tools/fuzz gives, and prints as it does: every second a line of how far it is.
//
//   lanthorn_fuzz -max_total_time=SECONDS -seed=N -artifact_prefix=FOLDER/ CORPUS [MORE]
//
// Inputs of all folders are run first; new interesting ones go into CORPUS. A child does the work: if it
// dies, its input is a finding, and another goes on. Exit codes: 0 nothing found, 1 found something.
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/coverage.h"
#include "tests/fuzz/driver.h"
#include "tests/fuzz/target.h"
#include "tests/unit/tools/run_program.h"

namespace {

using namespace lanthorn;
using namespace lanthorn::fuzz;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr long kMostSeconds = 20;  // of processor time, an input: a busy machine is no finding
constexpr std::size_t kMostBytes = 1u << 20u;

struct Work {
    const Target* target = nullptr;
    std::vector<fs::path> folders;
    std::string findings;
    double seconds = 60;
    std::uint64_t seed = 1;
    Clock::time_point start = Clock::now();

    double elapsed() const { return std::chrono::duration<double>(Clock::now() - start).count(); }
};

volatile std::sig_atomic_t stopped = 0;

std::string name_of(std::string_view bytes) {
    char name[17];
    std::snprintf(name, sizeof name, "%016zx", std::hash<std::string_view>()(bytes));
    return name;
}

void write(const fs::path& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string damaged(const std::string& input, const Target& target, Mutator& mutator) {
    std::string result =
        target.damage != nullptr && mutator.below(2) == 0 ? target.damage(input, mutator) : std::string();
    if (result.empty()) {
        result = input;
        mutator.damage_bytes(result);
    }
    return result;
}

// SIGPROF ends the process after that much processor time; 0: never.
void limit_time(long seconds) {
    const itimerval limit = {{0, 0}, {seconds, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
}

// The child: runs inputs until the time is over; `current` always holds the one at work.
[[noreturn]] void run_inputs(const Work& work, const fs::path& current, std::uint64_t round) {
    std::signal(SIGINT, SIG_IGN);  // the parent's to answer
    CoverageMap seen{};
    std::vector<std::string> corpus;
    std::uint64_t count = 0;
    const auto run = [&](const std::string& input) {
        write(current, input);
        limit_time(kMostSeconds);
        begin_coverage();
        try {
            run_target(*work.target, input);
        } catch (const std::exception& finding) {
            std::fprintf(stderr, "FINDING: %s\n", finding.what());
            std::_Exit(1);
        }
        limit_time(0);
        ++count;
        return add_coverage(seen);
    };
    for (const fs::path& folder : work.folders) {
        for (const auto& entry : fs::directory_iterator(folder)) {
            corpus.push_back(testing_tools::file_bytes(entry.path()));
            run(corpus.back());
        }
    }
    Mutator mutator(work.seed * 1000003 + round);
    double told = work.elapsed();
    while (work.elapsed() < work.seconds && !corpus.empty() && getppid() != 1) {
        const std::string input = damaged(corpus[mutator.below(corpus.size())], *work.target, mutator);
        if (input.size() <= kMostBytes && run(input)) {
            write(work.folders.front() / name_of(input), input);
            corpus.push_back(input);
        }
        if (work.elapsed() > told + 1) {
            told = work.elapsed();
            std::fprintf(stderr, "#%llu: corp: %zu time: %.0fs\n", static_cast<unsigned long long>(count),
                         corpus.size(), told);
        }
    }
    std::fprintf(stderr, "#%llu: corp: %zu time: %.0fs\n", static_cast<unsigned long long>(count),
                 corpus.size(), work.elapsed());
    std::_Exit(0);
}

Work parsed(int argc, char** argv) {
    Work work;
    work.target = chosen_target();
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument = argv[i];
        const std::string value(argument.substr(std::min(argument.find('=') + 1, argument.size())));
        if (argument.starts_with("-max_total_time=")) {
            work.seconds = std::atof(value.c_str());
        } else if (argument.starts_with("-seed=")) {
            work.seed = std::strtoull(value.c_str(), nullptr, 10);
        } else if (argument.starts_with("-artifact_prefix=")) {
            work.findings = value;
        } else if (!argument.starts_with("-")) {
            work.folders.emplace_back(argument);
        }
    }
    return work;
}

}  // namespace

int main(int argc, char** argv) {
    if (answered(argc, argv)) {
        return 0;
    }
    const Work work = parsed(argc, argv);
    if (work.target == nullptr || work.folders.empty()) {
        std::fputs("usage: LANTHORN_FUZZ_TARGET=NAME lanthorn_fuzz [-OPTION=VALUE] CORPUS [MORE]\n", stderr);
        return 2;
    }
    std::signal(SIGINT, [](int) { stopped = 1; });
    const testing_tools::TemporaryFolder folder;
    const fs::path current = folder.path("current");
    int found = 0;
    for (std::uint64_t round = 0; work.elapsed() < work.seconds && stopped == 0; ++round) {
        const pid_t child = fork();
        if (child == 0) {
            run_inputs(work, current, round);
        }
        int status = 0;
        while (waitpid(child, &status, 0) < 0) {
            if (stopped != 0) {
                kill(child, SIGKILL);
            }
        }
        if (status != 0 && stopped == 0) {
            const std::string input = testing_tools::file_bytes(current.string());
            const bool slow = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF;
            write(work.findings + (slow ? "timeout-" : "crash-") + name_of(input), input);
            ++found;
        }
    }
    return found > 0 ? 1 : 0;
}
