#include "tools/lanthorn/common/interrupt.h"

namespace lanthorn::tools {

namespace {

volatile std::sig_atomic_t noted = 0;

}  // namespace

InterruptWatch::InterruptWatch() {
    noted = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { noted = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, &interrupt_before_);
    sigaction(SIGTERM, &action, &end_before_);
}

InterruptWatch::~InterruptWatch() {
    sigaction(SIGINT, &interrupt_before_, nullptr);
    sigaction(SIGTERM, &end_before_, nullptr);
}

bool InterruptWatch::interrupted() const {
    return noted != 0;
}

}  // namespace lanthorn::tools
