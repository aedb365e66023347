#include "game/rules/game_plugin.h"

#include "game/rules/components.h"
#include "game/rules/systems.h"
#include "lanthorn/runtime/app.h"

namespace lanthorn::game {

void GamePlugin::build(App& app) {
    declare_components(app.registry());
    app.world().insert_resource(PlayerInput());
    app.world().insert_resource(Intent());

    ecs::Schedule& fixed = app.fixed_schedule();
    fixed.add("take_input", take_input).after("restore").before("gameplay.end");
    fixed.add("swing_doors", swing_doors).after("take_input").before("gameplay.end");
    fixed.add("slide_shutters", slide_shutters).after("swing_doors").before("gameplay.end");
    fixed.add("push_along", push_along).after("slide_shutters").before("gameplay.end");
    fixed.add("shove_bodies", shove_bodies).after("push_along").before("gameplay.end");
    fixed.add("turn_tables", turn_tables).after("shove_bodies").before("gameplay.end");
    fixed.add("carry_lanterns", carry_lanterns).after("turn_tables").before("gameplay.end");
    fixed.add("walk", walk).after("take_input").before("gameplay.end");
    fixed.add("follow_player", follow_player).after("carry_lanterns").before("gameplay.end");
    fixed.add("face_followers", face_followers).after("follow_player").before("gameplay.end");
    fixed.add("face_hero", face_hero).after("face_followers").before("gameplay.end");
    fixed.add("walk_figures", walk_figures).after("face_hero").before("gameplay.end");
    fixed.add("hold_out", hold_out).after("walk_figures").before("gameplay.end");
    fixed.add("swing_cloths", swing_cloths).after("walk_figures").before("gameplay.end");
    fixed.add("hang_lanterns", hang_lanterns).after("physics").before("settle");
    fixed.add("follow_with_camera", follow_with_camera).after("hang_lanterns").before("settle");
    fixed.add("reach_goals", reach_goals).after("sensors.read").before("gameplay.end");
    fixed.add("wake_crystals", wake_crystals)
        .after("sensors.read")
        .after("carry_lanterns")
        .before("gameplay.end");
    fixed.add("show_glow", show_glow).after("wake_crystals").before("gameplay.end");
}

}  // namespace lanthorn::game
