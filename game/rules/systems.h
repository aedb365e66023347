// The game's rules: one function a system. game_plugin.cpp puts them into the schedule of fixed steps.
#pragma once

#include <memory>

#include "game/rules/cloth.h"
#include "game/rules/components.h"
#include "game/rules/figures.h"
#include "game/rules/flames.h"
#include "game/rules/looks.h"
#include "game/rules/place_now.h"
#include "game/rules/player_input.h"
#include "lanthorn/animation/animation_player.h"
#include "lanthorn/ecs/system.h"
#include "lanthorn/physics/components.h"
#include "lanthorn/physics/physics.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/runtime/time.h"
#include "lanthorn/runtime/view.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/light_sensor.h"

namespace lanthorn::game {

using ecs::Commands;
using ecs::Entity;
using ecs::Mut;
using ecs::Query;
using ecs::Read;
using ecs::Res;
using ecs::ResMut;
using ecs::Write;

using physics::SharedPhysics;

// What the player is about to do in this step, and from where (resource).
struct Intent {
    Entity player;              // null: there is none
    dvec3 feet{0}, eye{0};      // world, as the last step left them
    double yaw = 0;             // radians
    dvec3 facing{0, 0, -1};     // unit, level
    dvec3 walk{0};              // wished velocity, metres a second
    std::uint32_t pressed = 0;  // Buttons that went down in this step

    bool in_reach(const dvec3& target) const;  // near, and in front of her
};

// Turns the eyes; says what the input means for the player as she stands.
void take_input(Res<PlayerInput> input, Query<Write<Player>, Read<WorldTransform>> players,
                Query<Mut<Eyes>, Mut<LocalTransform>, Read<WorldTransform>> eyes, ResMut<Intent> intent);
void walk(Res<Intent> intent, Query<Write<Player>, Write<physics::CharacterInput>> players);
// Opens or closes the doors at hand. A leaf follows, and stops before it would hit the player.
void swing_doors(Res<Intent> intent, Res<SharedPhysics> physics,
                 Query<Mut<Door>, Mut<LocalTransform>, Read<WorldTransform>> doors);
// Takes lanterns up, puts them down, lights and dims them.
void carry_lanterns(Res<Intent> intent, Res<SharedPhysics> physics,
                    Query<Mut<Lantern>, Mut<LocalTransform>> lanterns, Commands& commands);
// Carried, a lantern hangs from the hand and sways. After all else that moves, so that it is where the hand
// is.
void hang_lanterns(Res<Intent> intent, Res<SharedPhysics> physics, Query<Read<Hand>> hands,
                   Query<Mut<Lantern>, Mut<LocalTransform>> lanterns, Places places);
// Opens or shuts the shutters at hand; they stop before they would hit the player.
void slide_shutters(Res<Intent> intent, Res<SharedPhysics> physics,
                    Query<Mut<Shutter>, Mut<LocalTransform>, Read<WorldTransform>> shutters);
// Moves what the player walks against along its rail, as fast as she walks that way, but no faster than
// 0.9 m/s.
void push_along(Res<Intent> intent, Res<SharedPhysics> physics,
                Query<Mut<Pushed>, Mut<LocalTransform>, Read<WorldTransform>> things);
// Gives the rigid bodies that the player walks against her speed, 1.2 m/s at most, what is heavier than 8 kg
// less.
void shove_bodies(Res<Intent> intent, Res<SharedPhysics> physics,
                  Query<Read<physics::RigidBody>, Mut<physics::BodyMotion>, Read<WorldTransform>> bodies);
// Turns the turntables at hand while she uses them.
void turn_tables(Res<Intent> intent, Res<SharedPhysics> physics, Res<PlayerInput> input,
                 Query<Mut<Turntable>, Mut<LocalTransform>, Read<WorldTransform>> tables);
void wake_crystals(Query<Read<LightSensor>, Mut<Crystal>> crystals, Commands& commands);
// What is seen of flames, at the moment that a frame shows.
void show_flames(Query<Read<Flame>, Read<LightComponent>, Read<WorldTransform>> flames, Res<Time> time,
                 Res<Flicker> flicker, ResMut<render::Glows> shown);
using Hierarchy = ecs::Lookup<Read<Parent>, Read<Figure>, Read<SkinInstance>>;
// What is seen otherwise than it is; `before`: the frame before this one.
void show_looks(Res<Intent> intent, Res<SharedPhysics> physics, Res<View> view, Res<Time> time,
                Res<FrameScene> before, Query<Read<FollowCamera>, Read<WorldTransform>> cameras,
                Query<Read<Eyes>, Read<WorldTransform>> eyes, Query<ecs::With<MeshInstances>> shapes,
                Hierarchy above, ResMut<Fading> fading, ResMut<render::Looks> looks);
// The nearer the camera is behind her, the further down it looks in the picture, so that she stays in it.
// What is aimed at and simulated knows nothing of it.
void look_down_on_her(Query<Read<FollowCamera>, Write<Interpolated>, Mut<LocalTransform>> cameras);
// Makes the crystals' materials glow as much as they do, in the picture: what is simulated knows nothing of
// it, and a state that is restored glows in its first picture.
void show_glow(Query<Read<Crystal>, Read<MeshInstances>> crystals, ResMut<AssetStore> store);
// The hero faces where she walks, and where she looks as soon as she handles something or looks far aside.
// With her eyes for a camera she always does.
void face_hero(Res<Intent> intent, Query<Read<FollowCamera>> cameras,
               Query<Write<Figure>, Read<Parent>> figures);
// Measures how figures come along, and blends their clips by it.
void walk_figures(Query<Write<Figure>, Read<WorldTransform>, Mut<LocalTransform>, Read<AnimationSet>,
                        Write<AnimationPlayer>>
                      figures);
// Raises the hand when there is a lantern in it, and draws it in before walls.
void hold_out(Res<Intent> intent, Res<SharedPhysics> physics, Query<Read<Lantern>> lanterns,
              ecs::Lookup<Read<Figure>> figures,
              Query<Write<Hand>, Read<AnimationSet>, Write<AnimationPlayer>> hands);
// Where the player looks from. After all else that moves.
void follow_with_camera(Res<Intent> intent, Res<SharedPhysics> physics, Query<Read<Eyes>> eyes,
                        Query<Read<Cloth>, Read<WorldTransform>> cloths,
                        Query<Mut<FollowCamera>, Mut<LocalTransform>> cameras, Places places);
// Followers at hand that heed her wait, or come.
void tell_followers(Res<Intent> intent, Query<Mut<Heeds>, Read<WorldTransform>> followers);
void follow_player(Res<Intent> intent, Res<SharedPhysics> physics, ecs::Lookup<Read<Heeds>> heeds,
                   Query<Write<Follower>, Mut<LocalTransform>> followers);
// Followers face where they walk, and the player while they wait.
void face_followers(Res<Intent> intent, Query<Read<Follower>, Read<LocalTransform>> followers,
                    Query<Write<Figure>, Read<Parent>> figures);
void swing_cloths(Res<Intent> intent, ecs::Lookup<Read<physics::Character>> characters,
                  Query<Write<Cloth>, Read<SkinInstance>, Read<WorldTransform>> cloths,
                  ecs::Lookup<Write<LocalTransform>> joints);
void reach_goals(Query<Read<LightSensor>, Mut<Goal>> goals);

}  // namespace lanthorn::game
