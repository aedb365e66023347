#include "engine/core/crash_report.h"

#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace lanthorn {

namespace {

constexpr int kMostFrames = 64;
constexpr std::size_t kStack = 65'536;  // bytes, for the handler of a stack that is full

std::atomic<std::uint64_t> steps_done{0};
std::array<char, 4096> crash_file{};
std::array<char, kStack> handler_stack{};

void write_all(int file, const char* text, std::size_t length) {
    while (length > 0) {
        const ssize_t n = write(file, text, length);
        if (n <= 0) {
            return;
        }
        text += n;
        length -= static_cast<std::size_t>(n);
    }
}

// "WORD N\n" without anything that a handler may not call.
void write_number(int file, const char* word, std::uint64_t number) {
    write_all(file, word, std::strlen(word));
    char digits[24];
    char* at = digits + sizeof digits;
    *--at = '\n';
    do {
        *--at = static_cast<char>('0' + number % 10);
        number /= 10;
    } while (number > 0);
    *--at = ' ';
    write_all(file, at, static_cast<std::size_t>(digits + sizeof digits - at));
}

extern "C" void report_crash(int signal) {
    const int file = open(crash_file.data(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file >= 0) {
        write_number(file, "signal", static_cast<std::uint64_t>(signal));
        write_number(file, "step", steps_done.load(std::memory_order_relaxed));
        void* frames[kMostFrames];
        backtrace_symbols_fd(frames, backtrace(frames, kMostFrames), file);
        close(file);
    }
    raise(signal);  // SA_RESETHAND: now it ends the program
}

}  // namespace

void install_crash_report(const std::string& to) {
    if (to.empty() || to.size() >= crash_file.size()) {
        return;
    }
    std::strcpy(crash_file.data(), to.c_str());
    void* frame = nullptr;
    backtrace(&frame, 1);  // loads what it needs now: a handler may not
    const stack_t stack{handler_stack.data(), 0, handler_stack.size()};
    sigaltstack(&stack, nullptr);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
        struct sigaction action {};
        action.sa_handler = report_crash;
        action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND | SA_NODEFER);
        sigaction(signal, &action, nullptr);
    }
}

void install_crash_report() {
    if (const char* file = std::getenv(kCrashFileVariable)) {
        install_crash_report(std::string(file));
    }
}

void note_step(std::uint64_t steps) {
    steps_done.store(steps, std::memory_order_relaxed);
}

}  // namespace lanthorn
