#include "tools/editor/window/panel_painter.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "lanthorn/replay/content_hash.h"

namespace lanthorn::edit_window {

namespace {

template <class T>
std::uint64_t hash_of(const T* values, std::size_t count) {
    return count == 0 ? 0 : replay::hash_bytes(std::as_bytes(std::span(values, count)));
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t more) {
    const std::uint64_t both[] = {hash, more};
    return hash_of(both, 2);
}

Box around(const Box& a, const Box& b) {
    if (a.empty() || b.empty()) {
        return a.empty() ? b : a;
    }
    const float x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

Box box_of(const ImVec4& clip) {
    return {clip.x, clip.y, clip.z - clip.x, clip.w - clip.y};
}

// Whole pixels.
Box rounded(const Box& box) {
    const float x = std::floor(box.x), y = std::floor(box.y);
    return {x, y, std::ceil(box.x + box.width) - x, std::ceil(box.y + box.height) - y};
}

// What a list draws, and where; drawn without a texture of its own it has ImGui's letters alone.
std::uint64_t hash_of(const ImDrawList& list, std::uint64_t pictures) {
    std::uint64_t hash = mixed(hash_of(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.Size)),
                               hash_of(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.Size)));
    const ImTextureID letters = ImGui::GetIO().Fonts->TexID;
    for (const ImDrawCmd& command : list.CmdBuffer) {
        const ImVec4& c = command.ClipRect;
        const float clip[] = {c.x, c.y, c.z, c.w};
        hash = mixed(hash, hash_of(clip, 4));
        hash = mixed(hash, std::bit_cast<std::uintptr_t>(command.TextureId));
        hash = mixed(hash, command.ElemCount);
        hash = mixed(hash, command.TextureId != letters ? pictures : 0);
    }
    return hash;
}

void clear(std::span<const PanelPainter::Ground> grounds, const Box& part, ivec2 size) {
    glEnable(GL_SCISSOR_TEST);
    for (const auto& [box, ground] : grounds) {
        const Box seen = common(rounded(box), part);
        if (seen.empty()) {
            continue;
        }
        glScissor(static_cast<int>(seen.x), size.y - static_cast<int>(seen.y + seen.height),
                  static_cast<int>(seen.width), static_cast<int>(seen.height));
        const ImVec4 c = ImGui::ColorConvertU32ToFloat4(ground);
        glClearNamedFramebufferfv(0, GL_COLOR, 0, &c.x);
    }
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace

Box common(const Box& a, const Box& b) {
    const float x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    return {x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
}

std::vector<Box> without_overlaps(std::vector<Box> boxes) {
    for (bool met = true; met;) {
        met = false;
        for (std::size_t i = 0; i < boxes.size() && !met; ++i) {
            for (std::size_t k = i + 1; k < boxes.size() && !met; ++k) {
                if (!common(boxes[i], boxes[k]).empty()) {
                    boxes[i] = around(boxes[i], boxes[k]);
                    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(k));
                    met = true;
                }
            }
        }
    }
    return boxes;
}

// Where a window of ImGui differs from what stands there. Windows that came, went or changed places lie over
// others: all of it then.
std::vector<Box> PanelPainter::differing(const std::vector<Painted>& now, std::uint64_t grounds,
                                         ivec2 size) const {
    const Box all{0, 0, static_cast<float>(size.x), static_cast<float>(size.y)};
    if (size != size_ || grounds != grounds_ ||
        !std::ranges::equal(now, painted_, {}, &Painted::name, &Painted::name)) {
        return {all};
    }
    std::vector<Box> parts;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i].hash != painted_[i].hash) {
            const Box part = common(rounded(around(now[i].box, painted_[i].box)), all);
            if (!part.empty()) {
                parts.push_back(part);
            }
        }
    }
    return without_overlaps(std::move(parts));
}

std::vector<Box> PanelPainter::paint(ImDrawData& made, std::span<const Ground> grounds, ivec2 size,
                                     std::uint64_t pictures, const std::function<void(ImDrawData&)>& draw) {
    const std::span<ImDrawList* const> lists(made.CmdLists, static_cast<std::size_t>(made.CmdListsCount));
    std::vector<Painted> now;
    for (const ImDrawList* list : lists) {
        Painted& painted = now.emplace_back();
        painted.name = list->_OwnerName != nullptr ? list->_OwnerName : "";
        painted.hash = hash_of(*list, pictures);
        for (const ImDrawCmd& command : list->CmdBuffer) {
            painted.box = around(painted.box, box_of(command.ClipRect));
        }
    }
    std::uint64_t of_grounds = 0;
    for (const auto& [box, ground] : grounds) {
        const float place[] = {box.x, box.y, box.width, box.height};
        of_grounds = mixed(mixed(of_grounds, hash_of(place, 4)), ground);
    }
    std::vector<Box> parts = differing(now, of_grounds, size);
    std::vector<std::vector<ImVec4>> clips;
    for (const ImDrawList* list : lists) {
        std::vector<ImVec4>& of_list = clips.emplace_back();
        for (const ImDrawCmd& command : list->CmdBuffer) {
            of_list.push_back(command.ClipRect);
        }
    }
    for (const Box& part : parts) {
        clear(grounds, part, size);
        std::vector<ImDrawList*> there;
        for (std::size_t i = 0; i < lists.size(); ++i) {
            if (common(now[i].box, part).empty()) {
                continue;
            }
            there.push_back(lists[i]);
            for (std::size_t k = 0; k < clips[i].size(); ++k) {
                const Box seen = common(box_of(clips[i][k]), part);
                lists[i]->CmdBuffer[static_cast<int>(k)].ClipRect = {seen.x, seen.y, seen.x + seen.width,
                                                                     seen.y + seen.height};
            }
        }
        ImDrawData some = made;
        some.CmdLists = there.data();
        some.CmdListsCount = static_cast<int>(there.size());
        draw(some);
    }
    for (std::size_t i = 0; i < lists.size(); ++i) {
        for (std::size_t k = 0; k < clips[i].size(); ++k) {
            lists[i]->CmdBuffer[static_cast<int>(k)].ClipRect = clips[i][k];
        }
    }
    painted_ = std::move(now);
    grounds_ = of_grounds;
    size_ = size;
    return parts;
}

}  // namespace lanthorn::edit_window
