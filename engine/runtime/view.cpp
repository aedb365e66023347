#include "lanthorn/runtime/view.h"

#include <fmt/format.h>

#include <utility>

namespace lanthorn {

ViewId Views::add(View view) {
    const ViewId id{next_++};
    views_.emplace(id, std::move(view));
    return id;
}

View* Views::find(ViewId id) {
    const auto found = views_.find(id);
    return found == views_.end() ? nullptr : &found->second;
}

const View* Views::find(ViewId id) const {
    const auto found = views_.find(id);
    return found == views_.end() ? nullptr : &found->second;
}

bool Views::remove(ViewId id) {
    return views_.erase(id) > 0;
}

std::string described_view(ViewId id, const View& view) {
    return view.name.empty() ? fmt::format("view {}", static_cast<std::uint32_t>(id))
                             : fmt::format("view '{}'", view.name);
}

}  // namespace lanthorn
