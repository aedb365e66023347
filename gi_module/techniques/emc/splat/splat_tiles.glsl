// The photons of each tile of the screen. The C++ side: splat_tiles.h.
#ifndef LANTHORN_EMC_SPLAT_TILES_GLSL
#define LANTHORN_EMC_SPLAT_TILES_GLSL

#ifndef TILE_LISTS_ACCESS
#define TILE_LISTS_ACCESS readonly
#endif

layout(std430, binding = 5) TILE_LISTS_ACCESS buffer TileLists {
    uint list_entries;  // of all tiles together
    uint list_photons;  // of all there are
    uint longest_list;
    uint list_padding;
    uint starts[];      // by tile, and one more: its first entry
};
uniform usamplerBuffer photon_lists;
uniform int list_capacity;  // entries that there is room for

// A list that there is no room for is that of all photons: it takes longer, and nothing is lost.
struct TileList {
    int first;
    int last;
    bool listed;
};

TileList list_of(int tile) {
    bool listed = starts[tile + 1] <= uint(list_capacity);
    return TileList(listed ? int(starts[tile]) : 0, listed ? int(starts[tile + 1]) : int(list_photons), listed);
}

int photon_of(TileList list, int entry) { return list.listed ? int(texelFetch(photon_lists, entry).r) : entry; }

#endif
