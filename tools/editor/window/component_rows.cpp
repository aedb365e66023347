#include "tools/editor/window/component_rows.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "tools/editor/window/lines.h"

namespace lanthorn::edit_window {

using ecs::Field;
using ecs::ValueKind;
using ecs::ValueType;

namespace {

struct Walk {
    ValueFields& fields;
    const SetField& set;
};

std::string words_of(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

// The same place in each of the values.
std::vector<const void*> at_offset(std::span<const void* const> values, std::size_t offset) {
    std::vector<const void*> inner;
    for (const void* value : values) {
        inner.push_back(ecs::at(value, offset));
    }
    return inner;
}

void number_row(const Walk& walk, const Field& field, const std::string& path,
                std::span<const void* const> values, const void* initial) {
    const ValueType& type = *field.type;
    const bool degrees = field.unit == "rad";
    const double to = degrees ? 180.0 / static_cast<double>(kPi) : 1;
    NumberRow row;
    row.label = words_of(field.name);
    row.value = to * ecs::number_of(type, values.front());
    row.unit = degrees ? "\u00b0" : field.unit;
    row.mixed = std::ranges::any_of(values, [&](const void* value) {
        return ecs::number_of(type, value) != ecs::number_of(type, values.front());
    });
    row.lower = field.lower > -1e300 ? to * field.lower : field.lower;
    row.upper = field.upper < 1e300 ? to * field.upper : field.upper;
    if (initial != nullptr) {
        row.initial = to * ecs::number_of(type, initial);
    }
    row.step = type.kind == ValueKind::integer                            ? 0.1
               : field.has_range() && row.upper < 1e6 && row.lower > -1e6 ? (row.upper - row.lower) / 300
                                                                          : 0.01;
    row.words = field.words;
    const NumberChange change = walk.fields.number(row);
    if (change.doing != Doing::nothing) {
        const double value = type.kind == ValueKind::integer ? std::round(change.value) : change.value / to;
        walk.set(change.doing, path, json_number(value));
    }
}

// A field that is text, a list or something to be typed as JSON.
void text_row(const Walk& walk, const Field& field, const std::string& path, std::string shown,
              bool is_text) {
    if (walk.fields.text(words_of(field.name), shown, field.words)) {
        walk.set(Doing::done, path, is_text ? json_text(shown) : shown);
    }
}

void fields_of(const Walk& walk, const ValueType& type, const std::string& path,
               std::span<const void* const> values, const void* initial);

void field_rows(const Walk& walk, const Field& field, const std::string& path,
                std::span<const void* const> values, const void* initial) {
    const ValueType& type = *field.type;
    switch (type.kind) {
        case ValueKind::boolean: {
            bool on = *static_cast<const bool*>(values.front());
            if (walk.fields.flag(words_of(field.name), on, field.words)) {
                walk.set(Doing::done, path, on ? "true" : "false");
            }
            return;
        }
        case ValueKind::integer:
        case ValueKind::real:
            number_row(walk, field, path, values, initial);
            return;
        case ValueKind::enumeration: {
            int now = static_cast<int>(ecs::number_of(type, values.front()));
            const bool same = std::ranges::all_of(values, [&](const void* value) {
                return static_cast<int>(ecs::number_of(type, value)) == now;
            });
            int chosen = same ? now : -1;
            if (walk.fields.choice(words_of(field.name), field.choices, chosen, field.words)) {
                walk.set(Doing::done, path, json_text(field.choices[static_cast<std::size_t>(chosen)]));
            }
            return;
        }
        case ValueKind::text:
            text_row(walk, field, path, *static_cast<const std::string*>(values.front()), true);
            return;
        case ValueKind::numbers: {
            if (type.numbers == 3 && type.element != nullptr && type.element->kind == ValueKind::real) {
                const auto vector_at = [&](const void* value) {
                    dvec3 v(0);
                    for (std::size_t i = 0; i < 3; ++i) {
                        v[static_cast<glm::length_t>(i)] =
                            ecs::number_of(*type.element, ecs::at(value, i * type.element->size));
                    }
                    return v;
                };
                dvec3 v = vector_at(values.front());
                const bool mixed =
                    std::ranges::any_of(values, [&](const void* value) { return vector_at(value) != v; });
                int which = -1;
                const NumberChange change =
                    walk.fields.vector(words_of(field.name), v, field.unit, 0.01, mixed, field.words, which);
                if (which >= 0) {
                    v[which] =
                        std::clamp(change.value, std::max(field.lower, -1e30), std::min(field.upper, 1e30));
                    walk.set(change.doing, path,
                             fmt::format("[{},{},{}]", json_number(v.x), json_number(v.y), json_number(v.z)));
                }
                return;
            }
            std::vector<std::string> shown;
            for (std::size_t i = 0; i < type.numbers; ++i) {
                const void* at = ecs::at(values.front(), i * type.element->size);
                shown.push_back(json_number(ecs::number_of(*type.element, at)));
            }
            text_row(walk, field, path, fmt::format("[{}]", fmt::join(shown, ",")), false);
            return;
        }
        case ValueKind::structure:
            ImGui::TextDisabled("  %s", words_of(field.name).c_str());
            fields_of(walk, type, path, values, initial);
            return;
        case ValueKind::list:
        case ValueKind::entity:
        case ValueKind::opaque:
            return;
    }
}

void fields_of(const Walk& walk, const ValueType& type, const std::string& path,
               std::span<const void* const> values, const void* initial) {
    for (const Field& field : type.fields) {
        if (field.runtime || field.transient || field.type == nullptr) {
            continue;
        }
        const std::vector<const void*> inner = at_offset(values, field.offset);
        const void* usual = initial != nullptr ? ecs::at(initial, field.offset) : nullptr;
        if (field.flat) {
            fields_of(walk, *field.type, path, inner, usual);
        } else {
            field_rows(walk, field, path + "." + field.name, inner, usual);
        }
    }
}

}  // namespace

void draw_component(ValueFields& fields, const ecs::ComponentType& type, std::span<const void* const> values,
                    const SetField& set) {
    if (type.opaque || type.value == nullptr || values.empty()) {
        return;
    }
    ImGui::PushID(type.name.c_str());
    fields_of({fields, set}, *type.value, type.name, values, type.initial.get());
    ImGui::PopID();
}

}  // namespace lanthorn::edit_window
