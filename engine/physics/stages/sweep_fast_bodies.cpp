#include "physics/stages.hpp"

namespace plumb::physics {

void sweepFastBodies(StepContext&) {}

}  // namespace plumb::physics
