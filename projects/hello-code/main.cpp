#include <plumb.hpp>
using namespace plumb;

// Meteor Night, a whole game in one file: shoot what falls on the valley. Every hit in a row is worth more,
// until a meteor reaches the ground.

constexpr Vec2 kPicture{320.0f, 180.0f};          // px, what is seen of the valley
constexpr Vec2 kValley{640.0f, 166.0f};           // px, its width and where its ground is
constexpr float kRadius[] = {10.0f, 7.0f, 4.0f};  // px, of the three kinds of meteors
constexpr Color kFire{255, 180, 80, 255}, kIce{120, 220, 255, 255}, kNight{15, 13, 36, 255};

// Components: the game finds its entities by them.
struct Ship {};
struct Shot {};
struct Meteor {
    int kind = 0;  // 0: the largest, which breaks into two of the next kind
};

class MeteorNight : public Game {
    Entity ship, hearts;
    int score = 0, best = 0, chain = 1, lives = 0;
    float reload = 0.0f, untilMeteor = 1.0f, safe = 0.0f, rest = 0.0f;  // s, all count down to 0

    void onCreate() override {
        setGravity({0.0f, 0.0f});
        addSprite("sky.png", 320, 180, {0.0f, 0.0f}).addComponent<ParallaxLayer>(Vec2{0.0f, 0.0f});
        addSprite("far_hills.png", 320, 110, {0.0f, 84.0f}).addComponent<ParallaxLayer>(Vec2{0.2f, 0.2f});
        addSprite("near_hills.png", 320, 90, {0.0f, 112.0f}).addComponent<ParallaxLayer>(Vec2{0.5f, 0.5f});
        addSprite("ground.png", 320, 48, {0.0f, 154.0f}).addComponent<ParallaxLayer>(Vec2{1.0f, 1.0f});
        hearts = addSprite("hearts.png", 0, 8, {8.0f, 7.0f}, 20);
        hearts.addComponent<ParallaxLayer>(Vec2{}, false);  // it stays at its place on the screen
        addText("{score}", {160.0f, 6.0f}, 16.0f, LabelAlign::Center);
        addText("{best}", {312.0f, 6.0f}, 8.0f, LabelAlign::Right);
        addText("{title}", {160.0f, 56.0f}, 24.0f, LabelAlign::Center);
        addText("{hint}", {160.0f, 90.0f}, 8.0f, LabelAlign::Center);
        for (auto [entity, label] : world.query<Label>()) label.outline = kNight;
        show("title", "METEOR NIGHT");
        show("hint", "Arrows or stick: fly\nSpace or (A): shoot, begin");
        camera().get<Camera>().smoothing = 0.5f;
        camera().get<Camera>().limits = {0.0f, 0.0f, kValley.x, kPicture.y};
    }

    Entity addSprite(const char* picture, int width, int height, Vec2 place, int layer = 0) {
        Entity made = world.createEntity();
        made.addComponent<Transform>(place);
        made.addComponent<Sprite>(assets.loadTexture(picture), width, height).layer = layer;
        return made;
    }

    Entity addFlier(const char* picture, int width, int height, Vec2 place, Vec2 velocity, float radius) {
        Entity made = addSprite(picture, width, height, place, 5);
        made.get<Sprite>().pivot = {0.5f, 0.5f};  // its middle is at the Transform
        made.addComponent<RigidBody>().velocity = velocity;
        made.addComponent<CircleCollider>(radius).isTrigger = true;  // meets others without a push
        return made;
    }

    void addMeteor(int kind, Vec2 place, Vec2 velocity) {
        Entity meteor = addFlier("meteor.png", 24, 24, place, velocity, kRadius[kind]);
        meteor.addComponent<Meteor>(kind);
        meteor.get<Sprite>().frameX = kind;
        meteor.get<RigidBody>().angularVelocity = random().between(-3.0f, 3.0f);
        meteor.addComponent<ParticleEmitter>(sparks(kFire, 12.0f)).size = kRadius[kind] * 0.7f;
    }

    static ParticleEmitter sparks(Color color, float speed) {
        return {.spread = kTau,
                .speed = speed,
                .colorStart = color,
                .blend = ParticleBlend::Additive,
                .layer = 4};
    }

