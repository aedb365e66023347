// Factors of materials.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/value_info.h"
#include "tools/editor/core/operation.h"

namespace lanthorn::editor {

namespace {

using Json = nlohmann::json;

constexpr double kMost = std::numeric_limits<float>::max();

// A factor of numbers: where it lies, and its range.
struct Factor {
    const char* name;
    float* (*at)(Material&);
    int count;
    double low, high;
};

constexpr std::array kFactors = {
    Factor{"base_colour", [](Material& m) { return &m.base_colour.x; }, 4, 0, 1},
    Factor{"metallic", [](Material& m) { return &m.metallic; }, 1, 0, 1},
    Factor{"roughness", [](Material& m) { return &m.roughness; }, 1, 0, 1},
    Factor{"emissive", [](Material& m) { return &m.emissive.x; }, 3, 0, kMost},
    Factor{"normal_scale", [](Material& m) { return &m.normal_scale; }, 1, -kMost, kMost},
    Factor{"occlusion_strength", [](Material& m) { return &m.occlusion_strength; }, 1, 0, 1},
    Factor{"alpha_cutoff", [](Material& m) { return &m.alpha_cutoff; }, 1, 0, 1},
    Factor{"ior", [](Material& m) { return &m.ior; }, 1, 1, 1e3},
    Factor{"specular", [](Material& m) { return &m.specular; }, 1, 0, 1},
    Factor{"specular_colour", [](Material& m) { return &m.specular_colour.x; }, 3, 0, kMost},
    Factor{"transmission", [](Material& m) { return &m.transmission; }, 1, 0, 1},
    Factor{"thickness", [](Material& m) { return &m.thickness; }, 1, 0, kMost},
    Factor{"attenuation_distance", [](Material& m) { return &m.attenuation_distance; }, 1, 0, kMost},
    Factor{"attenuation_colour", [](Material& m) { return &m.attenuation_colour.x; }, 3, 0, 1},
};

struct Flag {
    const char* name;
    bool Material::*member;
};
constexpr std::array kFlags = {Flag{"double_sided", &Material::double_sided},
                               Flag{"unlit", &Material::unlit}};

std::string names() {
    std::vector<std::string> all;
    all.reserve(kFactors.size() + kFlags.size());
    for (const Factor& factor : kFactors) {
        all.emplace_back(factor.name);
    }
    for (const Flag& flag : kFlags) {
        all.emplace_back(flag.name);
    }
    return fmt::format("{}", fmt::join(all, ", "));
}

std::string written(const float* values, int count) {
    if (count == 1) {
        return number(*values);
    }
    std::vector<std::string> all;
    all.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        all.push_back(number(values[i]));
    }
    return fmt::format("[{}]", fmt::join(all, ","));
}

void set_factor(Operation& op, Material& material, const Factor& factor, const Json& value) {
    float* at = factor.at(material);
    const auto refuse = [&] {
        op.refuse(fmt::format("{} is {}, expected {} from {} to {}", factor.name, value.dump(),
                              factor.count == 1 ? "a number" : fmt::format("{} numbers", factor.count),
                              factor.low, factor.high));
    };
    op.result.before = written(at, factor.count);
    const bool fits = factor.count == 1
                          ? value.is_number()
                          : value.is_array() && value.size() == static_cast<std::size_t>(factor.count);
    if (!fits) {
        refuse();
    }
    for (int i = 0; i < factor.count; ++i) {
        const Json& entry = factor.count == 1 ? value : value[static_cast<std::size_t>(i)];
        if (!entry.is_number() ||
            !(entry.get<double>() >= factor.low && entry.get<double>() <= factor.high)) {
            refuse();
        }
        at[i] = entry.get<float>();
    }
    op.result.after = written(at, factor.count);
}

}  // namespace

std::string factor_of(const Material& material, std::string_view field) {
    Material copy = material;
    for (const Factor& factor : kFactors) {
        if (field == factor.name) {
            return written(factor.at(copy), factor.count);
        }
    }
    for (const Flag& flag : kFlags) {
        if (field == flag.name) {
            return material.*(flag.member) ? "true" : "false";
        }
    }
    throw InputError(fmt::format("found '{}', expected one of {}", field, names()));
}

std::string material_name(const EditModel& model, std::uint32_t material) {
    const std::string& own = model.materials.at(material)->name;
    std::size_t same = 0;
    for (const auto& other : model.materials) {
        same += other != nullptr && other->name == own ? 1 : 0;
    }
    return own.empty() || same > 1 || own.find('#') != std::string::npos ? fmt::format("{}#{}", own, material)
                                                                         : own;
}

std::uint32_t material_named(const EditModel& model, std::string_view name) {
    std::string nearest;
    std::size_t distance = std::max<std::size_t>(2, name.size() / 2) + 1;
    for (std::uint32_t i = 0; i < model.materials.size(); ++i) {
        if (model.materials[i] == nullptr) {
            continue;
        }
        const std::string known = material_name(model, i);
        if (known == name) {
            return i;
        }
        if (const std::size_t d = edit_distance(known, name); d < distance) {
            distance = d;
            nearest = known;
        }
    }
    throw InputError(fmt::format("found no material '{}'{}", name,
                                 nearest.empty() ? "" : fmt::format("; '{}' comes nearest", nearest)));
}

void apply_material(Operation& op) {
    op.expect_count({3});
    const std::uint32_t index = material_named(op.model, op.word_at(1));
    const std::string field = op.word_at(2);
    const Json value = parse_json(json_of(op.word_at(3)), field);
    Material material = *op.model.materials[index];
    const auto factor =
        std::ranges::find(kFactors, field, [](const Factor& f) { return std::string(f.name); });
    const auto flag = std::ranges::find(kFlags, field, [](const Flag& f) { return std::string(f.name); });
    if (factor != kFactors.end()) {
        set_factor(op, material, *factor, value);
    } else if (flag != kFlags.end()) {
        if (!value.is_boolean()) {
            op.refuse(fmt::format("{} is {}, expected true or false", field, value.dump()));
        }
        op.result.before = material.*(flag->member) ? "true" : "false";
        material.*(flag->member) = value.get<bool>();
        op.result.after = value.dump();
    } else {
        op.refuse(fmt::format("found '{}', expected one of {}", field, names()));
    }
    op.result.path = "material " + material_name(op.model, index);
    op.say({word(material_name(op.model, index)), field, op.result.after});
    op.model.materials[index] = std::make_shared<const Material>(std::move(material));
}

}  // namespace lanthorn::editor
