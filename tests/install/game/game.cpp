#include <cstdio>
#include <plumb.hpp>

using namespace plumb;

class Meadow : public Game {
public:
    void onCreate() override {
        for (int i = 0; i < 2; ++i)
            world.createEntity().addComponent<Transform>(10.0f * static_cast<float>(i), 0.0f);
        world.addSystem<PhysicsSystem>();
    }
};

int main() {
    Meadow game;
    game.onCreate();
    for (int tick = 0; tick < 60; ++tick) tickGame(game, InputFrame{});
    std::printf("entities: %zu, hash: %016llx\n", game.world.entityCount(),
                static_cast<unsigned long long>(game.world.hash()));
}
