#include "game/game_plugin.h"

#include "game/components.h"
#include "game/systems.h"
#include "lanthorn/runtime/app.h"

namespace lanthorn::game {

void GamePlugin::build(App& app) {
    declare_components(app.registry());
    app.world().insert_resource(PlayerInput());
    app.world().insert_resource(Intent());

    ecs::Schedule& fixed = app.fixed_schedule();
    fixed.add("take_input", take_input).after("restore").before("gameplay.end");
    fixed.add("swing_doors", swing_doors).after("take_input").before("gameplay.end");
    fixed.add("carry_lanterns", carry_lanterns).after("swing_doors").before("gameplay.end");
    fixed.add("walk", walk).after("take_input").before("gameplay.end");
    fixed.add("reach_goals", reach_goals).after("sensors.read").before("gameplay.end");
}

}  // namespace lanthorn::game
