// A light in the units that people think in.
#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "tools/editor/core/light_units.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/window/lines.h"
#include "tools/editor/window/panels.h"
#include "tools/editor/window/quantity.h"

namespace lanthorn::edit_window {

using editor::light_of;

namespace {

// A line for each of the nodes.
std::vector<std::string> each(const EditorState& state, const std::vector<std::uint32_t>& nodes,
                              std::string_view field, const std::string& value) {
    std::vector<std::string> lines;
    for (const std::uint32_t node : nodes) {
        lines.push_back(set_line(state.session.path_of(node), field, value));
    }
    return lines;
}

template <class Get>
bool differ(const EditorState& state, const std::vector<std::uint32_t>& nodes, const Get& get) {
    const auto first = get(*light_of(state.session.model(), nodes.front()));
    for (const std::uint32_t node : nodes) {
        if (!(get(*light_of(state.session.model(), node)) == first)) {
            return true;
        }
    }
    return false;
}

}  // namespace

void draw_light(EditorState& state, const std::vector<std::uint32_t>& all) {
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t node : all) {
        if (light_of(state.session.model(), node) != nullptr) {
            nodes.push_back(node);
        }
    }
    if (nodes.empty()) {
        return;
    }
    const Light light = *light_of(state.session.model(), nodes.front());
    const std::string whom = nodes.size() == 1 ? editor::called(state.session.model(), nodes.front())
                                               : fmt::format("{} lights", nodes.size());
    const bool directional = light.type == LightType::directional;
    const auto row = [&](const NumberRow& shown, std::string_view field, const std::string& unit) {
        const NumberChange change = state.fields.number(shown);
        // Another unit than the row's goes to the command as it was typed.
        const std::string value =
            change.unit.empty() ? json_number(change.value) + unit : json_number(change.value) + change.unit;
        state.follow(
            change.doing, fmt::format("{} of {}", shown.label, whom),
            change.unit.empty()
                ? each(state, nodes, field, value)
                : each(state, nodes, change.unit == "K" ? "light.colour" : "light.intensity", value));
    };
    const float reach = static_cast<float>(light.intensity);
    NumberRow intensity{
        .label = "intensity", .value = static_cast<double>(reach), .unit = directional ? "lx" : "cd"};
    intensity.mixed = differ(state, nodes, [](const Light& l) { return l.intensity; });
    intensity.lower = 0;
    intensity.step = 0.01;
    intensity.logarithmic = true;
    intensity.words = "luminous intensity on the axis; 800lm and 40lx are understood";
    row(intensity, "light.intensity", "");
    if (!directional) {
        NumberRow lumen{.label = "flux", .value = editor::lumen(light), .unit = "lm"};
        lumen.mixed = intensity.mixed;
        lumen.lower = 0;
        lumen.logarithmic = true;
        lumen.digits = 4;
        lumen.words = "all that it sends out; a household bulb: 800 lm";
        row(lumen, "light.intensity", "lm");
        NumberRow lux{.label = "at 1 m", .value = editor::lux_at_one_metre(light), .unit = "lx"};
        lux.mixed = intensity.mixed;
        lux.lower = 0;
        lux.logarithmic = true;
        lux.digits = 4;
        lux.words = "on a surface that faces it, 1 m away";
        row(lux, "light.intensity", "lx");
    }
    const editor::Kelvin temperature = editor::kelvin_of(light.colour);
    NumberRow kelvin{.label = "temperature", .value = temperature.kelvin, .unit = "K"};
    kelvin.mixed = differ(state, nodes, [](const Light& l) { return l.colour; });
    kelvin.lower = 1000;
    kelvin.upper = 20000;
    kelvin.logarithmic = true;
    kelvin.step = 0.005;
    kelvin.digits = 4;
    kelvin.words =
        std::abs(temperature.distance) > 0.005
            ? fmt::format("of the black body that comes nearest; the colour is {:+.3f} {} of it",
                          std::abs(temperature.distance), temperature.distance > 0 ? "greener" : "pinker")
            : "candle 1900, bulb 2700, noon 5500, shade 8000";
    row(kelvin, "light.colour", "K");
    vec3 shown = light.colour / std::max({light.colour.x, light.colour.y, light.colour.z, 1e-6f});
    const Doing doing = state.fields.colour("colour", shown, "hue alone: brightness is the intensity");
    state.follow(doing, "colour of " + whom, each(state, nodes, "light.colour", json_vector(shown)));
    if (!directional) {
        NumberRow range{.label = "range", .value = static_cast<double>(light.range), .unit = "m"};
        range.mixed = differ(state, nodes, [](const Light& l) { return l.range; });
        range.lower = 0.01;
        range.upper = std::numeric_limits<double>::infinity();
        range.logarithmic = true;
        range.words = fmt::format("where it is cut off; \"inf\": nowhere. It gives 1 lx {} m away",
                                  shown_number(editor::reach_of_one_lux(light), 3));
        row(range, "light.range", "");
    }
    if (light.type == LightType::spot) {
        const double to_degrees = 180.0 / static_cast<double>(kPi);
        for (const bool outer : {true, false}) {
            NumberRow cone{
                .label = outer ? "cone" : "full to",
                .value = to_degrees * static_cast<double>(outer ? light.outer_cone : light.inner_cone),
                .unit = "\u00b0"};
            cone.mixed =
                differ(state, nodes, [&](const Light& l) { return outer ? l.outer_cone : l.inner_cone; });
            cone.lower = outer ? 0.1 : 0;
            cone.upper = 90;
            cone.step = 0.2;
            cone.words = outer ? "from its axis to where no light goes"
                               : "from its axis to where light begins to fade";
            row(cone, outer ? "light.outer_cone" : "light.inner_cone", "deg");
        }
    }
    int type = static_cast<int>(light.type);
    if (differ(state, nodes, [](const Light& l) { return l.type; })) {
        type = -1;
    }
    if (state.fields.choice("type", {"directional", "point", "spot"}, type, "where it shines from")) {
        constexpr std::array kNames = {"directional", "point", "spot"};
        state.run("type of " + whom,
                  each(state, nodes, "light.type", kNames[static_cast<std::size_t>(type)]));
    }
}

}  // namespace lanthorn::edit_window
