#include "tests/fuzz/quiet.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <iostream>

// There in a build with a sanitizer.
extern "C" void __sanitizer_set_report_fd(void* descriptor) __attribute__((weak));

namespace lanthorn::fuzz {

namespace {

void flush() {
    std::cout.flush();
    std::fflush(stdout);
    std::fflush(stderr);
}

}  // namespace

Quiet::Quiet() : out_(dup(1)), err_(dup(2)), caught_(memfd_create("stderr", 0)) {
    flush();
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, 1);
    dup2(caught_, 2);
    close(nowhere);
    if (__sanitizer_set_report_fd != nullptr) {
        __sanitizer_set_report_fd(reinterpret_cast<void*>(static_cast<std::intptr_t>(err_)));
    }
}

Quiet::~Quiet() {
    flush();
    dup2(out_, 1);
    dup2(err_, 2);
    if (__sanitizer_set_report_fd != nullptr) {
        __sanitizer_set_report_fd(reinterpret_cast<void*>(static_cast<std::intptr_t>(2)));
    }
    for (const int descriptor : {out_, err_, caught_}) {
        close(descriptor);
    }
}

std::string Quiet::errors() const {
    flush();
    std::string text(static_cast<std::size_t>(lseek(caught_, 0, SEEK_END)), '\0');
    const auto count = pread(caught_, text.data(), text.size(), 0);
    text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
    return text;
}

}  // namespace lanthorn::fuzz
