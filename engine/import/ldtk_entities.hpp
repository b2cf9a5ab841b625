#pragma once

#include <map>
#include <string>

#include "import/ldtk_tilesets.hpp"

namespace plumb {

/// Maps the iid of an LDtk level or entity to the id of its entity in the scene.
using LdtkIds = std::map<std::string, std::string>;

/// Returns the ParallaxLayer component for the entities of a layer.
Json ldtkParallax(const ldtk::LayerKind& kind);

/// Converts LDtk fields to properties: texts, numbers and flags unchanged, points with their position in px,
/// tiles with the name of their tileset. Entity references are resolved later by `linkEntities`.
/// @param grid  px, cell size for points
Json ldtkProperties(const std::vector<ldtk::Field>& fields, const ldtk::Project& project, int grid);

/// Adds an entity with its sprite, a trigger area if it is resizable, and its fields as properties.
/// @param order  drawing order
void addLdtkEntity(const ldtk::Entity& entity, const ldtk::Layer& layer, const ldtk::Project& project,
                   LdtkTilesets& tilesets, int order, SceneDraft& draft, LdtkIds& ids);

/// Adds to each entity reference in the properties the id of that entity in the scene.
void linkEntities(Json& properties, const LdtkIds& ids);

}  // namespace plumb
