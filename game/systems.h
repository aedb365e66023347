// The game's rules: one function a system. simulation.cpp puts them into a schedule.
#pragma once

#include "game/components.h"
#include "game/player_input.h"
#include "lanthorn/ecs/system.h"

namespace lanthorn::game {

using ecs::Query;
using ecs::Read;
using ecs::Res;
using ecs::ResMut;
using ecs::Write;

void count_step(ResMut<Clock> clock);
// Input as it came to what it means for the player as she stands.
void intend(Res<PlayerInput> input, Query<Read<Player>> players, ResMut<StepIntent> intent);
// Opens or closes the door at hand; the leaf follows and stops before it would hit somebody.
void swing_door(Res<StepIntent> intent, Query<Read<Player>> players,
                Query<Write<Door>, Read<DoorFrame>> doors);
void walk(Res<PlayerInput> input, Res<StepIntent> intent, Query<Read<Wall>> walls,
          Query<Read<Door>, Read<DoorFrame>> doors, Query<Write<Player>> players);
// Carried, the lantern hangs from the hand and sways; put down, it stands.
void carry_lantern(Res<StepIntent> intent, Query<Read<Player>> players, Query<Read<Wall>> walls,
                   Query<Read<Door>, Read<DoorFrame>> doors,
                   Query<Write<Lantern>, Read<LanternShape>> lanterns);
void sense(Res<SensorInput> input, Query<Write<FarRoom>> rooms);

}  // namespace lanthorn::game
