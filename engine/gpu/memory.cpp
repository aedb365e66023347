#include "engine/gpu/memory.h"

#include <atomic>

namespace lanthorn::gpu {

namespace {
std::atomic<std::size_t> g_allocated{0};
}

std::size_t allocated_bytes() {
    return g_allocated.load(std::memory_order_relaxed);
}
void account(std::ptrdiff_t bytes) {
    g_allocated.fetch_add(static_cast<std::size_t>(bytes), std::memory_order_relaxed);
}

}  // namespace lanthorn::gpu
