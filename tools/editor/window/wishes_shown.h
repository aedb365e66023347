// Light wishes as panels and picture show them: none of it is saved.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tools/editor/core/light_wishes.h"

namespace lanthorn::edit_window {

struct WishRow {
    editor::LightWish wish;
    std::optional<editor::WishOutcome> found;  // with the lamps as they were when it was looked at last
};

struct WishesShown {
    std::vector<WishRow> rows;
    std::set<std::uint32_t> kept;  // nodes of lamps that solving leaves alone
    std::string lux = "100";       // of the next one: as wish_of() takes it
    bool placing = false;          // a drag in the picture makes one: from its middle to its rim
    std::uint64_t edition = 0;     // another wish, or another lamp that stays
    // Of these the rows' outcomes are.
    std::uint64_t found_edition = 0, found_version = 0;
    bool busy = false;   // they are being looked at, or solved
    bool solve = false;  // asked for

    std::vector<editor::LightWish> all() const {
        std::vector<editor::LightWish> wishes;
        for (const WishRow& row : rows) {
            wishes.push_back(row.wish);
        }
        return wishes;
    }
    bool old(std::uint64_t version) const { return found_version != version || found_edition != edition; }
};

}  // namespace lanthorn::edit_window
