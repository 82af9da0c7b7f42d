#pragma GCC diagnostic ignored "-Wunused-function"
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#include "renderer/scene/tinygltf.h"
