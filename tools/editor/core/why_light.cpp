#include "tools/editor/core/why_light.h"

#include <fmt/format.h>

#include <chrono>
#include <unordered_map>

#include "tools/editor/core/node_path.h"
#include "tools/workbench/measure/light_words.h"

namespace lanthorn::editor {

namespace {

using Clock = std::chrono::steady_clock;

double ms_from(Clock::time_point begun) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
}

}  // namespace

bool WhyLight::prepare(const FrameScene& frame, const Settings& settings) {
    const reference::PathSettings path = reference::path_settings(settings);
    const std::string text =
        fmt::format("{} {} {}", path.bounces, path.seed, reference::transport_name(path.transport));
    if (splitter_ && settings_ == text && splitter_->follow(frame)) {
        return false;
    }
    splitter_.reset();  // two of them would not be needed at a time
    splitter_ = std::make_unique<reference::LightSplitter>(frame, path);
    settings_ = text;
    return true;
}

std::optional<WhyAnswer> WhyLight::ask(const FrameScene& frame, const Settings& settings, ivec2 size,
                                       ivec2 pixel) {
    const auto begun = Clock::now();
    WhyAnswer answer;
    if (prepare(frame, settings)) {
        answer.built_ms = ms_from(begun);
    }
    const auto built = Clock::now();
    const auto point = splitter_->seen(frame.camera, size, pixel);
    if (!point) {
        return std::nullopt;
    }
    answer.point = *point;
    answer.split = splitter_->split(*point);
    answer.origin = frame.origin;
    answer.at = frame.origin + dvec3(point->position);
    answer.traced_ms = ms_from(built);
    return answer;
}

std::function<std::string(std::uint32_t)> names_in(EditSession& session) {
    auto names = std::make_shared<std::unordered_map<std::uint32_t, std::string>>();
    const std::vector<ecs::Entity> all = session.entities();
    for (std::uint32_t node = 0; node < all.size(); ++node) {
        if (all[node] != ecs::kNullEntity && session.model().find(node) != nullptr) {
            (*names)[all[node].index] = called(session.model(), node);
        }
    }
    for (const ecs::Entity guest : session.guests()) {
        (*names)[guest.index] = "guest light";
    }
    return [names, others = workbench::naming_of(session.world())](std::uint32_t entity) {
        const auto found = names->find(entity);
        return found != names->end() ? found->second : others(entity);
    };
}

}  // namespace lanthorn::editor
