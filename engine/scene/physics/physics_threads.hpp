#pragma once

#include <memory>

#include "core/task_pool.hpp"

namespace plumb {

namespace physics {
struct World;
}

/// Threads for the physics of a game. They are started when its world first has work for them: a small scene
/// has none.
class PhysicsThreads {
public:
    /// @param threads  at most so many, with the caller's; 0: as many as the machine has, but at most eight,
    /// as more
    ///                 hardly help a scene that one screen can show
    explicit PhysicsThreads(int threads = 0);

    /// @return null while a step of this world is done sooner by one thread
    [[nodiscard]] TaskPool* of(const physics::World& world);

    [[nodiscard]] int threads() const { return threads_; }
    void setThreads(int threads);

private:
    int threads_ = 1;
    std::unique_ptr<TaskPool> pool_;
};

}  // namespace plumb
