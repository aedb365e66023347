#include "lanthorn/physics/physics_extras.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

namespace lanthorn::physics {

namespace {

using nlohmann::json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The fields of one object, each asked for by its name.
class Fields {
  public:
    Fields(const json& object, std::string where, std::vector<std::string>& problems)
        : object_(object), where_(std::move(where)), problems_(problems) {
        if (!object.is_object()) {
            wrong(where_, object, "an object");
        }
    }

    bool good() const { return good_; }

    // `above`: the bound itself is too small.
    std::optional<double> number(const char* key, double least, double most, const char* expected,
                                 bool above = false) {
        const json* value = find(key);
        if (value == nullptr) {
            return std::nullopt;
        }
        const double x = value->is_number() ? value->get<double>() : std::nan("");
        if (!std::isfinite(x) || x < least || x > most || (above && x == least)) {
            wrong(where_ + "." + key, *value, expected);
            return std::nullopt;
        }
        return x;
    }

    std::optional<dvec3> vector(const char* key, double above, const char* expected) {
        const json* value = find(key);
        if (value == nullptr) {
            return std::nullopt;
        }
        const auto fits = [&](const json& v) {
            return v.is_number() && std::isfinite(v.get<double>()) && v.get<double>() > above;
        };
        if (!value->is_array() || value->size() != 3 || !std::ranges::all_of(*value, fits)) {
            wrong(where_ + "." + key, *value, expected);
            return std::nullopt;
        }
        return dvec3((*value)[0].get<double>(), (*value)[1].get<double>(), (*value)[2].get<double>());
    }

    template <class E, std::size_t N>
    E choice(const char* key, const std::array<std::pair<const char*, E>, N>& choices) {
        const json* value = find(key);
        if (value == nullptr) {
            return choices[0].second;
        }
        std::string names;
        for (const auto& [name, result] : choices) {
            if (value->is_string() && value->get_ref<const std::string&>() == name) {
                return result;
            }
            names += fmt::format("{}'{}'", names.empty() ? "one of " : ", ", name);
        }
        wrong(where_ + "." + key, *value, names.c_str());
        return choices[0].second;
    }

    // After all known fields were asked for.
    void name_the_rest() {
        for (const auto& [key, value] : object_.items()) {
            if (object_.is_object() && std::ranges::find(known_, key) == known_.end()) {
                problems_.push_back(fmt::format("{}.{} is not known, ignored", where_, key));
            }
        }
    }

    void wrong(const std::string& place, const json& found, const char* expected) {
        good_ = false;
        problems_.push_back(fmt::format("{} is {}, expected {}: skipped", place,
                                        found.dump(-1, ' ', false, json::error_handler_t::replace),
                                        expected));
    }

  private:
    const json* find(const char* key) {
        known_.emplace_back(key);
        const auto at = object_.find(key);
        return object_.is_object() && at != object_.end() ? &*at : nullptr;
    }

    const json& object_;
    std::string where_;
    std::vector<std::string>& problems_;
    std::vector<std::string> known_;
    bool good_ = true;
};

std::optional<BodyDescription> read_body(const json& object, std::vector<std::string>& problems) {
    Fields fields(object, "body", problems);
    BodyDescription body;
    body.type = fields.choice<BodyType, 3>(
        "type",
        {{{"static", BodyType::fixed}, {"dynamic", BodyType::dynamic}, {"kinematic", BodyType::kinematic}}});
    body.shape = fields.choice<BodyShape, 5>("shape", {{{"box", BodyShape::box},
                                                        {"sphere", BodyShape::sphere},
                                                        {"capsule", BodyShape::capsule},
                                                        {"convex", BodyShape::convex},
                                                        {"mesh", BodyShape::mesh}}});
    const double least_mass = body.type == BodyType::dynamic ? 0 : -kInfinity;  // others have none
    body.mass = fields.number("mass", least_mass, kInfinity, "kilograms, more than 0", true).value_or(1);
    body.friction = fields.number("friction", 0, kInfinity, "a number of 0 or more").value_or(0.5);
    body.restitution = fields.number("restitution", 0, 1, "a number from 0 to 1").value_or(0);
    body.size = fields.vector("size", 0, "three numbers more than 0");
    body.radius = fields.number("radius", 0, kInfinity, "metres, more than 0", true);
    body.height = fields.number("height", 0, kInfinity, "metres, more than 0", true);
    body.centre = fields.vector("centre", -kInfinity, "three numbers");
    if (body.shape == BodyShape::mesh && body.type == BodyType::dynamic) {
        fields.wrong("body.shape", object["shape"], "'convex' or a simple shape for a dynamic body");
    }
    fields.name_the_rest();
    return fields.good() ? std::optional(body) : std::nullopt;
}

std::optional<CharacterDescription> read_character(const json& object, std::vector<std::string>& problems) {
    Fields fields(object, "character", problems);
    CharacterDescription c;
    const double right_angle = 0.5 * static_cast<double>(kPi);
    c.radius = fields.number("radius", 0, kInfinity, "metres, more than 0", true).value_or(c.radius);
    c.height = fields.number("height", 0, kInfinity, "metres, more than 0", true).value_or(c.height);
    c.step_height = fields.number("stepHeight", 0, kInfinity, "metres, 0 or more").value_or(c.step_height);
    c.slope_limit =
        fields.number("slopeLimit", 0, right_angle, "radians from 0 to pi/2").value_or(c.slope_limit);
    c.jump_speed = fields.number("jumpSpeed", 0, kInfinity, "m/s, 0 or more").value_or(c.jump_speed);
    if (fields.good() && c.height < 2 * c.radius) {
        fields.wrong("character.height", c.height, "at least twice the radius");
    }
    fields.name_the_rest();
    return fields.good() ? std::optional(c) : std::nullopt;
}

}  // namespace

PhysicsExtras read_extras(std::string_view text) {
    PhysicsExtras result;
    const json extras = json::parse(text, nullptr, false);
    if (extras.is_discarded()) {
        result.problems.emplace_back("extras are not JSON, expected an object: skipped");
        return result;
    }
    if (!extras.is_object()) {
        return result;  // somebody else's
    }
    if (const auto body = extras.find("body"); body != extras.end()) {
        result.body = read_body(*body, result.problems);
    }
    if (const auto character = extras.find("character"); character != extras.end()) {
        result.character = read_character(*character, result.problems);
    }
    if (result.body && result.character) {
        result.body.reset();
        result.problems.emplace_back("body beside character, expected one of them: the body skipped");
    }
    return result;
}

}  // namespace lanthorn::physics
