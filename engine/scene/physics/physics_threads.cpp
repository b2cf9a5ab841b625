#include "scene/physics/physics_threads.hpp"

#include <algorithm>
#include <thread>

#include "physics/simulation.hpp"

namespace plumb {

namespace {

constexpr int kMaxThreads = 8;

int usefulThreads() {
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMaxThreads);
}

}  // namespace

PhysicsThreads::PhysicsThreads(int threads) { setThreads(threads); }

void PhysicsThreads::setThreads(int threads) {
    threads_ = threads > 0 ? threads : usefulThreads();
    pool_.reset();
}

TaskPool* PhysicsThreads::of(const physics::World& world) {
    if (threads_ < 2 || !physics::isWorthThreads(world)) return nullptr;
    if (pool_ == nullptr) pool_ = std::make_unique<TaskPool>(threads_);
    return pool_.get();
}

}  // namespace plumb
