// The settings of the picture, from presets and the command line: the same as those of `lanthorn render`.
#pragma once

#include "game/presentation/options.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/shell/frame_budget.h"

namespace lanthorn::game {

class Quality {
  public:
    // `seed`: of the photons. Throws InputError for an unknown preset, setting or value.
    Quality(const Options& options, std::uint64_t seed);

    const Settings& settings() const { return settings_; }

    // From now on the App's picture is drawn with these settings. The first call makes it an App with a
    // picture, whose OpenGL context must be current as long as the App lives.
    void draw(App& app) const;
    void draw(App& app, const shell::Spending& spending);  // the same after choose()

    // A preset and what is set on top of it, light gathered from as many points fewer as the picture has
    // fewer pixels (gi.gather.points, which else keeps their number in smaller pictures), and the command
    // line's
    // --set on top.
    void choose(const shell::Spending& spending);

  private:
    static const SettingsSchema& declare(SettingsSchema& schema);
    SettingsSchema schema_;
    Settings settings_;
    std::vector<std::string> set_;
};

}  // namespace lanthorn::game
