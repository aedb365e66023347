#include "lanthorn/ecs/workers_end.h"

#include <oneapi/tbb/global_control.h>

#include <new>

namespace lanthorn::ecs {

struct WorkersEndWithMain::Handle {
    tbb::task_scheduler_handle handle{tbb::attach{}};
};

WorkersEndWithMain::WorkersEndWithMain() : handle_(std::make_unique<Handle>()) {}

WorkersEndWithMain::~WorkersEndWithMain() {
    tbb::finalize(handle_->handle, std::nothrow);
}

}  // namespace lanthorn::ecs
