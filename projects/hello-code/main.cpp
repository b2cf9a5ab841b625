#include <plumb.hpp>
using namespace plumb;

// Game code using your engine
class PlatformerGame : public Game {
    Entity player;

    void onCreate() override {
        // Load assets
        auto playerTexture = assets.loadTexture("player.png");
        auto platformTexture = assets.loadTexture("platform.png");

        // Create player
        player = world.createEntity();
        player.addComponent<Transform>(100.0f, 100.0f);
        player.addComponent<Sprite>(playerTexture, 32, 32);
        player.addComponent<RigidBody>(1.0f);  // mass
        player.addComponent<BoxCollider>(32, 32);
        player.addComponent<Animator>(playerAnimations);
        player.addComponent<PlayerController>();

        // Create platforms
        for (int i = 0; i < 10; i++) {
            auto platform = world.createEntity();
            platform.addComponent<Transform>(i * 100.0f, 400.0f);
            platform.addComponent<Sprite>(platformTexture, 100, 20);
            platform.addComponent<BoxCollider>(100, 20);
            platform.addComponent<StaticBody>();
        }

        // Register systems
        world.addSystem<GravitySystem>();
        world.addSystem<MovementSystem>();
        world.addSystem<CollisionSystem>();
        world.addSystem<AnimationSystem>();
        world.addSystem<RenderSystem>();
    }

    void onUpdate(float dt) override {
        // Input handling
        if (input.isPressed(Action::Jump) && player.get<RigidBody>().grounded) {
            player.get<RigidBody>().velocity.y = -500.0f;
        }

        float moveX = input.getAxis(Axis::Horizontal);
        player.get<RigidBody>().velocity.x = moveX * 200.0f;
    }
};

int main(int count, char** words) {
    Engine engine("My Platformer", 800, 600, count, words);
    return engine.run<PlatformerGame>();
}
