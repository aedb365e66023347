#include "lanthorn/runtime/app.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lanthorn/core/error.h"

namespace lanthorn {

namespace {

// Of a step: a moment this near to a step's end is its end, however it was rounded.
constexpr double kRounding = 1e-6;

}  // namespace

App::App() {
    world_.insert_resource(Time{});
    world_.insert_resource(View{});
    world_.insert_resource(Views{});
    frame_.set_updates_events(false);
}

App::~App() = default;

App& App::add(std::unique_ptr<Plugin> plugin) {
    if (has(plugin->name())) {
        throw Error(ExitCode::bad_input,
                    fmt::format("app: plugin '{}' is added twice, expected it once", plugin->name()));
    }
    plugin->build(*this);
    plugins_.push_back(std::move(plugin));
    return *this;
}

bool App::has(std::string_view plugin) const {
    return std::ranges::any_of(plugins_, [&](const auto& p) { return p->name() == plugin; });
}

ViewId App::add_view(View view) {
    return world_.resource_mut<Views>().add(std::move(view));
}

View& App::view(ViewId id) {
    View* found = id == ViewId::first ? &view() : world_.resource_mut<Views>().find(id);
    if (found == nullptr) {
        throw Error(ExitCode::bad_input,
                    fmt::format("app: there is no view {}, expected one that was added and not removed",
                                static_cast<std::uint32_t>(id)));
    }
    return *found;
}

void App::remove_view(ViewId id) {
    if (id == ViewId::first || !world_.resource_mut<Views>().remove(id)) {
        throw Error(ExitCode::bad_input,
                    fmt::format("app: view {} is to be removed, expected one that was added and not removed",
                                static_cast<std::uint32_t>(id)));
    }
}

std::vector<ViewId> App::views() const {
    std::vector<ViewId> ids{ViewId::first};
    for (const auto& [id, view] : world_.resource<Views>().all()) {
        ids.push_back(id);
    }
    return ids;
}

void App::step() {
    Time& time = world_.resource_mut<Time>();
    ++time.steps;
    time.moment = time.simulated();
    time.blend = 1;
    fixed_.run(world_);
}

void App::frame(double seconds, int most_steps) {
    const Time& now = time();
    const double latest = static_cast<double>(now.steps) + most_steps;
    show_at(std::min(now.moment + std::max(seconds, 0.0), std::max(latest / kStepsPerSecond, now.moment)));
}

void App::show_at(double moment) {
    check_moment(moment);
    const auto due =
        static_cast<std::uint64_t>(std::ceil(std::max(moment * kStepsPerSecond - kRounding, 0.0)));
    while (time().steps < due) {
        step();
    }
    move_to(moment);
    show();
}

void App::skip_to(double moment) {
    check_moment(moment);
    Time& time = world_.resource_mut<Time>();
    time.steps =
        std::max(time.steps,
                 static_cast<std::uint64_t>(std::ceil(std::max(moment * kStepsPerSecond - kRounding, 0.0))));
    move_to(moment);
}

void App::check_moment(double moment) const {
    if (!(moment >= time().moment - kRounding * kStepSeconds) || !std::isfinite(moment)) {
        throw Error(
            ExitCode::bad_input,
            fmt::format("app: {} s is asked for at {} s, expected a later moment", moment, time().moment));
    }
}

void App::move_to(double moment) {
    Time& time = world_.resource_mut<Time>();
    const double blend = moment * kStepsPerSecond - (static_cast<double>(time.steps) - 1);
    const bool at_the_end = blend > 1 - kRounding;
    time.moment =
        at_the_end ? time.simulated() : moment;  // a step's end is one moment, however it was reached
    time.blend = at_the_end ? 1 : std::max(blend, 0.0);
}

void App::set_threads(int threads) {
    fixed_.set_threads(threads);
    frame_.set_threads(threads);
}

std::string App::schedule_dot() {
    return fixed_.to_dot() + frame_.to_dot();
}

}  // namespace lanthorn
