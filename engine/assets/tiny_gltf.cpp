// The one place where tinygltf's code is compiled, so that sanitizers see it too.
#define TINYGLTF_IMPLEMENTATION
#include "lanthorn/assets/tiny_gltf.h"
