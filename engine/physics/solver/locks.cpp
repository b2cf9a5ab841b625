#include "physics/solver/locks.hpp"

namespace plumb::physics {

namespace {

void lock(Float4& row, std::uint8_t flags) {
    if ((flags & kLockX) != 0) row.x = 0.0f;
    if ((flags & kLockY) != 0) row.y = 0.0f;
}

}  // namespace

void prepareLocks(StepContext& step) {
    if (!step.starts(Effect::Locks)) return;
    Workspace& work = step.work;
    work.locks.clear();
    for (std::size_t slot = 0; slot < work.bodyOf.size(); ++slot) {
        const std::uint32_t body = work.bodyOf[slot];
        if (body == kNone || step.world.bodies.info[body].kind != BodyKind::Dynamic) continue;
        const auto flags = static_cast<std::uint8_t>(step.world.bodies.info[body].flags & (kLockX | kLockY));
        if (flags == 0) continue;
        work.locks.push_back({static_cast<std::uint32_t>(slot), flags});
        lock(work.velocity[slot], flags);
        lock(work.drive[slot], flags);
        lock(work.ballisticDrift[slot], flags);
    }
}

void lockAxes(const StepContext& step, const SolveGroup& group, std::vector<Float4>& velocity) {
    if (!step.runs(Effect::Locks)) return;
    for (const AxisLock& held : step.work.locks) {
        const auto slot = static_cast<std::int32_t>(held.slot);
        if (slot >= group.begin && slot < group.end) lock(velocity[held.slot], held.flags);
    }
}

}  // namespace plumb::physics
