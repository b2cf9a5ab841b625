#pragma once

// Every component of a scene, for game code.

#include "scene/components/animator.hpp"
#include "scene/components/box_collider.hpp"
#include "scene/components/camera.hpp"
#include "scene/components/character_body.hpp"
#include "scene/components/circle_collider.hpp"
#include "scene/components/hidden.hpp"
#include "scene/components/kinematic_body.hpp"
#include "scene/components/label.hpp"
#include "scene/components/name.hpp"
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
