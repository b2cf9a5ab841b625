#include "scene/register_components.hpp"

#include "reflect/type_registry.hpp"
#include "scene/components/animator.hpp"
#include "scene/components/attractor.hpp"
#include "scene/components/box_collider.hpp"
#include "scene/components/buoyancy_field.hpp"
#include "scene/components/camera.hpp"
#include "scene/components/capsule_collider.hpp"
#include "scene/components/chain_collider.hpp"
#include "scene/components/character_body.hpp"
#include "scene/components/character_controller.hpp"
#include "scene/components/circle_collider.hpp"
#include "scene/components/cloth.hpp"
#include "scene/components/distance_joint.hpp"
#include "scene/components/experiment.hpp"
#include "scene/components/explosion.hpp"
#include "scene/components/gear_joint.hpp"
#include "scene/components/ghost.hpp"
#include "scene/components/gravity_field.hpp"
#include "scene/components/hidden.hpp"
#include "scene/components/jelly.hpp"
#include "scene/components/kinematic_body.hpp"
#include "scene/components/label.hpp"
#include "scene/components/motor_joint.hpp"
#include "scene/components/mouse_joint.hpp"
#include "scene/components/name.hpp"
#include "scene/components/overlay.hpp"
#include "scene/components/parallax_layer.hpp"
#include "scene/components/particle_emitter.hpp"
#include "scene/components/persistent.hpp"
#include "scene/components/plot.hpp"
#include "scene/components/polygon_collider.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/prismatic_joint.hpp"
#include "scene/components/pulley_joint.hpp"
#include "scene/components/revolute_joint.hpp"
#include "scene/components/rigid_body.hpp"
#include "scene/components/rope.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/scene_physics.hpp"
#include "scene/components/slider.hpp"
#include "scene/components/soft_grip.hpp"
#include "scene/components/sprite.hpp"
#include "scene/components/static_body.hpp"
#include "scene/components/tile_collider.hpp"
#include "scene/components/tile_layer.hpp"
#include "scene/components/transform.hpp"
#include "scene/components/weld_joint.hpp"
#include "scene/components/wheel_joint.hpp"
#include "scene/components/wind_field.hpp"

namespace plumb {

void registerSceneComponents(TypeRegistry& types) {
    types.add<SceneEntity>();
    types.add<PrefabInstance>();
    types.add<PrefabPart>();
    types.add<Name>();
    types.add<Transform>();
    types.add<Sprite>();
    types.add<Animator>();
    types.add<TileLayer>();
    types.add<TileCollider>();
    types.add<ParallaxLayer>();
    types.add<ParticleEmitter>();
    types.add<Label>();
    types.add<Camera>();
    types.add<RigidBody>();
    types.add<StaticBody>();
    types.add<KinematicBody>();
    types.add<CharacterBody>();
    types.add<CharacterController>();
    types.add<BoxCollider>();
    types.add<CircleCollider>();
    types.add<CapsuleCollider>();
    types.add<PolygonCollider>();
    types.add<ChainCollider>();
    types.add<ScenePhysics>();
    types.add<RevoluteJoint>();
    types.add<DistanceJoint>();
    types.add<PrismaticJoint>();
    types.add<WeldJoint>();
    types.add<WheelJoint>();
    types.add<MouseJoint>();
    types.add<MotorJoint>();
    types.add<PulleyJoint>();
    types.add<GearJoint>();
    types.add<GravityField>();
    types.add<WindField>();
    types.add<BuoyancyField>();
    types.add<Attractor>();
    types.add<Explosion>();
    types.add<Rope>();
    types.add<Cloth>();
    types.add<Jelly>();
    types.add<SoftGrip>();
    types.add<Hidden>();
    types.add<Persistent>();
    types.add<Overlay>();
    types.add<Slider>();
    types.add<Plot>();
    types.add<Ghost>();
    types.add<Experiment>();
}

}  // namespace plumb
