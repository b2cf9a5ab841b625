#include <algorithm>

#include "physics/solver/contact_extras.hpp"
#include "physics/solver/contact_sides.hpp"

namespace plumb::physics {

namespace {

/// Calls act(block, bounce, lane) for the contact of an impact.
template <class Act>
void visit(Workspace& work, const ImpactPlace& impact, Act&& act) {
    const auto actIn = [&](auto& store) {
        act(store.blocks[impact.block], store.bounces[impact.block], int{impact.lane});
    };
    impact.fixed ? actIn(work.fixed) : actIn(work.two);
}

/// Calls act(block, bounce, lane) for all impacts, in order.
template <class Act>
void visitAll(Workspace& work, Act&& act) {
    for (const ImpactPlace& impact : work.impacts) visit(work, impact, act);
}

template <class Store>
void gather(const Store& store, BlockRange range, std::vector<ImpactPlace>& impacts) {
    constexpr bool kFixed = decltype(store.blocks[0].a)::kFixed;
    const std::vector<BlockLanes>& lanes = store.lanes;
    const std::size_t before = impacts.size();
    for (auto n = static_cast<std::size_t>(range.begin); n < static_cast<std::size_t>(range.end); ++n) {
        const BounceBlock& bounce = store.bounces[n];
        for (int i = 0; i < lanes[n].count; ++i) {
            if (bounce.bounciness[i] < kLively) continue;
            if (bounce.sum[i] <= 0.0f || bounce.before[i] > kMaxLoad * bounce.largest[0][i]) continue;
            impacts.push_back({kFixed, static_cast<std::uint8_t>(i), static_cast<std::uint32_t>(n)});
        }
    }
    // Sorted by contact index within a color, so that the order does not depend on the lanes.
    const auto numberOf = [&](const ImpactPlace& impact) { return lanes[impact.block].index[impact.lane]; };
    std::sort(impacts.begin() + static_cast<std::ptrdiff_t>(before), impacts.end(),
              [&](const ImpactPlace& a, const ImpactPlace& b) { return numberOf(a) < numberOf(b); });
}

/// Keeps only impacts that share a body with another impact.
void keepChains(Workspace& work) {
    work.hits.resize(work.velocity.size());
    const auto forHits = [&](const ImpactPlace& impact, auto&& act) {
        visit(work, impact, [&](const auto& block, const BounceBlock&, int lane) {
            if constexpr (!decltype(block.a)::kFixed)
                act(work.hits[static_cast<std::size_t>(block.a.slot[lane])]);
            act(work.hits[static_cast<std::size_t>(block.b.slot[lane])]);
        });
    };
    for (const ImpactPlace& impact : work.impacts) forHits(impact, [](std::uint8_t& hits) { hits = 0; });
    for (const ImpactPlace& impact : work.impacts)
        forHits(impact, [](std::uint8_t& hits) { hits = hits == 0 ? 1 : 2; });
    std::erase_if(work.impacts, [&](const ImpactPlace& impact) {
        bool shares = false;
        forHits(impact, [&](const std::uint8_t& hits) { shares = shares || hits == 2; });
        return !shares;
    });
}

bool anyHits(Workspace& work, float slowest) {
    bool hits = false;
    visitAll(work, [&](const auto&, const BounceBlock& bounce, int lane) {
        hits = hits || bounce.approach[0][lane] < -slowest;
    });
    return hits;
}

/// Removes the impulses of the substeps.
void takeBack(Workspace& work) {
    visitAll(work, [&](auto& block, BounceBlock& bounce, int lane) {
        pushApart(work, block, 0, lane, -bounce.sum[lane]);
        block.points[0].impulse[lane] = 0.0f;
    });
}

/// Reduces velocities to those at the impact: acceleration after it would be a gain of energy.
void endAtImpact(Workspace& work, float slowest, float dt) {
    visitAll(work, [&](auto& block, BounceBlock& bounce, int lane) {
        float& before = bounce.approach[0][lane];
        if (before < -slowest) {
            const float met = speedOfImpact(before, approachIn(work, block, 0, lane, dt));
            const float gain = approachOf(work, block, 0, lane) - met;
            pushApart(work, block, 0, lane, -block.points[0].mass[lane] * gain);
        }
        before = 0.0f;  // so that applyRestitution() does nothing
    });
}

/// Collides all approaching pairs sequentially. @return true if any pair approached
bool collideInTurn(Workspace& work, float slowest) {
    bool approached = false;
    visitAll(work, [&](auto& block, const BounceBlock& bounce, int lane) {
        const float speed = approachOf(work, block, 0, lane);
        if (speed > -kNoApproach) return;
        approached = true;
        const float bounciness = speed < -slowest ? bounce.bounciness[lane] : 0.0f;
        const float impulse = -(1.0f + bounciness) * block.points[0].mass[lane] * speed;
        block.points[0].impulse[lane] += impulse;
        pushApart(work, block, 0, lane, impulse);
    });
    return approached;
}

/// Moves a body along the normal.
void moveAlong(Workspace& work, std::int32_t slot, float distance, Vec2 normal) {
    Float4& moved = work.deltaPosition[static_cast<std::size_t>(slot)];
    moved.x += distance * normal.x;
    moved.y += distance * normal.y;
}

template <class Block>
void part(Workspace& work, const Block& block, int lane, float depth) {
    const Vec2 normal = block.normal.at(lane);
    if constexpr (decltype(block.a)::kFixed) {
        moveAlong(work, block.b.slot[lane], depth, normal);
    } else {
        const float a = work.velocity[static_cast<std::size_t>(block.a.slot[lane])].w;
        const float b = work.velocity[static_cast<std::size_t>(block.b.slot[lane])].w;
        moveAlong(work, block.a.slot[lane], -depth * a / (a + b), normal);
        moveAlong(work, block.b.slot[lane], depth * b / (a + b), normal);
    }
}

/// Removes the overlaps of this step at once; removed gradually, they would accelerate the balls.
/// @return true if there were any
bool partInTurn(Workspace& work, float dt) {
    bool overlapped = false;
    visitAll(work, [&](const auto& block, const BounceBlock&, int lane) {
        // Overlap from before the step is left to the solver; removed at once, it would add height.
        const float start = std::max(block.points[0].separation[lane], 0.0f);
        const float depth = -(start + approachIn(work, block, 0, lane, dt).displacement);
        if (depth <= kTouchDistance) return;
        overlapped = true;
        part(work, block, lane, depth);
    });
    return overlapped;
}

/// Negates the impulses of impacts, so that warm starting does not use them.
void markBlows(Workspace& work) {
    visitAll(work, [&](auto& block, const BounceBlock&, int lane) {
        block.points[0].impulse[lane] = -block.points[0].impulse[lane];
    });
}

}  // namespace

void runImpactsOn(StepContext& step, const SolveGroup& group) {
    Workspace& work = step.work;
    work.impacts.clear();
    for (const ColourBlocks& colour : group.colours) {
        gather(work.two, colour.contacts.two, work.impacts);
        gather(work.fixed, colour.contacts.fixed, work.impacts);
    }
    if (work.impacts.size() < 2) return;
    keepChains(work);
    const float slowest = step.world.settings.bounceSpeed;
    if (!anyHits(work, slowest)) return;
    takeBack(work);
    endAtImpact(work, slowest, step.dt);
    for (int i = 0; i < kMaxRounds && collideInTurn(work, slowest); ++i) continue;
    for (int i = 0; i < kMaxRounds && partInTurn(work, step.dt); ++i) continue;
    markBlows(work);
}

}  // namespace plumb::physics
