#pragma once

#include <string_view>

#include "editor/model/document/document.hpp"
#include "scene/files/scene_file.hpp"

namespace plumb::editor {

/// Replaces the document's scene by the one in a text. Entities keep their ObjectIds, so selection and undo
/// history stay valid; EntityIds and pointers into the world do not.
/// @error  the text is not a valid scene; the document is unchanged
Result<LoadReport> reloadDocument(Document& document, const SceneContext& context, std::string_view text);

}  // namespace plumb::editor
