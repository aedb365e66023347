// Why a point is as bright as it is, in words and as JSON.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gi_module/reference/light_split.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::workbench {

// What an entity is called, by its index.
using EntityNaming = std::function<std::string(std::uint32_t)>;
// By the world's Names; "thing 12" for one without.
EntityNaming naming_of(const ecs::World& world);

// Three digits, "0.0123" and "12300" written out; "0" for what is less than a millionth.
std::string lux_text(double lux);
std::string lamp_name(const reference::LightSource& source, std::uint32_t entity, const EntityNaming& name);
// "lamp_2 hidden by door_1: +41 lx if it were open".
std::string hidden_words(const reference::HiddenPart& hidden, const EntityNaming& name);
// "hidden", "behind the surface", ...; empty: lit.
std::string_view straight_words(reference::Straight straight);

// All of it, a line each: the sum, each lamp, the surfaces that the point has its light from, what is hidden
// by what, the strongest ways. Parts below a five-hundredth of the sum are left out.
std::vector<std::string> why_lines(const reference::LightSplit& split, const EntityNaming& name);
// Everything, in lux; places in the world. `origin`: FrameScene::origin.
nlohmann::ordered_json why_json(const reference::LightSplit& split, const dvec3& origin,
                                const EntityNaming& name);

}  // namespace lanthorn::workbench
