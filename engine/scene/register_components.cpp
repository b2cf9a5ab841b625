#include "scene/register_components.hpp"

#include "reflect/type_registry.hpp"
#include "scene/components/animator.hpp"
#include "scene/components/box_collider.hpp"
#include "scene/components/camera.hpp"
#include "scene/components/character_body.hpp"
#include "scene/components/circle_collider.hpp"
#include "scene/components/hidden.hpp"
#include "scene/components/kinematic_body.hpp"
#include "scene/components/label.hpp"
#include "scene/components/name.hpp"
#include "scene/components/overlay.hpp"
#include "scene/components/parallax_layer.hpp"
#include "scene/components/persistent.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/rigid_body.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/sprite.hpp"
#include "scene/components/static_body.hpp"
#include "scene/components/tile_collider.hpp"
#include "scene/components/tile_layer.hpp"
#include "scene/components/transform.hpp"

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
    types.add<Label>();
    types.add<Camera>();
    types.add<RigidBody>();
    types.add<StaticBody>();
    types.add<KinematicBody>();
    types.add<CharacterBody>();
    types.add<BoxCollider>();
    types.add<CircleCollider>();
    types.add<Hidden>();
    types.add<Persistent>();
    types.add<Overlay>();
}

}  // namespace plumb
