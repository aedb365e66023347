// Whether a scene's light keeps what its light_contracts ask for, by the path tracer.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gi_module/reference/light_split.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/light_sensor.h"

namespace lanthorn::workbench {

// A contract and where it holds. Render space.
struct PlacedContract {
    std::string name;
    LightContract asked;
    bool sensor = false;  // of what the sensor beside it reads
    mat4 to_box{1};       // else: takes a place to one whose corners are -0.5 and 0.5
    mat4 from_box{1};
    vec3 position{0}, direction{0, 0, -1};  // of the sensor
    float radius = 0.5f;
    vec3 filter{0};
};

// All of a world, by their entities. `frame`: of that world.
std::vector<PlacedContract> contracts_of(const ecs::World& world, const FrameScene& frame);
// What one would be of an entity with a WorldTransform, whether it has one or not.
PlacedContract placed_contract(const ecs::World& world, const FrameScene& frame, ecs::Entity e,
                               const LightContract& asked);
// Up to so many places that it is about; none where there is no surface.
std::vector<reference::LitPoint> places_of(const PlacedContract& contract,
                                           const reference::LightSplitter& light, int places);

struct ContractVerdict {
    PlacedContract contract;
    int places = 0;  // that were looked at; 0: no surface is there
    // Lux through the sensor's filter, or as luminance: of all places the mean and its standard error, and of
    // a box's places those that a twentieth lies below, a half, and a twentieth above.
    double mean = 0, noise = 0, low = 0, median = 0, high = 0;
    // Of the places: within, less, more. A sensor is one place.
    double within = 0, less = 0, more = 0;
    bool kept = false;
};

struct ContractEffort {
    int places = 128;  // in a box, on a sensor's disc
    int paths = 256;   // at each
};

ContractVerdict check_contract(const PlacedContract& contract, const reference::LightSplitter& light,
                               const ContractEffort& effort);

// "study: 142 lx (61 to 240), 97 % within 50 to 300: kept".
std::string contract_words(const ContractVerdict& verdict);
nlohmann::ordered_json contract_json(const ContractVerdict& verdict);

}  // namespace lanthorn::workbench
