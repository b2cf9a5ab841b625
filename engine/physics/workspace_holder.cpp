#include "physics/workspace_holder.hpp"

#include "physics/workspace.hpp"

namespace plumb::physics {

void WorkspaceHolder::Delete::operator()(Workspace* workspace) const { delete workspace; }

Workspace& WorkspaceHolder::get() {
    if (workspace_ == nullptr) workspace_.reset(new Workspace);
    return *workspace_;
}

}  // namespace plumb::physics
