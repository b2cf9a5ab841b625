#pragma once

namespace plumb::editor {

class Workspace;

/// Whether an instance of those that are selected has anything for itself. Found out once for each change of
/// the scene or the selection; of very many it is taken for granted.
bool instancesDiffer(const Workspace& workspace);

}  // namespace plumb::editor
