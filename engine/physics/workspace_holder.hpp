#pragma once

#include <memory>
#include <utility>

namespace plumb::physics {

struct Workspace;

/// Keeps a world's Workspace. It follows from the world, so a copy of the world leaves it behind and makes
/// its own, and a world that is written over keeps its memory but has to fill it anew.
class WorkspaceHolder {
public:
    WorkspaceHolder();
    ~WorkspaceHolder();
    WorkspaceHolder(const WorkspaceHolder& other);
    WorkspaceHolder& operator=(const WorkspaceHolder& other);
    WorkspaceHolder(WorkspaceHolder&& other) noexcept;
    WorkspaceHolder& operator=(WorkspaceHolder&& other) noexcept;

    /// Made when first asked for.
    Workspace& get();
    /// What the last step left; null when there was none since the world was made, copied or written over.
    [[nodiscard]] const Workspace* lastStep() const { return stale_ ? nullptr : workspace_.get(); }
    /// True once after the world was written over, or when nothing was there yet.
    bool takeStale() { return std::exchange(stale_, false); }
    [[nodiscard]] bool stale() const { return stale_; }

private:
    std::unique_ptr<Workspace> workspace_;
    bool stale_ = true;
};

}  // namespace plumb::physics
