// Indirect dispatches of more work groups than GL promises along an axis: rows of them.
#ifndef LANTHORN_WORK_ITEMS_GLSL
#define LANTHORN_WORK_ITEMS_GLSL

const uint kRow = 16384u;  // work groups a row of a dispatch: GL promises no more than 65535

uint work_item() { return (gl_WorkGroupID.y * kRow + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }

#endif
