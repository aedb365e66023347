// What is measured of a picture while the window rests, on a thread of its own: contracts, what each light
// gives, and the error of indirect light.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "lanthorn/reference/path_settings.h"
#include "lanthorn/scene/frame_scene.h"
#include "tools/editor/core/error_map.h"
#include "tools/workbench/measure/light_contracts.h"
#include "tools/workbench/measure/light_shares.h"

namespace lanthorn::edit_window {

struct RestFigures {
    std::vector<workbench::ContractVerdict> contracts;
    std::vector<workbench::LightShare> shares;
    std::optional<editor::ErrorMap> error;  // not yet; or the technique is the reference itself
};

class RestWatch {
  public:
    static constexpr double kFirstSeconds = 0.6, kLastSeconds = 2.2;  // after which a result is told

    // `ready` is called from the other thread whenever take() has a new result, or none comes; it must not
    // block.
    explicit RestWatch(std::function<void()> ready);

    struct Job {
        FrameScene frame;
        ivec2 size{0};    // of the picture
        ImageF indirect;  // of it: lux, rows from the top; empty: its error is not asked for
        reference::PathSettings settings;
        std::vector<workbench::PlacedContract> contracts;
    };
    // In place of what is being measured. The thread has a low priority.
    void measure(std::unique_ptr<const Job> job);
    // No more; what is measured is dropped.
    void stop();
    bool busy() const;
    // The newest result, once.
    std::optional<RestFigures> take();

  private:
    void run(const std::stop_token& stop);
    void measure_one(const Job& job, std::uint64_t number, const std::stop_token& stop);
    // False: nobody wants it any more.
    bool tell(const RestFigures& figures, bool last, std::uint64_t number);
    bool wanted(std::uint64_t number, const std::stop_token& stop) const;

    std::function<void()> ready_;
    mutable std::mutex mutex_;  // of what follows
    std::condition_variable_any changed_;
    std::unique_ptr<const Job> job_;
    std::optional<RestFigures> result_;
    std::uint64_t number_ = 0;  // of the newest job, or of its stop
    bool busy_ = false;
    std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace lanthorn::edit_window
