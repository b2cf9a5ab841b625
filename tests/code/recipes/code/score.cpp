#include <plumb.hpp>

using namespace plumb;

/// The points of a level. A restart loads the level again, so they begin with 0.
struct Score {
    int points = 0;

    static void describe(TypeBuilder<Score>& type) {
        type.name("Score").doc("Counts the points of a level; Labels show them with {score} and {best}.");
        type.field<&Score::points>("points").transient();
    }
};
/// A resource: one value of the world, which changes of the scene do not end.
struct BestScore {
    int points = 0;  ///< highest number of points since the game was started

    static void describe(TypeBuilder<BestScore>& type) {
        type.name("BestScore");
        type.field<&BestScore::points>("points");
    }
    /// Makes it part of the world's hash, so that replays check it.
    void addTo(Hasher& hasher) const { hasher.add(static_cast<std::uint64_t>(points)); }
};
struct Coin {
    int value = 1;  ///< points

    static void describe(TypeBuilder<Coin>& type) {
        type.name("Coin").doc(
            "Collected by a Collector that touches it; needs a collider that is a trigger.");
        type.field<&Coin::value>("value").range(0.0f, 1000.0f).doc("Points.");
    }
};
struct Collector {
    static void describe(TypeBuilder<Collector>& type) { type.name("Collector").doc("Collects Coins."); }
};

/// Adds points to the score of the level. Call it wherever points are won.
void addPoints(World& world, int points) {
    for (auto [entity, score] : world.query<Score>()) score.points += points;
}

struct ScoreSystem {
    void update(World& world, float) {
        forEachTouch<TriggerEntered, Coin, Collector>(world, [&](EntityId coin, EntityId) {
            addPoints(world, world.get<const Coin>(coin).value);
            world.destroy(coin);
        });
        BestScore& best = world.resource<BestScore>();
        for (auto [entity, score] : world.query<const Score>()) {
            best.points = std::max(best.points, score.points);
            showText(world, "score", format("{}", score.points));
        }
        showText(world, "best", format("{}", best.points));
    }
};

void addScore(Module& module) {
    module.components<Score, Coin, Collector>();
    module.resources<BestScore>();
    module.system<ScoreSystem>();  // in all scenes: the title shows {best}, too
}
