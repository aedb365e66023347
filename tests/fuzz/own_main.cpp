// The targets under a fuzzer of our own, where clang and its libFuzzer are missing. It takes those of
// libFuzzer's arguments that tools/fuzz gives, and prints as it does: every second a line of how far it is.
//
//   lanthorn_fuzz -max_total_time=SECONDS -seed=N -artifact_prefix=FOLDER/ -timeout=SECONDS -rss_limit_mb=N
//       CORPUS [MORE]
//
// Inputs of all folders are run first; new interesting ones go into CORPUS. A child does the work: if it
// dies, its input is a finding, and another goes on without it. With the address sanitizer an input that
// leaks is a finding too. Exit codes: 0 nothing found, 1 found something, 2 bad usage, 130 stopped by SIGINT
// before anything was found. With a file in the place of CORPUS it runs that alone, and says what is found.
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/coverage.h"
#include "tests/fuzz/driver.h"
#include "tests/fuzz/reading.h"
#include "tests/fuzz/target.h"
#include "tests/unit/tools/run_program.h"

// The address sanitizer's, where there is one.
extern "C" [[gnu::weak]] std::size_t __sanitizer_get_current_allocated_bytes();
extern "C" [[gnu::weak]] int __lsan_do_recoverable_leak_check();

namespace {

using namespace lanthorn;
using namespace lanthorn::fuzz;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr unsigned kWaiting = 5;  // times the processor time that an input may take, by the clock
constexpr std::size_t kMostBytes = 1u << 20u;

struct Work {
    const Target* target = nullptr;
    std::vector<fs::path> folders;
    std::string findings;
    double seconds = 60;
    std::uint64_t seed = 1;
    unsigned most_seconds = 20;  // of processor time, an input: a busy machine is no finding
    long most_megabytes = 4096;
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

// SIGPROF ends the process after that much processor time, SIGALRM if it waits for long; 0: never.
void limit_time(unsigned seconds) {
    const itimerval limit = {{0, 0}, {static_cast<time_t>(seconds), 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    alarm(kWaiting * seconds);
}

[[noreturn]] void end_with(const std::string& finding) {
    std::fprintf(stderr, "FINDING: %s\n", finding.c_str());
    std::_Exit(1);
}

std::size_t allocated() {
    return __sanitizer_get_current_allocated_bytes != nullptr ? __sanitizer_get_current_allocated_bytes() : 0;
}

// Runs it under the limits; ends the process with what it finds.
void run_limited(const Work& work, const std::string& input) {
    const std::size_t before = allocated();
    limit_time(work.most_seconds);
    try {
        run_target(*work.target, input);
    } catch (const std::exception& finding) {
        end_with(finding.what());
    }
    limit_time(0);
    // What is kept may be a cache: whether anything still knows of it takes longer to tell.
    if (allocated() > before && __lsan_do_recoverable_leak_check != nullptr &&
        __lsan_do_recoverable_leak_check() != 0) {
        end_with("it leaks");
    }
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    if (used.ru_maxrss > 1024 * work.most_megabytes) {
        end_with("more than " + std::to_string(work.most_megabytes) + " MB of memory");
    }
}

// The child: runs inputs until the time is over, without those `known` to end it; `current` always holds the
// one at work. `count`: inputs that all children have run.
[[noreturn]] void run_inputs(const Work& work, const std::set<std::string>& known, const fs::path& current,
                             std::uint64_t round, std::uint64_t& count) {
    std::signal(SIGINT, SIG_IGN);  // the parent's to answer
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    CoverageMap seen{};
    std::vector<std::string> corpus;
    const auto run = [&](const std::string& input) {
        write(current, input);
        begin_coverage();
        run_limited(work, input);
        ++count;
        return add_coverage(seen);
    };
    for (const fs::path& folder : work.folders) {
        for (const auto& entry : fs::directory_iterator(folder)) {
            const std::string input = testing_tools::file_bytes(entry.path());
            if (work.elapsed() < work.seconds && !known.contains(name_of(input))) {
                corpus.push_back(input);
                run(input);
            }
        }
    }
    Mutator mutator(work.seed * 1000003 + round);
    double told = work.elapsed();
    while (work.elapsed() < work.seconds && !corpus.empty()) {
        const std::string input = damaged(corpus[mutator.below(corpus.size())], *work.target, mutator);
        if (input.size() <= kMostBytes && !known.contains(name_of(input)) && run(input)) {
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

// The wait status of a child; Ctrl+C ends it.
int status_of(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (stopped != 0) {
            kill(child, SIGKILL);
        }
    }
    return status;
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
        } else if (argument.starts_with("-timeout=")) {
            work.most_seconds = static_cast<unsigned>(std::max(std::atoi(value.c_str()), 1));
        } else if (argument.starts_with("-rss_limit_mb=")) {
            work.most_megabytes = std::atol(value.c_str());
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
    if (fs::is_regular_file(work.folders.front())) {
        run_limited(work, testing_tools::file_bytes(work.folders.front()));
        return 0;
    }
    struct sigaction answer {};  // unlike std::signal's, it ends waiting
    answer.sa_handler = [](int) { stopped = 1; };
    sigaction(SIGINT, &answer, nullptr);
    const testing_tools::TemporaryFolder own;
    const fs::path current = own.path("current");
    std::set<std::string> known;
    void* shared =
        mmap(nullptr, sizeof(std::uint64_t), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) {
        std::perror("mmap");
        return 2;
    }
    for (std::uint64_t round = 0; work.elapsed() < work.seconds && stopped == 0; ++round) {
        // The children's folder is this process's, which removes it.
        for (const auto& left : fs::directory_iterator(folder())) {
            std::error_code ignored;
            fs::remove_all(left, ignored);
        }
        const pid_t child = fork();
        if (child == 0) {
            run_inputs(work, known, current, round, *static_cast<std::uint64_t*>(shared));
        }
        const int status = status_of(child);
        if (status == 0) {
            break;  // the time is over, or there is nothing to damage
        }
        if (stopped == 0) {
            const std::string input = testing_tools::file_bytes(current.string());
            const bool slow =
                WIFSIGNALED(status) && (WTERMSIG(status) == SIGPROF || WTERMSIG(status) == SIGALRM);
            write(work.findings + (slow ? "timeout-" : "crash-") + name_of(input), input);
            known.insert(name_of(input));
        }
    }
    return !known.empty() ? 1 : stopped != 0 ? 130 : 0;
}
