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
    lines.reserve(nodes.size());
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

// The rows of some lights, which show the first one's values.
class LightRows {
  public:
    LightRows(EditorState& state, std::vector<std::uint32_t> nodes)
        : state_(state),
          nodes_(std::move(nodes)),
          light_(*light_of(state.session.model(), nodes_.front())),
          whom_(nodes_.size() == 1 ? editor::called(state.session.model(), nodes_.front())
                                   : fmt::format("{} lights", nodes_.size())) {}

    void draw() {
        strength();
        colour();
        range();
        if (light_.type == LightType::spot) {
            cone("cone", &Light::outer_cone, 0.1, "light.outer_cone", "from its axis to where no light goes");
            cone("full to", &Light::inner_cone, 0, "light.inner_cone",
                 "from its axis to where light begins to fade");
        }
        type();
    }

  private:
    bool directional() const { return light_.type == LightType::directional; }

    void row(const NumberRow& shown, std::string_view field, const std::string& unit) {
        const NumberChange change = state_.fields.number(shown);
        // Another unit than the row's goes to the command as it was typed.
        const std::string value =
            change.unit.empty() ? json_number(change.value) + unit : json_number(change.value) + change.unit;
        state_.follow(
            change.doing, fmt::format("{} of {}", shown.label, whom_),
            change.unit.empty()
                ? each(state_, nodes_, field, value)
                : each(state_, nodes_, change.unit == "K" ? "light.colour" : "light.intensity", value));
    }

    // In candela or lux, and what that is in other units.
    void strength() {
        NumberRow intensity{.label = "intensity",
                            .value = static_cast<double>(light_.intensity),
                            .unit = directional() ? "lx" : "cd"};
        intensity.mixed = differ(state_, nodes_, [](const Light& l) { return l.intensity; });
        intensity.lower = 0;
        intensity.step = 0.01;
        intensity.logarithmic = true;
        intensity.words = "luminous intensity on the axis; 800lm and 40lx are understood";
        row(intensity, "light.intensity", "");
        if (directional()) {
            return;
        }
        NumberRow lumen{.label = "flux", .value = editor::lumen(light_), .unit = "lm"};
        lumen.mixed = intensity.mixed;
        lumen.lower = 0;
        lumen.logarithmic = true;
        lumen.digits = 4;
        lumen.words = "all that it sends out; a household bulb: 800 lm";
        row(lumen, "light.intensity", "lm");
        NumberRow lux{.label = "at 1 m", .value = editor::lux_at_one_metre(light_), .unit = "lx"};
        lux.mixed = intensity.mixed;
        lux.lower = 0;
        lux.logarithmic = true;
        lux.digits = 4;
        lux.words = "on a surface that faces it, 1 m away";
        row(lux, "light.intensity", "lx");
    }

    void colour() {
        const editor::Kelvin temperature = editor::kelvin_of(light_.colour);
        NumberRow kelvin{.label = "temperature", .value = temperature.kelvin, .unit = "K"};
        kelvin.mixed = differ(state_, nodes_, [](const Light& l) { return l.colour; });
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
        const vec3 c = light_.colour;
        vec3 shown = c / std::max({c.x, c.y, c.z, 1e-6f});
        const Doing doing = state_.fields.colour("colour", shown, "hue alone: brightness is the intensity");
        state_.follow(doing, "colour of " + whom_, each(state_, nodes_, "light.colour", json_vector(shown)));
    }

    void range() {
        if (directional()) {
            return;
        }
        NumberRow range{.label = "range", .value = static_cast<double>(light_.range), .unit = "m"};
        range.mixed = differ(state_, nodes_, [](const Light& l) { return l.range; });
        range.lower = 0.01;
        range.upper = std::numeric_limits<double>::infinity();
        range.logarithmic = true;
        range.words = fmt::format("where it is cut off; \"inf\": nowhere. It gives 1 lx {} m away",
                                  shown_number(editor::reach_of_one_lux(light_), 3));
        row(range, "light.range", "");
    }

    void cone(const char* label, float Light::*angle, double lower, std::string_view field,
              const char* words) {
        NumberRow cone{.label = label,
                       .value = 180.0 / static_cast<double>(kPi) * static_cast<double>(light_.*angle),
                       .unit = "\u00b0"};
        cone.mixed = differ(state_, nodes_, [&](const Light& l) { return l.*angle; });
        cone.lower = lower;
        cone.upper = 90;
        cone.step = 0.2;
        cone.words = words;
        row(cone, field, "deg");
    }

    void type() {
        int type = static_cast<int>(light_.type);
        if (differ(state_, nodes_, [](const Light& l) { return l.type; })) {
            type = -1;
        }
        if (state_.fields.choice("type", {"directional", "point", "spot"}, type, "where it shines from")) {
            constexpr std::array kNames = {"directional", "point", "spot"};
            state_.run("type of " + whom_,
                       each(state_, nodes_, "light.type", kNames[static_cast<std::size_t>(type)]));
        }
    }

    EditorState& state_;
    std::vector<std::uint32_t> nodes_;
    Light light_;
    std::string whom_;
};

}  // namespace

void draw_light(EditorState& state, const std::vector<std::uint32_t>& all) {
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t node : all) {
        if (light_of(state.session.model(), node) != nullptr) {
            nodes.push_back(node);
        }
    }
    if (!nodes.empty()) {
        LightRows(state, std::move(nodes)).draw();
    }
}

}  // namespace lanthorn::edit_window
