#pragma once

#include <memory>

#include "core/task_pool.hpp"

namespace plumb {

namespace physics {
struct World;
}

/// Thread pool for the physics of a game. It is started
/// when a world is first large enough to benefit from it.
class PhysicsThreads {
public:
    /// @param threads  number of threads, including the caller's; 0: as many as the machine has, but at most
    ///                 eight, as more hardly speed up typical scenes
    explicit PhysicsThreads(int threads = 0);

    /// Returns the pool for stepping this world; null if a single thread is faster.
    [[nodiscard]] TaskPool* of(const physics::World& world);

    [[nodiscard]] int threads() const { return threads_; }
    void setThreads(int threads);

private:
    int threads_ = 1;
    std::unique_ptr<TaskPool> pool_;
};

}  // namespace plumb
