// Which of two ways to do the same is faster on this device, by trying both.
#pragma once

#include <functional>
#include <string_view>

namespace lanthorn::gi {

// What `run` takes: of the processor's time where that draws, else by the clock. Waits for the GPU.
double seconds_of(const std::function<void()>& run);

// Whether `other` is clearly faster than `usual`: takes less than 0.8 of its time, so that noise does not
// decide. Measured when first asked for `what`, and the answer kept for the device as long as the program
// runs. Waits for the GPU and runs both a few times then; the time is the processor's where that draws.
bool other_is_faster(std::string_view what, const std::function<void()>& usual,
                     const std::function<void()>& other);

}  // namespace lanthorn::gi
