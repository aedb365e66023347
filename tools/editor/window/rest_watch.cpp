#include "tools/editor/window/rest_watch.h"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <exception>
#include <utility>

namespace lanthorn::edit_window {

namespace {

constexpr int kFewestSamples = 4, kMostSamples = 1024;  // a cell

}  // namespace

RestWatch::RestWatch(std::function<void()> ready)
    : ready_(std::move(ready)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

void RestWatch::measure(std::unique_ptr<const Job> job) {
    const std::lock_guard lock(mutex_);
    job_ = std::move(job);
    result_.reset();
    ++number_;
    busy_ = true;
    changed_.notify_one();
}

void RestWatch::stop() {
    const std::lock_guard lock(mutex_);
    job_.reset();
    result_.reset();
    ++number_;
    busy_ = false;
}

bool RestWatch::busy() const {
    const std::lock_guard lock(mutex_);
    return busy_;
}

std::optional<RestFigures> RestWatch::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(result_, std::nullopt);
}

bool RestWatch::wanted(std::uint64_t number, const std::stop_token& stop) const {
    const std::lock_guard lock(mutex_);
    return number == number_ && !stop.stop_requested();
}

bool RestWatch::tell(const RestFigures& figures, bool last, std::uint64_t number) {
    const std::lock_guard lock(mutex_);
    if (number != number_) {
        return false;
    }
    result_ = figures;
    busy_ = !last;
    ready_();
    return true;
}

void RestWatch::measure_one(const Job& job, std::uint64_t number, const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    const auto begun = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
    RestFigures figures;
    {
        const reference::LightSplitter light(job.frame, job.settings);
        for (const workbench::PlacedContract& contract : job.contracts) {
            if (!wanted(number, stop)) {
                return;
            }
            figures.contracts.push_back(check_contract(contract, light, {}));
        }
        figures.shares = workbench::light_shares(light, job.frame.camera, job.size);
    }
    const bool no_error = job.indirect.pixels.empty();
    if (!tell(figures, no_error, number) || no_error) {
        return;
    }
    reference::SparsePaths paths(job.frame, job.size, editor::kErrorStride, job.settings);
    for (bool first = true; paths.spp() < kMostSamples;) {
        if (!paths.trace(paths.spp() < kFewestSamples ? kFewestSamples : 2,
                         [&] { return wanted(number, stop); })) {
            return;
        }
        const bool last = seconds() >= kLastSeconds || paths.spp() >= kMostSamples;
        if (last || (first && seconds() >= kFirstSeconds)) {
            first = false;
            figures.error = editor::error_map(paths, job.indirect);
            if (!tell(figures, last, number) || last) {
                return;
            }
        }
    }
}

void RestWatch::run(const std::stop_token& stop) {
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 10);  // of this thread alone
    while (true) {
        std::unique_ptr<const Job> job;
        std::uint64_t number = 0;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [this] { return job_ != nullptr; })) {
                return;
            }
            job = std::move(job_);
            number = number_;
        }
        try {
            measure_one(*job, number, stop);
        } catch (const std::exception&) {  // a scene that Embree cannot hold: no figure comes of it
            const std::lock_guard lock(mutex_);
            busy_ = busy_ && number != number_;
            ready_();
        }
    }
}

}  // namespace lanthorn::edit_window
