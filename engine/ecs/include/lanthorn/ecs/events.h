// Typed events: written during a step, read by any number of readers, each at its own pace, and dropped after
// the second World::update_events() since they were sent. An event is therefore seen by a reader that runs
// once per step, whether before or after the writer.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "lanthorn/ecs/parallel.h"
#include "lanthorn/ecs/type_info.h"

namespace lanthorn::ecs {

namespace detail {

class EventsBase {
  public:
    virtual ~EventsBase() = default;
    virtual void update() = 0;
};

}  // namespace detail

// The queue of one type of event; it forgets those of the step before the last.
template <class T>
class Events final : public detail::EventsBase {
  public:
    // Error inside Query::parallel_each.
    void send(T event) {
        detail::check_not_in_parallel_each("send events");
        fresh_.push_back(std::move(event));
    }

    // Drops the events before the last update() and keeps those since for one more step.
    void update() override {
        first_ += old_.size();
        old_.clear();
        std::swap(old_, fresh_);
    }

    // Calls fn(const T&) for each event numbered `cursor` or later, oldest first, and moves the cursor behind
    // them. Returns how many were dropped before this reader came.
    template <class Fn>
    std::uint64_t read(std::uint64_t& cursor, Fn&& fn) const {
        const std::uint64_t missed = cursor < first_ ? first_ - cursor : 0;
        std::uint64_t number = first_;
        const std::uint64_t from = cursor;
        cursor = end();
        for (const auto* buffer : {&old_, &fresh_}) {
            for (const T& event : *buffer) {
                if (number++ >= from) {
                    fn(event);
                }
            }
        }
        return missed;
    }
    // How many read() would hand out from `cursor` on; those that were dropped are not counted.
    std::uint64_t unread(std::uint64_t cursor) const { return end() - (cursor < first_ ? first_ : cursor); }
    // The number the next event gets.
    std::uint64_t end() const { return first_ + old_.size() + fresh_.size(); }

  private:
    std::vector<T> old_, fresh_;
    std::uint64_t first_ = 0;  // number of old_'s first
};

}  // namespace lanthorn::ecs
