#pragma once

// Includes every component of the scene layer.

#include "reflect/type_list.hpp"
#include "scene/components/bodies/character_body.hpp"
#include "scene/components/bodies/character_controller.hpp"
#include "scene/components/bodies/cloth.hpp"
#include "scene/components/bodies/ghost.hpp"
#include "scene/components/bodies/jelly.hpp"
#include "scene/components/bodies/kinematic_body.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/bodies/rope.hpp"
#include "scene/components/bodies/soft_grip.hpp"
#include "scene/components/bodies/static_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/colliders/capsule_collider.hpp"
#include "scene/components/colliders/chain_collider.hpp"
#include "scene/components/colliders/circle_collider.hpp"
#include "scene/components/colliders/polygon_collider.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/components/drawing/animator.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/drawing/hidden.hpp"
#include "scene/components/drawing/label.hpp"
#include "scene/components/drawing/overlay.hpp"
#include "scene/components/drawing/parallax_layer.hpp"
#include "scene/components/drawing/particle_emitter.hpp"
#include "scene/components/drawing/plot.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/experiment.hpp"
#include "scene/components/fields/attractor.hpp"
#include "scene/components/fields/buoyancy_field.hpp"
#include "scene/components/fields/explosion.hpp"
#include "scene/components/fields/gravity_field.hpp"
#include "scene/components/fields/wind_field.hpp"
#include "scene/components/joints/distance_joint.hpp"
#include "scene/components/joints/gear_joint.hpp"
#include "scene/components/joints/motor_joint.hpp"
#include "scene/components/joints/mouse_joint.hpp"
#include "scene/components/joints/prismatic_joint.hpp"
#include "scene/components/joints/pulley_joint.hpp"
#include "scene/components/joints/revolute_joint.hpp"
#include "scene/components/joints/weld_joint.hpp"
#include "scene/components/joints/wheel_joint.hpp"
#include "scene/components/name.hpp"
#include "scene/components/persistent.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/scene_physics.hpp"
#include "scene/components/slider.hpp"
#include "scene/components/tags.hpp"
#include "scene/components/transform.hpp"

namespace plumb {

/// All components of the scene layer, in the order in which files, the inspector and scripts list them.
using SceneComponents =
    TypeList<SceneEntity, PrefabInstance, PrefabPart, Name, Transform, Sprite, Animator, TileLayer,
             TileCollider, ParallaxLayer, ParticleEmitter, Label, Camera, RigidBody, StaticBody,
             KinematicBody, CharacterBody, CharacterController, BoxCollider, CircleCollider, CapsuleCollider,
             PolygonCollider, ChainCollider, ScenePhysics, RevoluteJoint, DistanceJoint, PrismaticJoint,
             WeldJoint, WheelJoint, MouseJoint, MotorJoint, PulleyJoint, GearJoint, GravityField, WindField,
             BuoyancyField, Attractor, Explosion, Rope, Cloth, Jelly, SoftGrip, Hidden, Tags, Persistent,
             Overlay, Slider, Plot, Ghost, Experiment>;

}  // namespace plumb
