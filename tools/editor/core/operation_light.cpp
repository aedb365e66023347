// Lights in the units that people think in.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/scene/components.h"
#include "tools/editor/core/light_units.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/operation.h"

namespace lanthorn::editor {

namespace {

// "800lm" with the unit "lm": 800. False for another unit.
bool has_unit(std::string_view text, std::string_view unit, double& value) {
    if (!text.ends_with(unit)) {
        return false;
    }
    text.remove_suffix(unit.size());
    const std::optional<double> found = finite_number(text);
    value = found.value_or(value);
    return found.has_value();
}

std::string checked_kelvin(Operation& op, double kelvin) {
    if (!(kelvin >= 1000 && kelvin <= 20000)) {
        op.refuse(fmt::format("found {} K, expected 1000 to 20000 K", number(kelvin)));
    }
    vec3 colour = colour_of_kelvin(kelvin);
    colour /= std::max({colour.x, colour.y, colour.z});
    return fmt::format("[{},{},{}]", number(colour.x), number(colour.y), number(colour.z));
}

struct Declared {
    std::string key, json;
};

// What of the light's declaration is meant, as JSON: 800lm are candela by then.
Declared declared(Operation& op, const Light& light, std::string_view field, const std::string& text) {
    double value = 0;
    const auto plain = [&](std::string_view unit) {
        return has_unit(text, unit, value) || has_unit(text, "", value);
    };
    if (field == "kelvin" || (field == "colour" && has_unit(text, "K", value))) {
        if (!plain("K")) {
            op.refuse(fmt::format("found '{}', expected kelvin: 2700K", text));
        }
        return {"colour", checked_kelvin(op, value)};
    }
    if (field == "lumen" || (field == "intensity" && has_unit(text, "lm", value))) {
        if (!plain("lm") || value < 0 || light.type == LightType::directional) {
            op.refuse(fmt::format("found '{}', expected lumen of a point or spot light: 800lm", text));
        }
        return {"intensity", number(candela_for_lumen(light, value))};
    }
    if (field == "lux" || (field == "intensity" && has_unit(text, "lx", value))) {
        if (!plain("lx") || value < 0) {
            op.refuse(fmt::format("found '{}', expected lux 1 m away: 40lx", text));
        }
        return {"intensity", number(intensity_for_lux(light, value))};
    }
    if (field == "intensity" && has_unit(text, "cd", value)) {
        return {"intensity", number(value)};
    }
    if ((field == "inner_cone" || field == "outer_cone") && has_unit(text, "deg", value)) {
        return {fmt::format("{}", field), number(static_cast<float>(glm::radians(value)))};
    }
    return {fmt::format("{}", field), json_of(text)};
}

}  // namespace

void apply_light_value(Operation& op, std::uint32_t node, std::string_view field, const std::string& value) {
    const Light* light = light_of(op.model, node);
    if (light == nullptr) {
        op.refuse(fmt::format("'{}' has no light, expected a node with one", path_of(op.model, node)));
    }
    const ecs::ComponentType& type = *op.context.registry.find<LightComponent>();
    LightComponent now{*light};
    const auto [key, json] = declared(op, *light, field, value);
    const nlohmann::json before = parse_json(ecs::to_json(type, &now), "light");
    ecs::from_json(type, &now, fmt::format("{{{}:{}}}", nlohmann::json(key).dump(), json));
    Light& altered = now.light;
    if (altered.type == LightType::spot) {
        if (altered.outer_cone < 1e-3f) {
            op.refuse("outer_cone is below 0.001, expected a wider cone");
        }
        if (key == "outer_cone" && altered.inner_cone > 0.999f * altered.outer_cone) {
            altered.inner_cone = 0.99f * altered.outer_cone;
        }
        if (altered.inner_cone > 0.999f * altered.outer_cone) {
            op.refuse(fmt::format("inner_cone is {}, expected less than outer_cone, {}",
                                  number(altered.inner_cone), number(altered.outer_cone)));
        }
    }
    if (!(altered.range > 0)) {
        op.refuse("range is 0, expected more, or inf for none");
    }
    const nlohmann::json after = parse_json(ecs::to_json(type, &now), "light");
    op.result.before = before.value(key, nlohmann::json()).dump();
    op.result.after = after.value(key, nlohmann::json()).dump();
    op.model.lights[op.model.node(node).light] = std::make_shared<const Light>(altered);
}

void apply_scale_lights(Operation& op) {
    op.expect_count({1});
    const double factor = op.number_at(1);
    if (!(factor > 0)) {
        op.refuse(fmt::format("found {}, expected a factor above 0", op.word_at(1)));
    }
    std::size_t count = 0;
    for (std::shared_ptr<const Light>& light : op.model.lights) {
        if (light != nullptr) {
            Light scaled = *light;
            scaled.intensity = static_cast<float>(scaled.intensity * factor);
            if (!std::isfinite(scaled.intensity)) {
                op.refuse(
                    fmt::format("found {}, expected a factor that leaves finite lights", op.word_at(1)));
            }
            light = std::make_shared<const Light>(scaled);
            ++count;
        }
    }
    op.say({number(factor)});
    op.result.path = "lights";
    op.result.before = number(1.0);
    op.result.after = number(factor);
    for (std::uint32_t i = 0; i < op.model.nodes.size(); ++i) {
        if (light_of(op.model, i) != nullptr) {
            op.result.touched.push_back(i);
        }
    }
    if (count == 0) {
        op.refuse("found no light in the file");
    }
}

}  // namespace lanthorn::editor
