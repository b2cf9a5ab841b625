#pragma once

#include <map>
#include <string>

#include "import/ldtk_tilesets.hpp"

namespace plumb {

/// Which entity of the scene something of LDtk became, by its iid.
using LdtkIds = std::map<std::string, std::string>;

/// How what stands in a layer of this kind moves with the view.
Json ldtkParallax(const ldtk::LayerKind& kind);

/// Fields as properties: texts, numbers and flags as they are, points with the place that they mean, pictures
/// with their file. Names of entities are put in by `linkEntities`, once all are known.
Json ldtkProperties(const std::vector<ldtk::Field>& fields, const ldtk::Project& project, int grid);

/// Adds an entity with its picture, its area when it has one, and its fields.
/// @param order  of drawing
void addLdtkEntity(const ldtk::Entity& entity, const ldtk::Layer& layer, const ldtk::Project& project,
                   LdtkTilesets& tilesets, int order, SceneDraft& draft, LdtkIds& ids);

/// Gives every reference among the properties the id that its entity has in the scene.
void linkEntities(Json& properties, const LdtkIds& ids);

}  // namespace plumb
