#pragma once

#include <string_view>

#include "editor/model/document/document.hpp"
#include "scene/files/scene_file.hpp"

namespace plumb::editor {

/// Puts a text in the place of the document's scene. Entities keep their lasting ids, so that selection and
/// undo go on; views of the world do not stay valid.
/// @error  the text is no scene; the document is as before
Result<LoadReport> reloadDocument(Document& document, const SceneContext& context, std::string_view text);

}  // namespace plumb::editor
