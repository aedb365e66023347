// Light wishes: how bright it is to be at places of the scene, and the lamps' intensities that come nearest
// to that. Light is linear in them: the path tracer says what each lamp gives to each place (light_split.h),
// and non-negative least squares what they must be.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "tools/editor/core/edit_session.h"
#include "tools/workbench/measure/light_contracts.h"

namespace lanthorn::editor {

enum class Asks { exactly, at_least, at_most };

struct LightWish {
    std::string where;  // as it was asked for: "/study", "1,0,-2,0,1,0"
    // A node with a light_sensor (what that reads) or a light_contract (the mean of its box); else a place.
    bool of_node = false;
    dvec3 place{0};              // in the world
    std::optional<vec3> normal;  // the side of the surface; nothing: all surfaces that are near
    double radius = 0.1;         // metres round the place: the mean of it
    Asks asks = Asks::exactly;
    double lux = 0;
};

// Of "/study" or "X,Y,Z" or "X,Y,Z,NX,NY,NZ", and "200", "200lx", "<=5" or ">=100". `radius`: empty: as
// usual. Throws InputError.
LightWish wish_of(const std::string& where, const std::string& lux, const std::string& radius = {});
// "<=5 lx".
std::string asked_words(const LightWish& wish);

// A lamp that may be altered.
struct WishLamp {
    std::uint32_t node = kNone;         // the first that has the light
    std::string path;                   // of it
    std::vector<std::uint32_t> lights;  // indices into FrameScene::lights: all that have this intensity
    double intensity = 0;               // as it is: candela, or lux of a directional one
};

struct PlacedWish {
    LightWish wish;
    workbench::PlacedContract place;
};

// What solving needs: nothing of the session, so that it may go on in another thread.
struct WishTask {
    FrameScene frame;
    std::vector<PlacedWish> wishes;
    std::vector<WishLamp> lamps;
    reference::PathSettings settings;
};

// Of the scene as it is shown. `kept`: paths of lamps that stay as they are. Hidden lamps stay as well.
// Throws InputError where a path leads nowhere, where a wish's node has neither sensor nor contract, and
// where there is no lamp to be altered.
WishTask wish_task(EditSession& session, const Settings& settings, std::span<const LightWish> wishes,
                   std::span<const std::string> kept);

// What became of a wish, lux.
struct WishOutcome {
    LightWish wish;
    int places = 0;      // that were looked at; 0: no surface is there
    double before = 0;   // with the lamps as they are
    double reached = 0;  // as they shall be
    double noise = 0;    // of that, one standard error
    bool lit = false;    // a lamp that may be altered gives anything there
    // By how much of what was asked for so many lux miss it; 0 within an inequality. Of wishes for less than
    // 1 lx, of that.
    double missed_with(double lux) const;
    // By no more than kWishTolerance and the noise.
    bool met_with(double lux) const;
    double missed() const { return missed_with(reached); }
    bool met() const { return met_with(reached); }
};
inline constexpr double kWishTolerance = 0.05;  // of what was asked for

struct WishSolution {
    std::vector<WishLamp> lamps;      // as they were
    std::vector<double> intensities;  // of each, as it shall be; 0 or more
    std::vector<WishOutcome> outcomes;
    double residual =
        0;  // root of the mean square of what wishes are missed by, each relative to what it asks
    // Commands that make it so, one a lamp that changes.
    std::vector<std::string> commands() const;
    bool all_met() const;
};

inline constexpr const char* kSolveTitle = "solve light wishes";  // of the step

struct WishEffort {
    int places = 64;  // a wish
    int paths = 256;  // from each
};

// Where lamps can meet the wishes in several ways, the one nearest to how they are. O(wishes * places *
// paths).
WishSolution solve_wishes(const WishTask& task, const WishEffort& effort = {});

// A line a wish: "/study: asked 200 lx, has 61.2, gets 200 +- 1: met".
std::string outcome_words(const WishOutcome& outcome);
// "2 of 3 wishes met, missed by 12 % (root mean square)".
std::string solution_words(const WishSolution& solution);

}  // namespace lanthorn::editor
