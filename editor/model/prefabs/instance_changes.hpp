#pragma once

namespace plumb::editor {

class Workspace;

/// True if a selected prefab instance differs from its prefab. The result is cached until the scene or the
/// selection changes. With too many selected entities to compare it is true.
bool instancesDiffer(const Workspace& workspace);

}  // namespace plumb::editor
