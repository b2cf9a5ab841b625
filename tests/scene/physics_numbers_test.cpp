#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "reflect/type_registry.hpp"
#include "scene/register_components.hpp"
#include "tests/scene/physics_scene.hpp"

namespace plumb {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kBad[] = {std::numeric_limits<float>::quiet_NaN(),
                          kInfinity,
                          -kInfinity,
                          0.0f,
                          -1.0f,
                          1e-30f,
                          1e9f,
                          -1e9f,
                          1e30f,
                          -1e30f,
                          std::numeric_limits<float>::max()};

constexpr std::string_view kPhysicsComponents[] = {
    "Transform",      "RigidBody",       "KinematicBody",   "CharacterController", "BoxCollider",
    "CircleCollider", "CapsuleCollider", "PolygonCollider", "ChainCollider",       "ScenePhysics",
    "RevoluteJoint",  "DistanceJoint",   "PrismaticJoint",  "WeldJoint",           "WheelJoint",
    "MouseJoint",     "MotorJoint",      "PulleyJoint",     "GearJoint",           "GravityField",
    "WindField",      "BuoyancyField",   "Attractor",       "Explosion",
};

/// Location of a number in a field, as an offset in bytes from the field's address.
struct Number {
    const FieldInfo* field = nullptr;
    std::size_t offset = 0;
    bool whole = false;  ///< the field is an integer
};

std::vector<Number> numbersOf(const TypeInfo& type) {
    std::vector<Number> numbers;
    for (const FieldInfo& field : type.fields) {
        if (field.transient) continue;
        const std::size_t floats = field.kind == FieldKind::Float ? 1 : field.kind == FieldKind::Vec2 ? 2 : 0;
        for (std::size_t i = 0; i < floats; ++i) numbers.push_back({&field, i * sizeof(float), false});
        if (field.kind == FieldKind::Int) numbers.push_back({&field, 0, true});
        if (field.kind == FieldKind::List && field.element == FieldKind::Vec2)
            numbers.push_back({&field, sizeof(Vec2), false});
    }
    return numbers;
}

/// True for fields in which NaN or infinity is valid: it means no limit, the value of the RigidBody, maximum
/// rounding, or the scale of the other axis.
bool hasAnswer(std::string_view field) {
    constexpr std::string_view kFields[] = {"breakForce", "maxForce", "maxTorque", "friction",
                                            "bounciness", "rounding", "scale",     "tolerance"};
    return std::find(std::begin(kFields), std::end(kFields), field) != std::end(kFields);
}

/// An entity with a component that is valid except for one number, and a crate that is independent of it.
class Case {
public:
    Case(const TypeInfo& type, const Number& number) : type_{type}, number_{number} {
        scene_.floor({-500, 100}, {1000, 20}).get<BoxCollider>().layers = 3;
        other_ = scene_.ball({40, 0});
        hero_ = scene_.at({0, 0});
        const std::string_view name = type.name;
        const bool moves =
            name != "KinematicBody" && name != "ChainCollider" && name != "CharacterController";
        if (moves) hero_.addComponent<RigidBody>();
        if (name.find("Collider") == std::string_view::npos && number.field->name != "size")
            hero_.addComponent<CircleCollider>(8.0f);
        if (name == "GearJoint") {
            hero_.addComponent<RevoluteJoint>();
            other_.addComponent<RevoluteJoint>();
        }
        if (scene_.world.find(type, hero_.id()) == nullptr) scene_.world.add(type, hero_.id());
        if (const FieldInfo* other = type.find("other"))
            *static_cast<EntityId*>(other->in(scene_.world.find(type, hero_.id()))) = other_.id();
        if (const FieldInfo* points = type.find("points")) {
            void* object = scene_.world.find(type, hero_.id());
            points->countOf(points->in(object)) = 3;
            const Vec2 corners[] = {{0, 0}, {20, 0}, {10, 20}};
            std::memcpy(points->in(object), corners, sizeof corners);
        }
        if (number.field->name == "otherAnchor")
            *static_cast<bool*>(type.find("autoAnchor")->in(scene_.world.find(type, hero_.id()))) = false;
        bystander_ = scene_.crate({400, 60});
        bystander_.get<BoxCollider>().layers = bystander_.get<BoxCollider>().mask = 2;
    }

