#include "engine/deformation/serials.h"

#include <atomic>

namespace lanthorn::deform {

std::uint64_t next_serial() {
    static std::atomic<std::uint64_t> serial{0};
    return ++serial;
}

}  // namespace lanthorn::deform
