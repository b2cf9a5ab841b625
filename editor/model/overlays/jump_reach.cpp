#include "editor/model/overlays/jump_reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/clock.hpp"
#include "ecs/world.hpp"
#include "editor/model/document/bounds.hpp"
#include "gameplay/components/actors/player_controller.hpp"
#include "gameplay/components/actors/respawn.hpp"
#include "input/input.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor {
namespace {

constexpr int kLongest = 150;         // maximum ticks of one simulated jump
constexpr int kSettle = 120;          // maximum ticks until the player stands on the ground at the start
constexpr Vec2 kPlace{48.0f, 16.0f};  // px: size of the grid cells; landings in the same cell count as one

/// Returns the first keyboard key of the bindings.
Key keyOf(const std::vector<Binding>& bindings, Key otherwise) {
    for (const Binding& binding : bindings) {
        if (binding.kind == BindingKind::Key) return static_cast<Key>(binding.code);
    }
    return otherwise;
}

JumpReach::Cell cellAt(Vec2 place, Vec2 size) {
    return {static_cast<int>(std::floor(place.x / size.x)), static_cast<int>(std::floor(place.y / size.y))};
}

}  // namespace

/// One sequence of simulated inputs: run up, jump, hold the jump key, and possibly change direction in the
/// air.
struct JumpReach::Plan {
    int run = 0;    ///< initial direction: -1 left, 0 none, 1 right
    int runUp = 0;  ///< ticks before the jump; negative: no jump
    int hold = 0;   ///< ticks for which the jump key is held
    int after = 0;  ///< direction from `turn` on: -1, 0 or 1
    int turn = 0;   ///< ticks from the jump to the change of direction
};

/// Returns the inputs to try. @param first  true: long list, for the initial position; false: for landings
const std::vector<JumpReach::Plan>& JumpReach::plans(bool first) {
    constexpr int kNever = 1000;
    static const auto make = [](std::initializer_list<int> runUps, std::initializer_list<int> holds) {
        std::vector<Plan> list;
        for (const int run : {1, -1}) {
            list.push_back({run, -1, 0, run, kNever});
            for (const int runUp : runUps) {
                for (const int hold : holds) {
                    list.push_back({run, runUp, hold, run, kNever});
                    list.push_back({run, runUp, hold, -run, 14});
                    list.push_back({run, runUp, hold, 0, 20});
                }
            }
            for (const int hold : holds) list.push_back({0, 0, hold, run, 10});
        }
        for (const int hold : holds) list.push_back({0, 0, hold, 0, kNever});
        return list;
    };
    static const std::vector<Plan> kLong = make({0, 4, 10, 18, 30}, {2, 7, 30});
    static const std::vector<Plan> kShort = make({0, 10, 26}, {4, 30});
    return first ? kLong : kShort;
}

void JumpReach::clear() {
    game_ = nullptr;
    places_.clear();
    stood_.clear();
    cells_.clear();
    arcs_.clear();
    landings_.clear();
    placed_ = 0;
}

void JumpReach::begin(PlaySession& game, EntityId player) {
    clear();
    game_ = &game;
    player_ = player;
    const ActionMap& map = game.world().resource<Input>().map();
    if (const int jump = map.find(plumb::Action::Jump); jump >= 0)
        jump_ = keyOf(map.actions[static_cast<std::size_t>(jump)].bindings, Key::Space);
    if (const int walk = map.find(Axis::Horizontal); walk >= 0) {
        left_ = keyOf(map.axes[static_cast<std::size_t>(walk)].negative, Key::Left);
        right_ = keyOf(map.axes[static_cast<std::size_t>(walk)].positive, Key::Right);
    }
    settle();
    if (alive()) land(0);
}

/// Lets the player fall to the ground: in a scene being edited it may be placed slightly above it.
void JumpReach::settle() {
    for (int tick = 0; tick < kSettle && alive() && !(tick > 1 && grounded()); ++tick) game_->tick({});
}

