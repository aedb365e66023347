// The one place where tinygltf's code is compiled, so that sanitizers see it too.
#define TINYGLTF_IMPLEMENTATION
#include "engine/assets/tiny_gltf.h"
