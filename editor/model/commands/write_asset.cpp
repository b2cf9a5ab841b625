#include "editor/model/commands/write_asset.hpp"

#include <utility>

#include "core/log.hpp"

namespace plumb::editor {

void WriteAsset::swap() {
    const Path file = root_ / path_;
    std::error_code failed;
    const bool was = std::filesystem::exists(file, failed);
    Result<std::string> before = was ? readFile(file) : Result<std::string>{std::string{}};
    if (!before) return logError("Editor", before.error());
    if (there_) {
        if (const Result<Done> written = writeFile(file, text_); !written)
            return logError("Editor", written.error());
    } else {
        std::filesystem::remove(file, failed);
    }
    text_ = *std::move(before);
    there_ = was;
    static_cast<void>(assets_.pollChanges(assets_.size()));
}

}  // namespace plumb::editor
