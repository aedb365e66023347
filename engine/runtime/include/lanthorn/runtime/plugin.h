// A plugin: a part of the engine, or of a game, that joins an App.
#pragma once

#include <string_view>

namespace lanthorn {

class App;

struct Plugin {
    virtual ~Plugin() = default;
    // Unique in an App, as error messages show it.
    virtual std::string_view name() const = 0;
    // Inserts the plugin's resources and adds its systems, by name and with what they touch. Called once.
    virtual void build(App& app) = 0;
};

}  // namespace lanthorn
