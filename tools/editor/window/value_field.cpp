#include "tools/editor/window/value_field.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "lanthorn/core/colour.h"
#include "tools/editor/window/quantity.h"
#include "tools/editor/window/style.h"

namespace lanthorn::edit_window {

namespace {

void hint(const std::string& words) {
    if (!words.empty() && ImGui::IsItemHovered() && !ImGui::IsAnyItemActive()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
        ImGui::TextUnformatted(words.c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
}

}  // namespace

void ValueFields::name(const std::string& label, const std::string& words, bool differs) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    ImGui::InvisibleButton(label.c_str(), {names_, height});
    const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(at, {at.x + names_ - 4, at.y + height}, true);
    list.AddText({at.x + 10 * unit_, at.y + ImGui::GetStyle().FramePadding.y},
                 hot ? colour::words : colour::faint, label.c_str());
    if (differs) {
        list.AddCircleFilled({at.x + 4 * unit_, at.y + height / 2}, 2 * unit_, colour::chosen, 8);
    }
    list.PopClipRect();
    hint(words);
}

NumberChange ValueFields::drag(unsigned id, const NumberRow& row) {
    NumberChange change{Doing::nothing, row.value, ""};
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
    if (ImGui::IsItemActivated()) {
        dragged_ = id;
        from_ = at_ = std::isfinite(row.value) ? row.value : std::min(row.upper, 10.0);
        dropped_ = moved_ = false;
    }
    if (dragged_ != id) {
        return change;
    }
    if (dropped_ || !ImGui::IsItemActive()) {
        change.value = at_;
        change.doing = !moved_ ? Doing::nothing : dropped_ ? Doing::dropped : Doing::done;
        dragged_ = 0;
        dropped_ = false;
        if (ImGui::IsMouseDoubleClicked(0) && row.initial) {
            return {Doing::done, *row.initial, ""};
        }
        return change;
    }
    if (row.initial && ImGui::IsMouseDoubleClicked(0)) {
        dragged_ = 0;
        return {Doing::done, *row.initial, ""};
    }
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseDelta.x != 0) {
        moved_ = true;
        const double pixels = static_cast<double>(io.MouseDelta.x / unit_) * (io.KeyShift ? 0.1 : 1);
        at_ = row.logarithmic ? std::max(at_, 1e-4) * std::exp(row.step * pixels) : at_ + row.step * pixels;
        at_ = std::clamp(at_, row.lower, row.upper);
    }
    change.value = at_;
    if (io.KeyCtrl) {
        // Two digits of the step's size.
        const double unit =
            row.logarithmic ? std::pow(10, std::floor(std::log10(std::max(at_, 1e-4))) - 1) : row.step * 10;
        change.value = std::clamp(unit * std::round(at_ / unit), row.lower, row.upper);
    }
    change.doing = moved_ ? Doing::dragging : Doing::nothing;
    return change;
}

NumberChange ValueFields::field(const char* id, const NumberRow& row, float width) {
    NumberChange change{Doing::nothing, row.value, ""};
    std::array<char, 96> buffer{};
    const unsigned own = ImGui::GetID(id);
    const double shown = row.value;
    const std::string text = row.mixed
                                 ? std::string("mixed")
                                 : shown_number(shown, row.digits) + (row.unit.empty() ? "" : " " + row.unit);
    std::strncpy(buffer.data(), text.c_str(), buffer.size() - 1);
    ImGui::SetNextItemWidth(width);
    if (row.mixed) {
        ImGui::PushStyleColor(ImGuiCol_Text, colour::faint);
    }
    const bool entered =
        ImGui::InputText(id, buffer.data(), buffer.size(),
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (row.mixed) {
        ImGui::PopStyleColor();
    }
    if (ImGui::IsItemActive()) {
        typed_in_ = own;
        typed_ = buffer.data();
    }
    const bool left = ImGui::IsItemDeactivatedAfterEdit() && typed_in_ == own;
    if (!entered && !left) {
        return change;
    }
    const std::string typed = entered ? buffer.data() : typed_;
    typed_in_ = 0;
    if (typed == text) {
        return change;
    }
    const auto quantity = typed_quantity(typed);
    if (!quantity) {
        return change;
    }
    if (const auto value = typed_number(typed, row.unit)) {
        change.value = std::clamp(*value, row.lower, row.upper);
    } else {
        change.value = quantity->value;
        change.unit = quantity->unit;
    }
    change.doing = Doing::done;
    return change;
}

NumberChange ValueFields::number(const NumberRow& row) {
    ImGui::PushID(row.label.c_str());
    const bool differs = row.initial && !row.mixed && std::abs(*row.initial - row.value) > 1e-9;
    std::string words = row.words;
    if (row.lower > std::numeric_limits<double>::lowest() || row.upper < std::numeric_limits<double>::max()) {
        words += fmt::format("{}{} to {} {}", words.empty() ? "" : "\n", shown_number(row.lower),
                             row.upper < 1e30 ? shown_number(row.upper) : "any", row.unit);
    }
    if (row.initial) {
        words += fmt::format("\ndefault {} (double click)", shown_number(*row.initial));
    }
    name(row.label, words, differs);
    NumberChange change = drag(ImGui::GetID(row.label.c_str()), row);
    ImGui::SameLine(0, 0);
    NumberRow shown = row;
    if (change.doing == Doing::dragging) {
        shown.value = change.value;
        shown.mixed = false;
    }
    const NumberChange typed = field("##value", shown, ImGui::GetContentRegionAvail().x);
    ImGui::PopID();
    return typed.doing == Doing::done ? typed : change;
}

NumberChange ValueFields::vector(const std::string& label, const dvec3& value, const std::string& unit,
                                 double step, bool mixed, const std::string& words, int& which) {
    ImGui::PushID(label.c_str());
    const float usual = std::exchange(names_, 0.55f * names_);
    name(label, words, false);
    // The name drags nothing: there are three of them.
    const float gap = 2 * unit_;
    const float width = (ImGui::GetContentRegionAvail().x - names_ - 2 * gap) / 3;
    names_ = usual;
    NumberChange change;
    which = -1;
    ImGui::SameLine(0, 0);
    for (int i = 0; i < 3; ++i) {
        ImGui::PushID(i);
        NumberRow row{std::string(1, static_cast<char>('x' + i)), value[i], "", mixed};
        row.step = step;
        row.digits = 4;
        (void)unit;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float letter = 10 * unit_;
        ImGui::InvisibleButton("##letter", {letter, ImGui::GetFrameHeight()});
        constexpr std::array kShades = {colour::x_axis, colour::y_axis, colour::z_axis};
        ImGui::GetWindowDrawList()->AddText({at.x + 1, at.y + ImGui::GetStyle().FramePadding.y},
                                            kShades[static_cast<std::size_t>(i)], row.label.c_str());
        const NumberChange dragged = drag(ImGui::GetID("drag"), row);
        NumberRow shown = row;
        if (dragged.doing == Doing::dragging) {
            shown.value = dragged.value;
            shown.mixed = false;
        }
        ImGui::SameLine(0, 0);
        const NumberChange typed = field("##value", shown, width - letter);
        if (typed.doing == Doing::done || dragged.doing != Doing::nothing) {
            change = typed.doing == Doing::done ? typed : dragged;
            which = i;
        }
        if (i < 2) {
            ImGui::SameLine(0, gap);
        }
        ImGui::PopID();
    }
    ImGui::PopID();
    return change;
}

bool ValueFields::choice(const std::string& label, const std::vector<std::string>& names, int& value,
                         const std::string& words) {
    ImGui::PushID(label.c_str());
    name(label, words, false);
    ImGui::SameLine(0, 0);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    bool changed = false;
    const bool known = value >= 0 && value < static_cast<int>(names.size());
    if (ImGui::BeginCombo("##choice", known ? names[static_cast<std::size_t>(value)].c_str() : "mixed")) {
        for (int i = 0; i < static_cast<int>(names.size()); ++i) {
            if (ImGui::Selectable(names[static_cast<std::size_t>(i)].c_str(), i == value) && i != value) {
                value = i;
                changed = true;
            }
        }
        ImGui::EndCombo();
    }
    ImGui::PopID();
    return changed;
}

bool ValueFields::flag(const std::string& label, bool& value, const std::string& words) {
    ImGui::PushID(label.c_str());
    name(label, words, false);
    ImGui::SameLine(0, 0);
    const bool changed = ImGui::Checkbox("##flag", &value);
    ImGui::PopID();
    return changed;
}

Doing ValueFields::colour(const std::string& label, vec3& value, const std::string& words) {
    ImGui::PushID(label.c_str());
    name(label, words, false);
    ImGui::SameLine(0, 0);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    std::array<float, 3> shown{};
    for (int i = 0; i < 3; ++i) {
        shown[static_cast<std::size_t>(i)] = srgb_from_linear(std::clamp(value[i], 0.0f, 1.0f));
    }
    const bool edited = ImGui::ColorEdit3(
        "##colour", shown.data(), ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueWheel);
    if (edited) {
        for (int i = 0; i < 3; ++i) {
            colour_[i] = linear_from_srgb(shown[static_cast<std::size_t>(i)]);
        }
    }
    Doing doing = edited ? Doing::dragging : Doing::nothing;
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        doing = Doing::done;
    }
    if (doing != Doing::nothing) {
        value = colour_;
    }
    ImGui::PopID();
    return doing;
}

bool ValueFields::text(const std::string& label, std::string& value, const std::string& words) {
    ImGui::PushID(label.c_str());
    name(label, words, false);
    ImGui::SameLine(0, 0);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    std::array<char, 512> buffer{};
    std::strncpy(buffer.data(), value.c_str(), buffer.size() - 1);
    const unsigned own = ImGui::GetID("##text");
    const bool entered =
        ImGui::InputText("##text", buffer.data(), buffer.size(),
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemActive()) {
        typed_in_ = own;
        typed_ = buffer.data();
    }
    const bool left = ImGui::IsItemDeactivatedAfterEdit() && typed_in_ == own;
    const std::string typed = entered ? buffer.data() : typed_;
    ImGui::PopID();
    if ((!entered && !left) || typed == value) {
        return false;
    }
    typed_in_ = 0;
    value = typed;
    return true;
}

}  // namespace lanthorn::edit_window
