// Uses of the engine that must not compile, with a message that says what is wrong:
// tests/rules/CMakeLists.txt compiles this file once for each number, and without one, when all of it is
// right.
#ifndef WRONG_USE
#define WRONG_USE 0
#endif

#include <string>

#include "core/log.hpp"
#include "ecs/world.hpp"

namespace plumb {

struct Place {
    float x = 0.0f;
};
struct Speed {
    float x = 0.0f;
};
struct Words {
    std::string text;
};

inline void use(World& world, const std::string& text) {
    logNote("Game", "{} of {}", 1, 2);
    logNote("Game", text);
    logNote("Game", runtimePattern(text), 1, 2);
    logError("Game", "text");
    static_cast<void>(world.query<Place, const Speed>(with<Speed>));
    world.each<Place>([](Entity, Place&) {});
#if WRONG_USE == 1
    logNote("Game", "{} of {}", 1);
#elif WRONG_USE == 2
    logWarning("Game", "{:.2f}", 1.0f);
#elif WRONG_USE == 3
    static_cast<void>(format("score: ", 3));
#elif WRONG_USE == 4
    static_cast<void>(format(text, 3));
#elif WRONG_USE == 5
    static_cast<void>(world.query<Place, const Place>());
#elif WRONG_USE == 6
    static_cast<void>(world.query<Place>(without<Speed, Place>));
#elif WRONG_USE == 7
    static_cast<void>(world.query<Place&>());
#elif WRONG_USE == 8
    world.each<Place, Speed>([](Place&) {});
#elif WRONG_USE == 9
    world.createEntity().addComponent<Words>();
#endif
}

}  // namespace plumb
