#include "lanthorn/ui/fonts.h"

#include <algorithm>
#include <cmath>

#include "lanthorn/core/installation.h"

namespace lanthorn::ui {

namespace fs = std::filesystem;

float unit_of(ivec2 window, double text_size) {
    const float fit = std::min(static_cast<float>(window.x) / 1280, static_cast<float>(window.y) / 720);
    // Letters of less than about 12 pixels cannot be read.
    return std::clamp(fit * static_cast<float>(text_size), 0.6f, 8.0f);
}

fs::path font_file(std::string_view name, std::string_view package) {
    const fs::path share = installed_share();
    std::error_code error;
    for (const fs::path& folder :
         {share.empty() ? fs::path() : share / "fonts", fs::path("/usr/share/fonts/opentype") / package}) {
        if (!folder.empty() && fs::is_regular_file(folder / name, error)) {
            return folder / name;
        }
    }
    return {};
}

ImFont* add_font(const fs::path& file, float height, const ImWchar* letters) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    if (file.empty()) {
        ImFontConfig config;
        config.SizePixels = std::max(13.0f, 13 * std::floor(height / 13));  // a bitmap: whole multiples
        return atlas.AddFontDefault(&config);
    }
    return atlas.AddFontFromFileTTF(file.c_str(), std::round(height), nullptr, letters);
}

}  // namespace lanthorn::ui
