#include "tests/unit/editor/random_commands.h"

#include <fmt/format.h>

#include <vector>

#include "tools/editor/core/command.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/operation.h"

namespace lanthorn::testing_tools {

using editor::EditModel;

std::uint64_t Dice::next() {
    state_ += 0x9e3779b97f4a7c15u;  // Steele, Lea and Flood 2014
    std::uint64_t z = state_;
    z = (z ^ (z >> 30u)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27u)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31u);
}

double Dice::between(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 11u) * 0x1p-53;
}

namespace {

std::uint32_t any_node(const EditModel& model, Dice& dice) {
    const std::vector<std::uint32_t> all = model.in_order();
    return all[dice.below(all.size())];
}

std::uint32_t any_light(const EditModel& model, Dice& dice) {
    std::vector<std::uint32_t> lit;
    for (const std::uint32_t node : model.in_order()) {
        if (editor::light_of(model, node) != nullptr) {
            lit.push_back(node);
        }
    }
    return lit.empty() ? kNone : lit[dice.below(lit.size())];
}

std::string move(const EditModel& model, Dice& dice, std::uint32_t node) {
    const dvec3 at = model.node(node).local.translation;
    return fmt::format("move {} {} {} {}", editor::word(editor::path_of(model, node)),
                       at.x + dice.between(-0.5, 0.5), at.y + dice.between(-0.2, 0.2),
                       at.z + dice.between(-0.5, 0.5));
}

std::string paint(const EditModel& model, Dice& dice) {
    std::vector<std::uint32_t> there;
    for (std::uint32_t i = 0; i < model.materials.size(); ++i) {
        if (model.materials[i] != nullptr) {
            there.push_back(i);
        }
    }
    if (there.empty()) {
        return "scale-lights 1.01";
    }
    const std::string name = editor::word(editor::material_name(model, there[dice.below(there.size())]));
    return dice.below(2) == 0
               ? fmt::format("set-material {} roughness {}", name, dice.between(0.2, 1))
               : fmt::format("set-material {} base_colour [{},{},{},1]", name, dice.between(0.1, 0.9),
                             dice.between(0.1, 0.9), dice.between(0.1, 0.9));
}

}  // namespace

std::string random_command(const EditModel& model, Dice& dice) {
    const std::uint32_t node = any_node(model, dice);
    const std::string path = editor::word(editor::path_of(model, node));
    const std::uint32_t light = any_light(model, dice);
    const std::string lamp = light == kNone ? path : editor::word(editor::path_of(model, light));
    switch (dice.below(15)) {
        case 0:
        case 1:
            return move(model, dice, node);
        case 2:
            return fmt::format("rotate {} {} {} {}", path, dice.between(-20, 20), dice.between(-180, 180), 0);
        case 3:
            return fmt::format("scale {} {}", path, dice.between(0.7, 1.3));
        case 4:
            return light == kNone ? move(model, dice, node) : move(model, dice, light);
        case 5:
            return fmt::format("set {} light.intensity {}", lamp, dice.between(20, 400));
        case 6:
            return fmt::format("set {} light.colour {:.0f}K", lamp, dice.between(1500, 9000));
        case 7:
            return paint(model, dice);
        case 8:
            return fmt::format("add-light / lamp{} point {} {} {}", dice.below(1000), dice.between(-1, 1),
                               dice.between(1, 2), dice.between(-1, 1));
        case 9:
            return fmt::format("duplicate {}", path);
        case 10:
            return dice.below(3) == 0 ? fmt::format("delete {}", path) : move(model, dice, node);
        case 11:
            return fmt::format("rename {} \"thing {}\"", path, dice.below(1000));
        case 12: {
            const std::uint32_t parent = any_node(model, dice);
            return fmt::format("reparent {} {}", path, editor::word(editor::path_of(model, parent)));
        }
        case 13:
            return fmt::format("{} {}", dice.below(2) == 0 ? "hide" : "show", path);
        default:
            return fmt::format("set {} extras.note {{\"count\":{}}}", path, dice.below(100));
    }
}

}  // namespace lanthorn::testing_tools
