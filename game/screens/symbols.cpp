#include "game/screens/symbols.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "game/screens/style.h"

namespace lanthorn::game::ui {

namespace {

constexpr int kMoon = 16;  // pieces of each of its arcs
constexpr float kTurn = 2 * std::numbers::pi_v<float>;

ImVec2 on_circle(float turns, float radius) {
    return {radius * std::sin(kTurn * turns),
            -radius * std::cos(kTurn * turns)};  // from the top, to the right
}

// Corners of a shape of radius 1 around 0, clockwise from the top.
std::vector<ImVec2> outline(Symbol symbol) {
    std::vector<ImVec2> corners;
    const auto regular = [&](int count, float inner) {
        for (int i = 0; i < count; ++i) {
            const float turns = static_cast<float>(i) / static_cast<float>(count);
            corners.push_back(on_circle(turns, i % 2 == 0 ? 1 : inner));
        }
    };
    switch (symbol) {
        case Symbol::circle:
            regular(28, 1);
            break;
        case Symbol::triangle:
            corners = {on_circle(0, 1), on_circle(1.0f / 3, 1), on_circle(2.0f / 3, 1)};
            break;
        case Symbol::square:
            corners = {{-0.8f, -0.8f}, {0.8f, -0.8f}, {0.8f, 0.8f}, {-0.8f, 0.8f}};
            break;
        case Symbol::star:
            regular(10, 0.45f);
            break;
        case Symbol::moon:  // an arc around the left, and a flatter one back
            for (int i = 0; i <= kMoon; ++i) {
                corners.push_back(on_circle(0.06f - 0.62f * static_cast<float>(i) / kMoon, 1));
            }
            for (int i = kMoon - 1; i > 0; --i) {
                const float t = static_cast<float>(i) / kMoon;
                const ImVec2 from = corners.front(), to = corners[kMoon];
                const float bow = 2.2f * t * (1 - t);
                corners.push_back({from.x + t * (to.x - from.x) - bow, from.y + t * (to.y - from.y)});
            }
            break;
        case Symbol::drop:
            corners.push_back({0, -1.15f});
            for (int i = 0; i <= 18; ++i) {
                const ImVec2 at = on_circle(0.14f + 0.72f * static_cast<float>(i) / 18, 0.72f);
                corners.push_back({at.x, at.y + 0.28f});
            }
            break;
    }
    return corners;
}

}  // namespace

void draw_charge(ImDrawList& draw, const ImVec2& centre, float radius, float charge) {
    const float line = std::max(2.0f, 0.16f * radius);
    draw.AddCircle(centre, radius, night(0.55f), 40, 2 * line);
    draw.PathArcTo(centre, radius, -0.25f * kTurn, (charge - 0.25f) * kTurn, 40);
    draw.PathStroke(lamplight(), 0, line);
}

void draw_symbol(ImDrawList& draw, Symbol symbol, const ImVec2& centre, float radius, float charge) {
    draw.AddCircleFilled(centre, 1.75f * radius, night(0.72f), 40);
    std::vector<ImVec2> corners = outline(symbol);
    for (ImVec2& corner : corners) {
        corner = {centre.x + 0.85f * radius * corner.x, centre.y + 0.85f * radius * corner.y};
    }
    const float line = std::max(1.5f, 0.14f * radius);
    if (charge >= 1) {
        // Triangles from the middle, or of a moon from one arc to the other: none of them has to be convex.
        const std::size_t count = corners.size();
        for (std::size_t i = 0; i < (symbol == Symbol::moon ? kMoon : count); ++i) {
            const std::size_t next = (i + 1) % count;
            if (symbol == Symbol::moon) {
                draw.AddQuadFilled(corners[i], corners[next], corners[(count - next) % count],
                                   corners[(count - i) % count], lamplight());
            } else {
                draw.AddTriangleFilled(centre, corners[i], corners[next], lamplight());
            }
        }
    }
    draw.AddPolyline(corners.data(), static_cast<int>(corners.size()),
                     charge >= 1 ? lamplight() : parchment(), ImDrawFlags_Closed, line);
    if (charge > 0) {
        draw.PathArcTo(centre, 1.55f * radius, -0.25f * kTurn, (charge - 0.25f) * kTurn, 40);
        draw.PathStroke(lamplight(), 0, line);
    }
}

}  // namespace lanthorn::game::ui
