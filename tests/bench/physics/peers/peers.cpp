#include "tests/bench/physics/peers/peers.hpp"

namespace plumb::scenes {

std::vector<Engine> peerEngines() {
    return {
#if defined(PLUMB_BENCH_BOX2D)
        box2dEngine(), box2dUnsweptEngine(),
#endif
#if defined(PLUMB_BENCH_CHIPMUNK)
            chipmunkEngine(),
#endif
    };
}

}  // namespace plumb::scenes
