#include "lanthorn/ecs/type_info.h"

#include <atomic>

namespace lanthorn::ecs::detail {

TypeId next_component_id() {
    static std::atomic<TypeId> next{0};
    return next.fetch_add(1, std::memory_order_relaxed);
}

TypeId next_resource_id() {
    static std::atomic<TypeId> next{0};
    return next.fetch_add(1, std::memory_order_relaxed);
}

TypeId next_event_id() {
    static std::atomic<TypeId> next{0};
    return next.fetch_add(1, std::memory_order_relaxed);
}

TypeId next_bundle_id() {
    static std::atomic<TypeId> next{0};
    return next.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace lanthorn::ecs::detail
