// Results as a worker would have made them.
#pragma once

#include <string>

#include "tools/replay_suite/result.h"

namespace lanthorn::suite {

inline Result passed(const std::string& id, std::uint64_t steps = 100) {
    Result result;
    result.id = id;
    result.key = "key-of-" + id;
    result.verdict = Verdict::ok;
    result.verify = {{"steps", steps},
                     {"hashes_compared", 37 * steps},
                     {"parts_changed", {{"door", 3}, {"cloth", 0}}},
                     {"systems_ran", {{"physics", steps}, {"doors", 0}}},
                     {"checks", {{{"name", "state"}, {"verdict", "ok"}, {"text", "all equal"}}}},
                     {"divergences", nlohmann::json::array()}};
    result.times = {{"wall_s", 0.25}};
    return result;
}

inline Result diverged(const std::string& id, std::uint64_t step = 12) {
    Result result = passed(id);
    result.verdict = Verdict::failed;
    result.line = "state: step 12: door differs";
    result.verify["checks"][0] = {
        {"name", "state"}, {"verdict", "failed"}, {"text", "step 12: door differs"}};
    result.verify["divergences"] = {{{"step", step}, {"parts", {"door"}}}};
    result.failure = failure_id(result);
    return result;
}

}  // namespace lanthorn::suite
