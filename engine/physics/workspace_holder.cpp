#include "physics/workspace_holder.hpp"

#include "physics/workspace.hpp"

namespace plumb::physics {

WorkspaceHolder::WorkspaceHolder() = default;
WorkspaceHolder::~WorkspaceHolder() = default;
WorkspaceHolder::WorkspaceHolder(const WorkspaceHolder&) {}
WorkspaceHolder& WorkspaceHolder::operator=(const WorkspaceHolder&) { return state_ = State::Stale, *this; }
WorkspaceHolder::WorkspaceHolder(WorkspaceHolder&& other) noexcept
    : workspace_{std::move(other.workspace_)}, state_{std::exchange(other.state_, State::Stale)} {}
WorkspaceHolder& WorkspaceHolder::operator=(WorkspaceHolder&& other) noexcept {
    workspace_ = std::move(other.workspace_);
    state_ = std::exchange(other.state_, State::Stale);
    return *this;
}

Workspace& WorkspaceHolder::get() {
    if (workspace_ == nullptr) workspace_ = std::make_unique<Workspace>();
    return *workspace_;
}

}  // namespace plumb::physics
