#include "lanthorn/lamplighter/lamplighter.h"

#include "game/rules/components.h"
#include "game/rules/systems.h"
#include "lanthorn/runtime/app.h"

namespace lanthorn::game {

void GamePlugin::build(App& app) {
    declare_components(app.registry());
    app.world().insert_resource(PlayerInput());
    app.world().insert_resource(Intent());
    app.world().insert_resource(Flicker());
    app.world().insert_resource(render::Glows());
    app.world().insert_resource(Fading());
    app.world().insert_resource(render::Looks());

    ecs::Schedule& fixed = app.fixed_schedule();
    fixed.add("take_input", take_input).in("gameplay");
    fixed.add("swing_doors", swing_doors).after("take_input").in("gameplay");
    fixed.add("slide_shutters", slide_shutters).after("swing_doors").in("gameplay");
    fixed.add("push_along", push_along).after("slide_shutters").in("gameplay");
    fixed.add("shove_bodies", shove_bodies).after("push_along").in("gameplay");
    fixed.add("turn_tables", turn_tables).after("shove_bodies").in("gameplay");
    fixed.add("carry_lanterns", carry_lanterns).after("turn_tables").in("gameplay");
    fixed.add("walk", walk).after("take_input").in("gameplay");
    fixed.add("tell_followers", tell_followers).after("carry_lanterns").in("gameplay");
    fixed.add("follow_player", follow_player).after("tell_followers").in("gameplay");
    fixed.add("face_followers", face_followers).after("follow_player").in("gameplay");
    fixed.add("face_hero", face_hero).after("face_followers").in("gameplay");
    fixed.add("walk_figures", walk_figures).after("face_hero").in("gameplay");
    fixed.add("hold_out", hold_out).after("walk_figures").in("gameplay");
    fixed.add("swing_cloths", swing_cloths).after("walk_figures").in("gameplay");
    fixed.add("hang_lanterns", hang_lanterns).after("physics").before("settle");
    fixed.add("follow_with_camera", follow_with_camera).after("hang_lanterns").before("settle");
    fixed.add("reach_goals", reach_goals).after("sensors.read").in("gameplay");
    fixed.add("wake_crystals", wake_crystals).after("sensors.read").after("carry_lanterns").in("gameplay");

    app.frame_schedule().add("show_glow", show_glow).before("extract");
    app.frame_schedule().add("show_flames", show_flames).after("transforms");
    app.frame_schedule().add("look_down_on_her", look_down_on_her).after("animation").before("transforms");
    app.frame_schedule().add("show_looks", show_looks).after("transforms").before("extract");
}

}  // namespace lanthorn::game
