// What the layer physics may not do: see the scene.
#include "physics/world.hpp"
#include "scene/components/transform.hpp"

int main() { return 0; }