    void spoil(float value) {
        void* object = scene_.world.find(type_, hero_.id());
        if (object == nullptr) return;  // the explosion has removed itself
        char* memory = static_cast<char*>(number_.field->in(object)) + number_.offset;
        if (number_.whole) {
            const auto number = static_cast<std::int64_t>(
                std::isnan(value) ? 0.0f : std::fmin(std::fmax(value, -1e18f), 1e18f));
            std::memcpy(memory, &number, number_.field->size);
        } else {
            std::memcpy(memory, &value, sizeof value);
        }
    }
    void run(int ticks) { scene_.run(ticks); }

    /// True if the number is finite now or its component has removed itself.
    [[nodiscard]] bool isMended() {
        void* object = scene_.world.find(type_, hero_.id());
        if (object == nullptr) return true;
        float value = 0.0f;
        std::memcpy(&value, static_cast<char*>(number_.field->in(object)) + number_.offset, sizeof value);
        return std::isfinite(value);
    }
    void expectFinite() {
        for (const Entity entity : {hero_, other_, bystander_}) {
            if (entity.id() == hero_.id() && type_.name == "Transform") continue;
            const Transform& transform = entity.get<Transform>();
            EXPECT_TRUE(std::isfinite(transform.position.x) && std::isfinite(transform.position.y));
            EXPECT_TRUE(std::isfinite(transform.rotation));
            const RigidBody* body = std::as_const(scene_.world).find<RigidBody>(entity.id());
            const bool own = entity.id() == hero_.id() && type_.name == "RigidBody";
            if (body != nullptr && !own) {
                EXPECT_TRUE(std::isfinite(body->velocity.x) && std::isfinite(body->velocity.y));
                EXPECT_TRUE(std::isfinite(body->angularVelocity));
            }
        }
        const std::string_view name = type_.name;
        const bool everywhere = name.find("Field") != std::string_view::npos || name == "Attractor" ||
                                name == "Explosion" || name == "ScenePhysics" || name == "Transform";
        if (everywhere) return;
        EXPECT_TRUE(bystander_.get<RigidBody>().grounded) << "the independent crate must land as usual";
        EXPECT_NEAR(bystander_.get<Transform>().position.y, 84.0f, 0.5f);
    }

private:
    const TypeInfo& type_;
    Number number_;
    PhysicsScene scene_;
    Entity hero_;
    Entity other_;
    Entity bystander_;
};

TEST(PhysicsNumbers, invalidNumbersInAnyFieldAreReportedOrHaveAMeaning) {
    TypeRegistry types;
    registerSceneComponents(types);
    std::size_t warnings = 0;
    const LogSink before = setLogSink([&](const LogLine&) { ++warnings; });
    for (const std::string_view name : kPhysicsComponents) {
        const TypeInfo* type = types.find(name);
        ASSERT_NE(type, nullptr) << name;
        for (const Number& number : numbersOf(*type)) {
            for (const float value : kBad) {
                for (const bool fromTheStart : {true, false}) {
                    SCOPED_TRACE(std::string{name} + "." + std::string{number.field->name} + " = " +
                                 std::to_string(value) + (fromTheStart ? " at the start" : " in play"));
                    Case one{*type, number};
                    warnings = 0;
                    if (!fromTheStart) one.run(5);
                    one.spoil(value);
                    one.run(45);
                    one.expectFinite();
                    if (std::isfinite(value) || number.whole) continue;
                    EXPECT_TRUE(warnings > 0 || one.isMended() || hasAnswer(number.field->name));
                    EXPECT_LE(warnings, 3u) << "warnings must not repeat in every tick";
                }
            }
        }
    }
    setLogSink(before);
}

TEST(PhysicsNumbers, anInvalidScaleIsReplacedByTheDefault) {
    for (const float pixels : kBad) {
        if (pixels == 1e9f) continue;
        PhysicsScene scene;
        scene.world.resource<PhysicsSettings>().pixelsPerMetre = pixels;
        const Entity ball = scene.ball({0, 0});
        scene.run(60);
        EXPECT_NEAR(ball.get<RigidBody>().velocity.y, 980.0f, 0.1f) << pixels;
    }
}

TEST(PhysicsNumbers, anEntityGetsABodyOnceItsPositionIsValid) {
    const LogSink before = setLogSink([](const LogLine&) {});
    PhysicsScene scene;
    const Entity ball = scene.ball({0, 0});
    ball.get<Transform>().position.x = kInfinity;
    scene.run(10);
    EXPECT_EQ(physics::bodyCount(scene.state().world), 0u);
    ball.get<Transform>().position = {0, 0};
    scene.run(60);
    setLogSink(before);
    EXPECT_GT(PhysicsScene::place(ball).y, 400.0f);
}

}  // namespace
}  // namespace plumb
