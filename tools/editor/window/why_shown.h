// The answer to "why is this light here?" as panels and picture show it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>

#include "tools/editor/core/why_light.h"

namespace lanthorn::edit_window {

struct WhyShown {
    editor::WhyAnswer answer;
    std::function<std::string(std::uint32_t)> name;          // of an entity
    std::unordered_map<std::uint32_t, std::uint32_t> nodes;  // of entities that have one
    std::string technique;                                   // at work when it was asked
    double shown = -1;  // indirect lux that it showed there; negative: not known
    std::uint64_t version = 0;
    workbench::CameraPose pose;
    vec2 place{0};         // in the picture, 0..1 from the upper left
    int pointed_way = -1;  // whose row the pointer is over; -1: none

    std::uint32_t node_of(std::uint32_t entity) const {
        const auto found = nodes.find(entity);
        return found != nodes.end() ? found->second : kNone;
    }
};

}  // namespace lanthorn::edit_window
