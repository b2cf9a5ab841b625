#pragma once

#include <memory>

namespace plumb::physics {

struct Workspace;

/// Owns the Workspace of a world. Its contents follow from the world, so a copy of the world does not copy
/// them, and a world that is overwritten keeps the memory but refills it.
class WorkspaceHolder {
public:
    WorkspaceHolder() = default;
    WorkspaceHolder(const WorkspaceHolder&) {}
    WorkspaceHolder& operator=(const WorkspaceHolder&) { return state_ = State::Stale, *this; }
    WorkspaceHolder(WorkspaceHolder&&) noexcept = default;
    WorkspaceHolder& operator=(WorkspaceHolder&&) noexcept = default;

    /// Created on first use.
    Workspace& get();
    /// Workspace of the last step; null if there was none since the world was created, copied or overwritten.
    [[nodiscard]] const Workspace* lastStep() const {
        return state_ == State::Stepped ? workspace_.get() : nullptr;
    }
    /// To be called at the end of a step.
    void noteStep() {
        if (!stale()) state_ = State::Stepped;
    }
    /// True once after the world was created or overwritten.
    bool takeStale() { return stale() && (state_ = State::Refilled, true); }
    [[nodiscard]] bool stale() const { return workspace_ == nullptr || state_ == State::Stale; }
    /// A callback of StepOptions::hooks runs: setters refuse to work. Not so in a copy that it makes.
    bool isAsking = false;

private:
    /// A query refills what it needs, such as the broad phase, and leaves the rest as it was.
    enum class State : unsigned char { Stale, Refilled, Stepped };

    struct Delete {
        void operator()(Workspace* workspace) const;
    };

    std::unique_ptr<Workspace, Delete> workspace_;
    State state_ = State::Stale;
};

}  // namespace plumb::physics
