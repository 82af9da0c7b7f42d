#pragma once
// tinyobjloader, read in double: a mesh far from its origin keeps its shape.
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>