    void explode(EntityId entity, Color color, int count, float strength) {
        burst(world, world.get<const Transform>(entity).position, count, sparks(color, 90.0f));
        shakeCamera(world, strength, 0.3f);
        world.destroy(entity);
    }

    void start() {
        for (auto [entity, meteor] : world.query<const Meteor>()) world.destroy(entity);
        ship = addFlier("ship.png", 16, 16, {kValley.x / 2.0f, 130.0f}, {}, 6.0f);
        ship.addComponent<Ship>();
        camera().get<Camera>().follow = ship;
        score = 0, chain = 1, lives = 3;
        show("title", ""), show("hint", "");
        play("start.wav");
    }

    void onUpdate(float dt) override {
        for (float* time : {&reload, &untilMeteor, &safe, &rest}) *time = std::max(0.0f, *time - dt);
        if (ship) fly();
        if (!ship && rest == 0.0f && input.isPressed(Action::Confirm)) start();
        if (untilMeteor == 0.0f) drop();
        if (input.isPressed(Key::Escape)) quitGame(world);
    }

    void fly() {
        Vec2& place = ship.get<Transform>().position;
        place = max({8.0f, 8.0f}, min(place, kValley - Vec2{8.0f, 8.0f}));
        const Vec2 way{input.getAxis(Axis::Horizontal), input.getAxis(Axis::Vertical)};
        ship.get<RigidBody>().velocity = way * 150.0f;
        ship.get<Sprite>().tint.a = safe > 0.0f && world.tick % 8 < 4 ? 80 : 255;
        if (reload > 0.0f || !(input.isHeld(Action::Confirm) || input.isHeld(Action::Attack))) return;
        Entity shot = addFlier("shot.png", 5, 10, place - Vec2{0.0f, 10.0f}, {0.0f, -340.0f}, 3.0f);
        shot.addComponent<Shot>();
        shot.addComponent<Lifetime>(0.5f);
        reload = 0.18f;
        play("shot.wav", 0.6f);
    }

    void drop() {
        const auto points = static_cast<float>(score);
        const float x = camera().get<Transform>().position.x + random().between(-180.0f, 180.0f);
        const Vec2 velocity{random().between(-30.0f, 30.0f), 50.0f + points / 50.0f};
        addMeteor(random().below(4) == 0 ? 1 : 0, {x, -12.0f}, velocity);
        untilMeteor = std::max(0.35f, 1.2f - points / 2000.0f);
    }

    void onLateUpdate(float) override {  // the systems have run: what met in this tick is known
        forEachTouch<TriggerEntered, Shot, Meteor>(world, [&](EntityId shot, EntityId meteor) {
            const int kind = world.get<const Meteor>(meteor).kind;
            for (const float side : {-45.0f, 45.0f})
                if (kind < 2) addMeteor(kind + 1, world.get<const Transform>(meteor).position, {side, 60.0f});
            score += 10 * (kind + 1) * chain++;
            explode(meteor, kFire, 24, 3.0f);
            world.destroy(shot);
            play("hit.wav");
        });
        forEachTouch<TriggerEntered, Meteor, Ship>(world, [&](EntityId meteor, EntityId) {
            if (safe == 0.0f) hurt(meteor);
        });
        for (auto [entity, meteor, transform] : world.query<const Meteor, const Transform>()) {
            if (transform.position.y > kValley.y) chain = 1, explode(entity, kFire, 12, 2.0f);
        }
        best = std::max(best, score);
        hearts.get<Sprite>().width = 9 * lives;
        show("score", format("{}", score));
        show("best", format("best {}\nx {}", best, chain));
    }

    void hurt(EntityId meteor) {
        explode(meteor, kFire, 40, 8.0f);
        chain = 1, safe = 1.5f;
        play("hurt.wav");
        if (--lives > 0) return;
        explode(ship, kIce, 80, 10.0f);
        play("over.wav");
        logNote("Game", "Game over with score {}, best {}", score, best);
        show("title", "GAME OVER"), show("hint", "Space or (A): again");
        rest = 1.0f;
    }
};

int main(int count, char** words) {
    Engine engine("Meteor Night", 960, 540, count, words);
    engine.settings().picture = kPicture;
    engine.settings().scaling = WindowScale::Integer;
    return engine.run<MeteorNight>();
}
