#include "tools/editor/core/light_wishes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "lanthorn/core/colour.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/light_sensor.h"
#include "tools/editor/core/command.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/non_negative.h"
#include "tools/workbench/measure/light_words.h"

namespace lanthorn::editor {

using reference::LampPart;
using reference::LightKind;
using reference::LightSplitter;

namespace {

// How much it counts, beside wishes, that a lamp stays as it is: what they leave open is decided by it, and
// they are hardly missed for it.
constexpr double kStay = 1e-4;
constexpr double kSeen = 2;     // standard errors: what a lamp gives less of is not built upon
constexpr double kSame = 1e-4;  // relative: a lamp that changes less stays
constexpr double kDarkest = 1;  // lux; of a wish for less a miss counts as of one for this

double number_in(std::string_view text, const char* what) {
    const std::optional<double> value = finite_number(text);
    if (!value) {
        throw InputError(fmt::format("found '{}', expected {}", text, what));
    }
    return *value;
}

// What a wish's miss is measured by.
double weight_of(const LightWish& wish) {
    return 1 / std::max(wish.lux, kDarkest);
}

// By lamps that may be altered, at the intensity of the frame that was traced; and what stays.
struct Given {
    std::vector<double> by_lamp, noise;
    double rest = 0, rest_noise = 0;
    int places = 0;
};

Given light_at(const PlacedWish& wish, const LightSplitter& splitter, const std::vector<int>& lamp_of,
               std::size_t lamps, const WishEffort& effort) {
    Given light;
    light.by_lamp.resize(lamps);
    std::vector<double> variances(lamps, 0);
    double rest_variance = 0;
    const auto points = places_of(wish.place, splitter, effort.places);
    light.places = static_cast<int>(points.size());
    for (const reference::LitPoint& point : points) {
        for (const LampPart& part : splitter.lamps(point, effort.paths)) {
            const double lux =
                wish.place.sensor ? glm::dot(part.sum.rgb, dvec3(wish.place.filter)) : part.sum.value();
            const double variance = part.sum.noise * part.sum.noise;
            const int lamp = part.source.kind == LightKind::punctual ? lamp_of[part.source.index] : -1;
            (lamp < 0 ? light.rest : light.by_lamp[static_cast<std::size_t>(lamp)]) += lux;
            (lamp < 0 ? rest_variance : variances[static_cast<std::size_t>(lamp)]) += variance;
        }
    }
    const double count = std::max(1, light.places);
    for (std::size_t i = 0; i < lamps; ++i) {
        light.by_lamp[i] /= count;
        light.noise.push_back(std::sqrt(variances[i]) / count);
    }
    light.rest /= count;
    light.rest_noise = std::sqrt(rest_variance) / count;
    return light;
}

// Intensities that lamps are traced with: their own, and of dark ones the mean of the others, so that paths
// ask all of them.
std::vector<double> traced_intensities(const std::vector<WishLamp>& lamps) {
    double sum = 0;
    int bright = 0;
    for (const WishLamp& lamp : lamps) {
        sum += lamp.intensity;
        bright += lamp.intensity > 0 ? 1 : 0;
    }
    std::vector<double> result;
    result.reserve(lamps.size());
    for (const WishLamp& lamp : lamps) {
        result.push_back(lamp.intensity > 0 ? lamp.intensity : bright > 0 ? sum / bright : 100);
    }
    return result;
}

// Factors of the traced intensities.
std::vector<double> factors_for(const std::vector<PlacedWish>& wishes, const std::vector<Given>& lights,
                                const std::vector<double>& now) {
    const std::size_t lamps = now.size();
    std::size_t slacks = 0;
    for (const PlacedWish& each : wishes) {
        slacks += each.wish.asks == Asks::exactly ? 0 : 1;
    }
    std::vector<Equation> equations;
    std::size_t slack = lamps;
    for (std::size_t w = 0; w < wishes.size(); ++w) {
        const LightWish& wish = wishes[w].wish;
        const double weight = weight_of(wish);
        Equation e{std::vector<double>(lamps + slacks, 0), weight * (wish.lux - lights[w].rest)};
        for (std::size_t i = 0; i < lamps; ++i) {
            const bool seen = lights[w].by_lamp[i] > kSeen * lights[w].noise[i];
            e.factors[i] = seen ? weight * lights[w].by_lamp[i] : 0;
        }
        if (wish.asks != Asks::exactly) {  // what it may be less, or more, is an unknown as well
            e.factors[slack++] = wish.asks == Asks::at_most ? 1 : -1;
        }
        equations.push_back(std::move(e));
    }
    for (std::size_t i = 0; i < lamps; ++i) {
        Equation stays{std::vector<double>(lamps + slacks, 0), kStay * now[i]};
        stays.factors[i] = kStay;
        equations.push_back(std::move(stays));
    }
    std::vector<double> factors = non_negative_solution(equations);
    factors.resize(lamps);
    return factors;
}

workbench::PlacedContract place_of(const LightWish& wish, const FrameScene& frame) {
    workbench::PlacedContract place;
    place.name = wish.where;
    place.position = vec3(wish.place - frame.origin);
    place.radius = static_cast<float>(wish.radius);
    if (wish.normal) {
        place.sensor = true;
        place.direction = *wish.normal;
        place.filter = LightSensor().filter;
        return place;
    }
    const auto side = static_cast<float>(2 * wish.radius);
    place.from_box = mat4(side);
    place.from_box[3] = vec4(place.position, 1);
    place.to_box = glm::inverse(place.from_box);
    return place;
}

workbench::PlacedContract place_of_node(const LightWish& wish, EditSession& session,
                                        const FrameScene& frame) {
    const ecs::World& world = session.world();
    const ecs::Entity e = session.entity_of(session.node_at(wish.where));
    const LightContract* contract = e != ecs::kNullEntity ? world.try_get<LightContract>(e) : nullptr;
    if (contract == nullptr && (e == ecs::kNullEntity || world.try_get<LightSensor>(e) == nullptr)) {
        throw InputError(fmt::format(
            "wish: '{}' has no light, expected a node with a light_sensor or a light_contract", wish.where));
    }
    return workbench::placed_contract(world, frame, e, contract != nullptr ? *contract : LightContract());
}

}  // namespace

LightWish wish_of(const std::string& where, const std::string& lux, const std::string& radius) {
    LightWish wish;
    wish.where = where;
    wish.of_node = where.starts_with('/');
    if (!wish.of_node) {
        std::vector<double> numbers;
        for (std::size_t at = 0; at <= where.size();) {
            const std::size_t end = std::min(where.find(',', at), where.size());
            numbers.push_back(number_in(std::string_view(where).substr(at, end - at),
                                        "a path, X,Y,Z in metres, or X,Y,Z,NX,NY,NZ"));
            at = end + 1;
        }
        if (numbers.size() != 3 && numbers.size() != 6) {
            throw InputError(fmt::format(
                "wish: found {} numbers in '{}', expected a path, X,Y,Z in metres, or X,Y,Z,NX,NY,NZ",
                numbers.size(), where));
        }
        wish.place = {numbers[0], numbers[1], numbers[2]};
        if (numbers.size() == 6) {
            const dvec3 normal(numbers[3], numbers[4], numbers[5]);
            if (!(glm::length(normal) > 0)) {
                throw InputError(fmt::format("wish: found no direction in '{}', expected a normal", where));
            }
            wish.normal = vec3(glm::normalize(normal));
        }
    }
    std::string_view rest = lux;
    if (rest.starts_with("<=") || rest.starts_with(">=")) {
        wish.asks = rest.front() == '<' ? Asks::at_most : Asks::at_least;
        rest.remove_prefix(2);
    }
    if (rest.ends_with("lx")) {
        rest.remove_suffix(2);
    }
    wish.lux = number_in(rest, "lux: 200, <=5 or >=100");
    if (wish.lux < 0 || (wish.lux == 0 && wish.asks == Asks::at_least)) {
        throw InputError(fmt::format("wish: found {} lx, expected 0 or more", rest));
    }
    if (!radius.empty()) {
        wish.radius = number_in(radius, "a radius in metres");
        if (wish.of_node || !(wish.radius > 0)) {
            throw InputError(
                fmt::format("wish: found a radius of '{}', expected one above 0 m, of a place", radius));
        }
    }
    return wish;
}

std::string asked_words(const LightWish& wish) {
    const char* sign = wish.asks == Asks::exactly ? "" : wish.asks == Asks::at_most ? "<=" : ">=";
    return fmt::format("{}{} lx", sign, number(wish.lux));
}

WishTask wish_task(EditSession& session, const Settings& settings, std::span<const LightWish> wishes,
                   std::span<const std::string> kept) {
    WishTask task;
    task.frame = session.world().resource<FrameScene>();
    task.settings = reference::path_settings(settings);
    for (const LightWish& wish : wishes) {
        task.wishes.push_back(
            {wish, wish.of_node ? place_of_node(wish, session, task.frame) : place_of(wish, task.frame)});
    }
    const EditModel& model = session.model();
    std::map<std::uint32_t, std::uint32_t> lights;  // by entity: indices into the frame's
    for (std::uint32_t i = 0; i < task.frame.lights.size(); ++i) {
        lights[task.frame.lights[i].id] = i;
    }
    std::map<std::uint32_t, WishLamp> lamps;  // by the document's light
    std::vector<std::uint32_t> order;
    const std::vector<ecs::Entity> entities = session.entities();
    for (const std::uint32_t node : model.in_order()) {
        const Light* light = light_of(model, node);
        if (light == nullptr || entities[node] == ecs::kNullEntity) {
            continue;
        }
        const auto found = lights.find(entities[node].index);
        if (found == lights.end()) {
            continue;
        }
        const std::uint32_t number = model.node(node).light;
        WishLamp& lamp = lamps[number];
        if (lamp.lights.empty()) {
            lamp.node = node;
            lamp.path = path_of(model, node);
            lamp.intensity = static_cast<double>(light->intensity);
            order.push_back(number);
        }
        lamp.lights.push_back(found->second);
    }
    for (const std::string& path : kept) {
        const std::uint32_t node = session.node_at(path);
        if (light_of(model, node) == nullptr) {
            throw InputError(fmt::format("keep: '{}' has no light, expected a node with one", path));
        }
        std::erase(order, model.node(node).light);
    }
    for (const std::uint32_t number : order) {
        task.lamps.push_back(std::move(lamps[number]));
    }
    if (task.lamps.empty()) {
        throw InputError("solve: found no lamp that may be altered, expected one in the file");
    }
    return task;
}

double WishOutcome::missed_with(double lux) const {
    const double less = wish.lux - lux;
    const bool within =
        (wish.asks == Asks::at_most && less >= 0) || (wish.asks == Asks::at_least && less <= 0);
    return within ? 0 : std::abs(less) * weight_of(wish);
}

bool WishOutcome::met_with(double lux) const {
    return places > 0 && missed_with(lux) <= kWishTolerance + 2 * noise * weight_of(wish);
}

bool WishSolution::all_met() const {
    return std::ranges::all_of(outcomes, [](const WishOutcome& o) { return o.met(); });
}

std::vector<std::string> WishSolution::commands() const {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < lamps.size(); ++i) {
        if (std::abs(intensities[i] - lamps[i].intensity) >
            kSame * std::max(intensities[i], lamps[i].intensity)) {
            lines.push_back(fmt::format("set {} light.intensity {}", word(lamps[i].path),
                                        number(static_cast<float>(intensities[i]))));
        }
    }
    return lines;
}

