// Which of the filter's links a wall stands in. The C++ side: gather_links.h.
#ifndef LANTHORN_EMC_GATHER_LINKS_GLSL
#define LANTHORN_EMC_GATHER_LINKS_GLSL

// Of tap k of 3 x 3 around a point, on `level`; the point itself (k = 4) has none.
uint link_bit(int level, int k) { return k != 4 ? 1u << (8 * level + k - (k > 4 ? 1 : 0)) : 0u; }

bool is_cut(uint cuts, int level, int k) { return (cuts & link_bit(level, k)) != 0u; }

#endif
