#pragma once

#include <cstdint>
#include <string_view>

#include "core/result.hpp"
#include "core/text_store.hpp"
#include "reflect/entity_id.hpp"
#include "reflect/field_types.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb {

/// Resolves the ids inside components. Fields contain ids; files contain texts, paths,
/// hex ids and tiles. Only the owner of the stores can convert between them.
class FieldContext {
public:
    virtual ~FieldContext() = default;

    [[nodiscard]] virtual std::string_view text(TextId id) const = 0;
    virtual TextId keepText(std::string_view text) = 0;

    /// The id of an entity in files; 0 if it has none.
    [[nodiscard]] virtual std::uint64_t stableId(EntityId entity) const = 0;
    /// The entity with this id in files; the empty id if there is none.
    [[nodiscard]] virtual EntityId entity(std::uint64_t stableId) const = 0;

    [[nodiscard]] virtual Json tilesToJson(TilesId tiles) const = 0;
    /// @param field  named in errors and warnings
    virtual Result<TilesId> tilesFromJson(const FieldInfo& field, const Json& json) = 0;
    [[nodiscard]] virtual bool sameTiles(TilesId a, TilesId b) const { return a == b; }

    /// Receives warnings about values that had to be changed, such as a clamp to a range.
    virtual void warn(Error error) = 0;
};

}  // namespace plumb
