#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

const std::vector<NamedScene>& all_scenes() {
    static const std::vector<NamedScene> scenes = {{"cornell", cornell},
                                                   {"mirror-balls", mirror_balls},
                                                   {"near-lamp", near_lamp},
                                                   {"cave", cave},
                                                   {"two-rooms", two_rooms},
                                                   {"clutter", clutter},
                                                   {"lantern-room", lantern_room},
                                                   {"lantern-room-open", lantern_room_open},
                                                   {"puppet", puppet},
                                                   {"nave", nave},
                                                   {"corridor", corridor},
                                                   {"furnished", furnished},
                                                   {"furnace-sphere", furnace_sphere},
                                                   {"building", building},
                                                   {"ring", ring},
                                                   {"glass-ball", glass_ball},
                                                   {"diffuse-box", diffuse_box},
                                                   {"dimpled", dimpled},
                                                   {"living-room", living_room}};
    return scenes;
}

const std::vector<NamedScene>& level_scenes() {
    static const std::vector<NamedScene> scenes = {{"levels/red-wall", level_red_wall},
                                                   {"levels/green-screen", level_green_screen},
                                                   {"levels/two-glasses", level_two_glasses},
                                                   {"levels/shutter", level_shutter},
                                                   {"levels/mirrors", level_mirrors},
                                                   {"levels/pool", level_pool},
                                                   {"levels/burning-glass", level_burning_glass},
                                                   {"levels/lamp-bearer", level_lamp_bearer},
                                                   {"levels/other-light", level_other_light}};
    return scenes;
}

const std::vector<NamedScene>& large_scenes() {
    static const std::vector<NamedScene> scenes = {{"building-10", building_of_10},
                                                   {"building-25", building_of_25},
                                                   {"crowd", crowd},
                                                   {"glossy-floor", glossy_floor},
                                                   {"lamplighter-icon", lamplighter_icon},
                                                   {"two-rooms-lamps-4", two_rooms_lamps_4},
                                                   {"two-rooms-lamps-16", two_rooms_lamps_16},
                                                   {"thesis-box-16", thesis_box_16},
                                                   {"thesis-box-64", thesis_box_64},
                                                   {"thesis-box-256", thesis_box_256},
                                                   {"thesis-box-1024", thesis_box_1024},
                                                   {"pool", pool},
                                                   {"statues", statues},
                                                   {"toys", toys}};
    return scenes;
}

}  // namespace lanthorn::scene_generator