int JumpReach::work(double seconds) {
    const double end = threadSeconds() + seconds;
    int ticks = 0;
    while (!places_.empty() && threadSeconds() < end) {
        Place& place = places_.front();
        const std::vector<Plan>& list = plans(place.hops == 0);
        if (place.next == list.size()) {
            places_.pop_front();
        } else {
            ticks += tryPlan(place, list[place.next++]);
        }
    }
    return ticks;
}

InputFrame JumpReach::hands(const Plan& plan, int tick, int jumpedAt) const {
    InputFrame frame;
    const int way = jumpedAt >= 0 && tick - jumpedAt >= plan.turn ? plan.after : plan.run;
    frame.set(left_, way < 0);
    frame.set(right_, way > 0);
    frame.set(jump_, jumpedAt >= 0 && tick - jumpedAt < plan.hold);
    return frame;
}

int JumpReach::tryPlan(const Place& from, const Plan& plan) {
    const int hops = from.hops + 1;
    game_->world().restore(from.world);
    game_->restored();
    Arc arc;
    arc.hops = hops;
    int jumpedAt = -1;
    bool flew = false;
    int tick = 0;
    for (; tick < kLongest && alive(); ++tick) {
        if (jumpedAt < 0 && plan.runUp >= 0 && tick >= plan.runUp) jumpedAt = tick;
        game_->tick(hands(plan, tick, jumpedAt));
        if (!alive()) break;
        const AABB now = box();
        arc.points.push_back({now.center().x, now.max.y});
        cover(now, hops);
        flew = flew || !grounded();
        arc.lands = flew && grounded();
        if (arc.lands) break;
        if (jumpedAt >= 0 && !flew && tick - jumpedAt > 8) break;  // the jump was not possible
    }
    if (!flew) return tick;
    if (arc.lands) land(hops);
    if (hops <= 1) arcs_.push_back(std::move(arc));
    return tick;
}

void JumpReach::cover(const AABB& box, int hops) {
    const Cell from = cellAt(box.min, {kCell, kCell});
    const Cell to = cellAt(box.max - Vec2{0.01f, 0.01f}, {kCell, kCell});
    for (int x = from.x; x <= to.x; ++x) {
        for (int y = from.y; y <= to.y; ++y) {
            const auto [known, added] = cells_.try_emplace({x, y}, hops);
            if (!added) known->second = std::min(known->second, hops);
        }
    }
}

/// Records a landing; if its grid cell is new, queues it as the start of further jumps.
void JumpReach::land(int hops) {
    const AABB now = box();
    const Vec2 feet{now.center().x, now.max.y - 1.0f};
    if (!stood_.insert(cellAt(feet, kPlace)).second) return;
    landings_.push_back({now, hops});
    if (hops >= kHops || placed_ >= kPlaces) return;
    ++placed_;
    Place& place = places_.emplace_back();
    game_->world().save(place.world);
    place.hops = hops;
}

bool JumpReach::reaches(Vec2 place) const { return cells_.contains(cellAt(place, {kCell, kCell})); }

bool JumpReach::alive() const {
    const World& world = game_->world();
    if (!world.alive(player_) || !world.has<PlayerController>(player_) || !world.has<RigidBody>(player_))
        return false;
    const Respawn* respawn = world.find<Respawn>(player_);
    return respawn == nullptr || respawn->waiting == 0;
}

bool JumpReach::grounded() const { return std::as_const(game_->world()).get<RigidBody>(player_).grounded; }

AABB JumpReach::box() const {
    const World& world = game_->world();
    const auto* collider = world.find<BoxCollider>(player_);
    const auto* transform = world.find<Transform>(player_);
    if (collider == nullptr || transform == nullptr) return boundsOf(world, player_);
    const Vec2 corner = transform->position + collider->offset;
    return {corner, corner + Vec2{collider->width * std::abs(transform->scale.x),
                                  collider->height * std::abs(transform->scale.y)}};
}

}  // namespace plumb::editor
