// The project's own scenes. `generate_scenes assets` writes the small ones to assets/NAME.glb, where they are
// committed; the build writes the large ones to scenes/NAME.glb in its folder.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn::scene_generator {

SceneData cornell();       // the measured Cornell box
SceneData mirror_balls();  // the same with two mirror balls instead of its blocks
SceneData near_lamp();     // the Cornell box lit by a lamp that a ball all but touches
SceneData cave();          // a cave with a mirror and a mirror ball; a figure walks through it with a lantern
SceneData two_rooms();     // two furnished rooms, one lit, joined by a doorway
SceneData clutter();       // forty floating boxes in a closed room
SceneData lantern_room();  // the first room of the game
// The same with its door open: what comes through the doorway is all the light of the dark half, `camera
// dark`.
SceneData lantern_room_open();
SceneData puppet();          // a skinned figure walks through a coloured room with a lantern
SceneData nave();            // a columned hall of 80 k triangles in which a censer swings
SceneData corridor();        // L-shaped, lit from round its corner
SceneData furnished();       // a room with shelves of small things, a table and chairs with thin legs
SceneData glass_ball();      // a ball of glass in a box of coloured walls, and what it gathers
SceneData diffuse_box();     // diffuse things of 15 k triangles in a box of coloured walls
SceneData dimpled();         // a block of glass with a dimpled surface, and the caustics below it
SceneData living_room();     // glossy boards, glass table and vases, a brass lamp, textures
SceneData ring();            // a polished ring on a table, a pawn in the caustic that it throws
SceneData building();        // fifty rooms on two floors, doors that swing, ten lamps
SceneData furnace_sphere();  // a sphere lit from its centre: the answer is known in closed form

struct NamedScene {
    std::string name;
    SceneData (*make)();
};
// The small ones.
const std::vector<NamedScene>& all_scenes();

SceneData level_red_wall();       // levels of the game: light that a wall colours,
SceneData level_green_screen();   // that a screen on a rail sends on,
SceneData level_two_glasses();    // that a lantern's glasses colour,
SceneData level_shutter();        // of the moon, once it is let in,
SceneData level_mirrors();        // that mirrors send round a corner,
SceneData level_pool();           // that glass colours and water sends on,
SceneData level_burning_glass();  // that a lens gathers and a mirror hands on,
SceneData level_lamp_bearer();    // that a puppet carries to where a wall colours it,
SceneData level_other_light();    // and that comes by a window, for a while

// The game's levels, in assets/levels/.
const std::vector<NamedScene>& level_scenes();

SceneData building_of_10();  // the first 10 and 25 rooms of a building, with as many lamps
SceneData building_of_25();
SceneData two_rooms_lamps_4();  // the light of two_rooms() from 4 and 16 lamps
SceneData two_rooms_lamps_16();
SceneData crowd();             // a hundred puppets in a hall, their meshes shared
SceneData lamplighter_icon();  // the game's lantern, for its icon
SceneData thesis_box_16();     // the box of Jozwowski 2002, of 16 to 1024 square surfaces; its lamp circles
SceneData thesis_box_64();
SceneData thesis_box_256();
SceneData thesis_box_1024();
SceneData dragon_sized();  // a knot of 871 k triangles in a box; in no list, as nothing needs its file
// A wavy ground of about so many triangles under a lamp, and as many stones of 3 200 on one; in no list, too.
SceneData wavy_ground(int triangles);
SceneData many_stones(int count);
// A hall with so many lamps, their light as much as that of one: of endless range, each reaching a few of its
// neighbours, or spots.
enum class LampKind { endless, in_range, spot };
SceneData lamp_hall(int count, LampKind kind);
SceneData pool();          // a tiled basin; its water is an animated height field of 54 k triangles
SceneData glossy_floor();  // puppet() on a floor of rough metal (Yao et al. 2010, Fig. 8)
SceneData statues();       // urn, column, ball and block that two coloured walls light (its Fig. 11 a)
SceneData toys();  // a hundred thousand triangles of blocks, balls and rings on a floor (its Fig. 11 c)
const std::vector<NamedScene>& large_scenes();

}  // namespace lanthorn::scene_generator
