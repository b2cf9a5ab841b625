#include <algorithm>
#include <iterator>

#include <gtest/gtest.h>

#include "app/screen.hpp"
#include "scene/components.hpp"
#include "scene/drawing/physics_drawing.hpp"
#include "scene/systems/physics_system.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

constexpr int kLegendWidth = 150;  ///< px; the legend is in the columns left of this

/// Adds a pile of boxes on a floor and a pendulum, all to the right of the legend.
void fill(World& world) {
    world.addSystem<PhysicsSystem>();
    Entity floor = world.createEntity();
    floor.addComponent<Transform>(200.0f, 180.0f);
    floor.addComponent<BoxCollider>(180.0f, 16.0f);
    for (int i = 0; i < 3; ++i) {
        Entity box = world.createEntity();
        box.addComponent<Transform>(240.0f, 160.0f - 30.0f * static_cast<float>(i));
        box.addComponent<RigidBody>();
        box.addComponent<BoxCollider>(20.0f, 20.0f);
    }
    Entity ball = world.createEntity();
    ball.addComponent<Transform>(340.0f, 60.0f);
    ball.addComponent<RigidBody>();
    ball.addComponent<CircleCollider>(10.0f);
    ball.addComponent<RevoluteJoint>().anchor = {-40.0f, -20.0f};
    for (int i = 0; i < 20; ++i) {
        world.beginTick();
        world.update(1.0f / 60.0f);
    }
}

/// True if the layer draws something in this scene, which has no triggers, fields, sleeping bodies etc.
bool drawsHere(const PhysicsLayer& layer) {
    constexpr std::string_view kAbsent[] = {"triggers", "fields", "sleep", "sweeps", "friction", "paths"};
    return layer.ofBodies &&
           std::find(std::begin(kAbsent), std::end(kAbsent), layer.name) == std::end(kAbsent);
}

/// Number of pixels that are not black in both parts of the window.
struct Seen {
    int legend = 0;
    int scene = 0;
};

Seen seen(const Image& image) {
    Seen found;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::size_t i = static_cast<std::size_t>(y * image.width + x) * 4;
            const bool lit = image.rgba[i] + image.rgba[i + 1] + image.rgba[i + 2] > 90;
            (x < kLegendWidth ? found.legend : found.scene) += lit ? 1 : 0;
        }
    }
    return found;
}

TEST(PhysicsView, eachLayerIsDrawnWithItsLegendOnlyIfEnabled) {
    Result<std::unique_ptr<Screen>> opened =
        Screen::open({"test", 400, 440, false, {400.0f, 440.0f}, WindowScale::Fit});
    ASSERT_TRUE(opened) << opened.error().text();
    Screen& screen = **opened;
    World world;
    AssetStore assets{{}, test::sourceFolder() / "assets"};
    fill(world);
    const std::uint64_t before = world.hash();
    for (const PhysicsLayer& layer : physicsLayers()) {
        SCOPED_TRACE(layer.name);
        screen.draw(world, assets, 1.0f, {layer.bit});
        const Seen shown = seen(screen.picture());
        EXPECT_EQ(shown.legend > 20, layer.ofBodies);
        // Layers that are not drawn as shapes are written as text at the right.
        if (drawsHere(layer) || !layer.ofBodies) {
            EXPECT_GT(shown.scene, 15);
        }
        screen.draw(world, assets, 1.0f);
        const Seen hidden = seen(screen.picture());
        EXPECT_EQ(hidden.legend, 0);
        EXPECT_EQ(hidden.scene, 0);
    }
    EXPECT_EQ(world.hash(), before);
}

}  // namespace
}  // namespace plumb
