#include "app/event_log.hpp"

#include <cctype>

#include "assets/asset_store.hpp"
#include "core/log.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/name.hpp"
#include "scene/physics/contact_events.hpp"

namespace plumb {
namespace {

/// Returns the title of a path, e.g. "Platform" for "assets/platform.png".
std::string titleOf(std::string_view path) {
    path = path.substr(path.find_last_of('/') + 1);
    std::string title{path.substr(0, path.find('.'))};
    if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

}  // namespace

std::string displayName(const World& world, EntityId entity) {
    if (const auto* name = world.find<const Name>(entity); name != nullptr && !name->text.empty()) {
        return std::string{world.texts().find(name->text)};
    }
    const auto* sprite = world.find<const Sprite>(entity);
    const AssetStore* assets = world.service<AssetStore>();
    if (sprite == nullptr || assets == nullptr || sprite->texture.empty())
        return format("Entity[{}]", entity.index);
    int count = 0;
    int number = 0;
    for (auto [other, picture] : world.query<const Sprite>()) {
        if (!(picture.texture == sprite->texture)) continue;
        ++count;
        if (other.id() < entity) ++number;
    }
    const std::string title = titleOf(assets->pathOf(sprite->texture));
    return count > 1 ? format("{}[{}]", title, number) : title;
}

void EventLog::write(const World& world) {
    const Entity player = world.query<const PlayerController>().first();
    if (!player) return;
    for (const ContactBegan& contact : world.events<ContactBegan>()) {
        if (contact.a != player.id() && contact.b != player.id()) continue;
        const EntityId other = contact.a == player.id() ? contact.b : contact.a;
        logNote("Collision", "{} <-> {}", displayName(world, player), displayName(world, other));
    }
    if (const auto* body = world.find<const RigidBody>(player)) {
        if (player.id() == player_ && body->grounded != grounded_) {
            logNote("Physics", "{} grounded: {}", displayName(world, player), body->grounded);
        }
        player_ = player;
        grounded_ = body->grounded;
    }
}

}  // namespace plumb
