#include "tests/bench/physics/ragdoll.hpp"

#include "math/portable.hpp"

namespace plumb::scenes {

namespace {

enum Bone : std::size_t {
    kHip,
    kTorso,
    kHead,
    kUpperLegA,
    kLowerLegA,
    kUpperLegB,
    kLowerLegB,
    kUpperArmA,
    kLowerArmA,
    kUpperArmB,
    kLowerArmB
};

struct BoneForm {
    Bone bone;
    Bone parent;
    float y;          ///< height of the body's origin above the feet, m
    float low, high;  ///< ends of the capsule, m from y
    float radius;     ///< m
    float drag;       ///< 1/s
    float pivot;      ///< height of the hinge to the parent above the feet, m
    float lower;      ///< lower limit of the hinge, multiples of pi rad
    float upper;      ///< upper limit of the hinge, multiples of pi rad
    float friction;   ///< friction of the hinge, ratio of kHingeTorque
    float reference;  ///< reference angle of the hinge, multiples of pi rad
};

constexpr std::array kBones{
    BoneForm{kHip, kHip, 0.95f, -0.02f, 0.02f, 0.095f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f},
    BoneForm{kTorso, kHip, 1.2f, -0.135f, 0.135f, 0.09f, 0.0f, 1.0f, -0.25f, 0.0f, 0.5f, 0.0f},
    BoneForm{kHead, kTorso, 1.475f, -0.038f, 0.038f, 0.075f, 0.1f, 1.4f, -0.3f, 0.1f, 0.25f, 0.0f},
    BoneForm{kUpperLegA, kHip, 0.775f, -0.125f, 0.125f, 0.06f, 0.0f, 0.9f, -0.05f, 0.4f, 1.0f, 0.0f},
    BoneForm{kLowerLegA, kUpperLegA, 0.475f, -0.155f, 0.125f, 0.045f, 0.0f, 0.625f, -0.5f, -0.02f, 0.5f,
             0.0f},
    BoneForm{kUpperLegB, kHip, 0.775f, -0.125f, 0.125f, 0.06f, 0.0f, 0.9f, -0.05f, 0.4f, 1.0f, 0.0f},
    BoneForm{kLowerLegB, kUpperLegB, 0.475f, -0.155f, 0.125f, 0.045f, 0.0f, 0.625f, -0.5f, -0.02f, 0.5f,
             0.0f},
    BoneForm{kUpperArmA, kTorso, 1.225f, -0.125f, 0.125f, 0.035f, 0.0f, 1.35f, -0.1f, 0.8f, 0.5f, 0.0f},
    BoneForm{kLowerArmA, kUpperArmA, 0.975f, -0.125f, 0.125f, 0.03f, 0.1f, 1.1f, -0.2f, 0.3f, 0.1f, 0.25f},
    BoneForm{kUpperArmB, kTorso, 1.225f, -0.125f, 0.125f, 0.035f, 0.0f, 1.35f, -0.1f, 0.8f, 0.5f, 0.0f},
    BoneForm{kLowerArmB, kUpperArmB, 0.975f, -0.125f, 0.125f, 0.03f, 0.1f, 1.1f, -0.2f, 0.3f, 0.1f, 0.25f},
};

constexpr std::array kFoot{Vec2{-0.03f, -0.185f}, Vec2{0.11f, -0.185f}, Vec2{0.11f, -0.16f},
                           Vec2{-0.03f, -0.14f}};
constexpr float kHingeTorque = 0.05f;  // N m: friction of a hinge
constexpr std::uint32_t kGround = 1;
constexpr std::uint32_t kFigures = 2;

JointSetup hingeOf(const BoneForm& bone, const Ragdoll& ragdoll) {
    const auto angle = [](float halfTurns) { return halfTurns * kPi; };
    return {.a = ragdoll.bodies[bone.parent],
            .b = ragdoll.bodies[bone.bone],
            .anchorA = {0.0f, bone.pivot - kBones[bone.parent].y},
            .anchorB = {0.0f, bone.pivot - bone.y},
            .reference = angle(bone.reference),
            .limited = true,
            .lower = angle(bone.lower),
            .upper = angle(bone.upper),
            .driven = true,
            .maxForce = kHingeTorque * bone.friction,
            .sprung = true,
            .hertz = 5.0f,
            .dampingRatio = 0.5f};
}

}  // namespace

Ragdoll addRagdoll(SceneBuilder& world, Vec2 feet, int group) {
    static const Outline foot = polygon(kFoot, 0.015f);
    const Material skin{.friction = 0.2f, .layers = kFigures, .mask = kGround | kFigures, .group = group};
    Material sole = skin;
    sole.friction = 0.05f;
    sole.mask = kGround;
    Ragdoll ragdoll;
    for (const BoneForm& bone : kBones) {
        const BodyHandle body =
            world.createBody({.position = feet + Vec2{0.0f, bone.y}, .drag = bone.drag, .sleepSpeed = 0.1f});
        ragdoll.bodies[bone.bone] = body;
        world.addShape(body, capsule({0.0f, bone.low}, {0.0f, bone.high}, bone.radius), skin);
        if (bone.bone == kLowerLegA || bone.bone == kLowerLegB) world.addShape(body, foot, sole);
        if (bone.bone != bone.parent) world.addJoint(hingeOf(bone, ragdoll));
    }
    return ragdoll;
}

void removeRagdoll(SceneBuilder& world, const Ragdoll& ragdoll) {
    for (const BodyHandle body : ragdoll.bodies) world.destroy(body);
}

}  // namespace plumb::scenes
