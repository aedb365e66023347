// Rectangles of screen tiles in 32 bits: first column and row, and how far the last ones are from kLastTile.
#ifndef LANTHORN_EMC_SPLAT_RECTS_GLSL
#define LANTHORN_EMC_SPLAT_RECTS_GLSL

const int kLastTile = 127;          // column or row; pictures that have more are tried whole (kAllTiles)
const uint kNoTiles = 0x7f7f7f7fu;  // the first behind the last
const uint kAllTiles = 0u;

uint pack_bytes(uvec4 bytes) { return bytes.x | bytes.y << 8u | bytes.z << 16u | bytes.w << 24u; }
uint pack_rect(ivec2 first, ivec2 last) { return pack_bytes(uvec4(first, kLastTile - last)); }
ivec4 unpack_rect(uint rect) {
    ivec4 bytes = ivec4((uvec4(rect) >> uvec4(0u, 8u, 16u, 24u)) & 127u);
    return ivec4(bytes.xy, kLastTile - bytes.zw);
}

// A tile, for lies_in().
uint pack_tile(ivec2 tile) {
    ivec2 t = min(tile, kLastTile);
    return pack_bytes(uvec4(t, kLastTile - t)) | 0x80808080u;
}
// Byte by byte at once: the highest bit stays where the tile's is no less than the rectangle's.
bool lies_in(uint tile, uint rect) { return ((tile - rect) & 0x80808080u) == 0x80808080u; }

#endif
