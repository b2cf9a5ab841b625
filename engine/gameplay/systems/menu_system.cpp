#include "gameplay/systems/menu_system.hpp"

#include <algorithm>

#include "core/fixed_list.hpp"
#include "ecs/world.hpp"
#include "gameplay/components/controls/menu.hpp"
#include "gameplay/components/controls/menu_item.hpp"
#include "gameplay/scene_choice.hpp"
#include "gameplay/sound_cue.hpp"
#include "input/input.hpp"
#include "render/view.hpp"
#include "scene/components/drawing/label.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/transform.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/files/rough_text.hpp"
#include "scene/scene_requests.hpp"
#include "scene/scene_stack.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/world_transform.hpp"

namespace plumb {

namespace {

constexpr std::size_t kMostItems = 32;
constexpr float kPushed = 0.5f;  // axis value above which the stick counts as pushed

using Items = FixedList<EntityId, kMostItems>;

SceneId sceneOf(const World& world, EntityId entity) {
    const auto* source = world.find<SceneEntity>(entity);
    return source == nullptr ? SceneId{} : source->scene;
}

Items itemsOf(World& world, EntityId menu) {
    Items items;
    const SceneId scene = sceneOf(world, menu);
    for (auto [entity, item] : world.query<const MenuItem>()) {
        if (sceneOf(world, entity) == scene && !items.full()) items.push(entity.id());
    }
    const auto orderOf = [&world](EntityId id) { return std::as_const(world).get<MenuItem>(id).order; };
    std::sort(items.begin(), items.end(), [&](EntityId a, EntityId b) {
        return orderOf(a) != orderOf(b) ? orderOf(a) < orderOf(b) : a.index < b.index;
    });
    return items;
}

EntityId at(const Items& items, int index) { return items[static_cast<std::size_t>(index)]; }

/// False for an item that loads a slot without a saved game.
bool isEnabled(const World& world, EntityId id) {
    return world.get<MenuItem>(id).action != MenuAction::Load || hasSave(world, saveSlotOf(world, id));
}

/// Returns the next enabled item in a direction, 1 or -1; `from` if there is no other.
int next(const World& world, const Items& items, int from, int direction) {
    const auto count = static_cast<int>(items.size());
    int index = from;
    do {
        index = (index + direction + count) % count;
    } while (index != from && !isEnabled(world, at(items, index)));
    return index;
}

void move(World& world, EntityId id, Menu& menu, const Input& input, const Items& items) {
    const float axis = input.getAxis(Axis::Vertical);
    const int push = axis > kPushed ? 1 : axis < -kPushed ? -1 : 0;
    if (push != 0 && push != menu.pushed) {
        menu.selected = next(world, items, menu.selected, push);
        playCue(world, id, &SoundCues::step);
    }
    menu.pushed = push;
}

/// Returns the index of the enabled item at a position (px, world); -1 for none.
int itemAt(const World& world, const Items& items, const View& view, Vec2 place) {
    const Vec2 corner = view.center - view.size * (0.5f / view.zoom);
    for (int i = 0; i < static_cast<int>(items.size()); ++i) {
        const EntityId item = at(items, i);
        const Label* label = world.find<Label>(item);
        if (label == nullptr || !isEnabled(world, item)) continue;
        const Pose pose = worldPose(world, item);
        const Vec2 from = label->screen ? corner + pose.position : pose.position;
        const AABB box = roughTextBox(world, *label);
        if (contains({from + box.min, from + box.max}, place)) return i;
    }
    return -1;
}

/// Selects the item under the mouse.
/// @return true if it was clicked
bool point(World& world, EntityId id, Menu& menu, const Input& input, const Items& items) {
    const bool pressed = input.isPressed(MouseButton::Left);
    const Vec2 before = input.previousFrame().mouse();
    // Where the mouse is becomes known after the game begins: it may rest on an item and has not moved there.
    if (!pressed && (input.mouse() == before || before == Vec2{})) return false;
    const View view =
        cameraView(world, world.resource<PictureSize>().size, 1.0f, static_cast<int>(placeOf(world, id)));
    const int under = itemAt(std::as_const(world), items, view, toWorld(view, input.mouse()));
    if (under < 0) return false;
    if (under != menu.selected) playCue(world, id, &SoundCues::step);
    menu.selected = under;
    return pressed;
}

void show(World& world, const Menu& menu, const Items& items) {
    for (int i = 0; i < static_cast<int>(items.size()); ++i) {
        Label* label = world.find<Label>(at(items, i));
        if (label == nullptr) continue;
        label->color = i == menu.selected ? menu.selectedColor : menu.color;
        if (!isEnabled(world, at(items, i))) label->color.a = static_cast<std::uint8_t>(menu.color.a / 4);
    }
    const auto* place = std::as_const(world).find<Transform>(at(items, menu.selected));
    Transform* cursor = world.find<Transform>(menu.cursor);
    if (place != nullptr && cursor != nullptr) teleport(*cursor, place->position + menu.cursorOffset);
}

}  // namespace

void MenuSystem::update(World& world, float) {
    for (auto [entity, menu] : world.query<Menu>()) {
        const Input& input = inputFor(world, entity);
        const Items items = itemsOf(world, entity);
        if (menu.closes && (input.isPressed(Action::Pause) || input.isPressed(Action::Cancel))) {
            playCue(world, entity, &SoundCues::activate);
            world.resource<SceneRequests>().close = true;
            continue;
        }
        if (items.empty()) continue;
        menu.selected = std::clamp(menu.selected, 0, static_cast<int>(items.size()) - 1);
        if (!isEnabled(world, at(items, menu.selected))) menu.selected = next(world, items, menu.selected, 1);
        move(world, entity, menu, input, items);
        const bool pressed = point(world, entity, menu, input, items);
        show(world, menu, items);
        if (!pressed && !input.isPressed(Action::Confirm)) continue;
        const EntityId chosen = at(items, menu.selected);
        if (!isEnabled(world, chosen)) continue;
        playCue(world, entity, &SoundCues::activate);
        const auto& item = std::as_const(world).get<MenuItem>(chosen);
        choose(world, chosen, item.action, item.scene);
    }
}

}  // namespace plumb
