#include <array>

#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "scene/files/scene_reader.hpp"

namespace plumb {
namespace {

/// Format 0 had no Transform; the position was a key of the entity.
void moveIntoTransform(Json& entity) {
    const Json* position = findMember(entity, "position");
    if (position == nullptr) return;
    Json value = *position;
    entity.erase("position");
    makeObject(makeObject(entity, "components"), "Transform")["position"] = std::move(value);
}

struct Migration {
    int from;
    void (*migrate)(Json& entity);
};
constexpr std::array kMigrations{Migration{0, &moveIntoTransform}};

}  // namespace

void migrateEntity(Json& entity, int format) {
    for (const Migration& migration : kMigrations) {
        if (migration.from >= format) migration.migrate(entity);
    }
}

}  // namespace plumb