WishSolution solve_wishes(const WishTask& task, const WishEffort& effort) {
    const std::size_t count = task.lamps.size();
    const std::vector<double> traced = traced_intensities(task.lamps);
    FrameScene frame = task.frame;
    std::vector<int> lamp_of(frame.lights.size(), -1);
    std::vector<double> now;
    for (std::size_t i = 0; i < count; ++i) {
        for (const std::uint32_t light : task.lamps[i].lights) {
            frame.lights[light].light.intensity = static_cast<float>(traced[i]);
            lamp_of[light] = static_cast<int>(i);
        }
        now.push_back(task.lamps[i].intensity / traced[i]);
    }
    const LightSplitter splitter(frame, task.settings);
    std::vector<Given> lights;
    lights.reserve(task.wishes.size());
    for (const PlacedWish& wish : task.wishes) {
        lights.push_back(light_at(wish, splitter, lamp_of, count, effort));
    }
    const std::vector<double> factors = factors_for(task.wishes, lights, now);
    WishSolution solution;
    solution.lamps = task.lamps;
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        solution.intensities.push_back(factors[i] * traced[i]);
    }
    for (std::size_t w = 0; w < task.wishes.size(); ++w) {
        const Given& light = lights[w];
        WishOutcome outcome;
        outcome.wish = task.wishes[w].wish;
        outcome.places = light.places;
        outcome.before = outcome.reached = light.rest;
        double variance = light.rest_noise * light.rest_noise;
        for (std::size_t i = 0; i < count; ++i) {
            outcome.before += now[i] * light.by_lamp[i];
            outcome.reached += factors[i] * light.by_lamp[i];
            variance += std::pow(factors[i] * light.noise[i], 2);
            outcome.lit = outcome.lit || light.by_lamp[i] > kSeen * light.noise[i];
        }
        outcome.noise = std::sqrt(variance);
        squares += outcome.missed() * outcome.missed();
        solution.outcomes.push_back(outcome);
    }
    solution.residual =
        std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, task.wishes.size())));
    return solution;
}

std::string outcome_words(const WishOutcome& o) {
    if (o.places == 0) {
        return fmt::format("{}: asked {}: no surface is there", o.wish.where, asked_words(o.wish));
    }
    using workbench::lux_text;
    std::string words =
        fmt::format("{}: asked {}, has {}, gets {} +- {}: ", o.wish.where, asked_words(o.wish),
                    lux_text(o.before), lux_text(o.reached), lux_text(o.noise));
    if (o.met()) {
        return words + "met";
    }
    words += fmt::format("missed by {:.0f} %", 100 * o.missed());
    return o.lit ? words : words + ", no lamp lights it";
}

std::string solution_words(const WishSolution& solution) {
    const auto met = std::ranges::count_if(solution.outcomes, [](const WishOutcome& o) { return o.met(); });
    return fmt::format("{} of {} wishes met, missed by {:.2g} % (root mean square)", met,
                       solution.outcomes.size(), 100 * solution.residual);
}

}  // namespace lanthorn::editor
