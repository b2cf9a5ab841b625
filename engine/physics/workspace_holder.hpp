#pragma once

#include <memory>
#include <utility>

namespace plumb::physics {

struct Workspace;

/// Owns the Workspace of a world. Its contents follow from the world, so a copy of the world does not copy
/// them, and a world that is overwritten keeps the memory but refills it.
class WorkspaceHolder {
public:
    WorkspaceHolder();
    ~WorkspaceHolder();
    WorkspaceHolder(const WorkspaceHolder& other);
    WorkspaceHolder& operator=(const WorkspaceHolder& other);
    WorkspaceHolder(WorkspaceHolder&& other) noexcept;
    WorkspaceHolder& operator=(WorkspaceHolder&& other) noexcept;

    /// Created on first use.
    Workspace& get();
    /// Workspace of the last step; null if there was none since the world was created, copied or overwritten.
    [[nodiscard]] const Workspace* lastStep() const { return stale_ ? nullptr : workspace_.get(); }
    /// True once after the world was created or overwritten.
    bool takeStale() { return std::exchange(stale_, false); }
    [[nodiscard]] bool stale() const { return stale_; }

private:
    std::unique_ptr<Workspace> workspace_;
    bool stale_ = true;
};

}  // namespace plumb::physics
