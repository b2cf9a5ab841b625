#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "math/color.hpp"
#include "math/rect.hpp"
#include "platform/image.hpp"
#include "scene/files/import_commit.hpp"

namespace plumb {

/// Tiles of another size than their layer's cells have a line each in the file of their tileset. No more of
/// them are written, so that a small file that claims millions makes no large one.
inline constexpr int kMaxLooseTiles = 1 << 15;

/// A name for a file: characters that trouble other systems are replaced.
std::string plainName(std::string_view wished);

/// A copied picture. When the original is missing the path stands all the same, so that it can be put there.
struct StagedImage {
    std::string path;  ///< in the project
    int width = 0;     ///< px; 0 when it is not known
    int height = 0;
};

/// The files that an import will write, collected before the first is written.
class ImportStage {
public:
    /// @param folder  in the project, for everything but the scene: "assets/cave"
    explicit ImportStage(std::string folder) : folder_{std::move(folder)} {}

    /// Takes a file under a name like `wished`.
    /// @return its path in the project
    std::string add(std::string_view wished, std::string_view ending, std::string bytes);

    /// Copies a picture, once however often it is asked for.
    /// @param keyed  pixels of this color become transparent
    const StagedImage& image(const Path& from, std::optional<Color> keyed);

    /// The pixels of a picture in the stage; empty when it cannot be read. The last one asked for is kept.
    const Image& pixels(std::string_view path);

    /// Gives away the files, in the order they were added.
    [[nodiscard]] std::vector<ImportedFile> takeFiles() { return std::move(files_); }

    [[nodiscard]] std::size_t imageCount() const { return images_.size(); }

    std::vector<Error> problems;

private:
    std::string uniquePath(std::string_view wished, std::string_view ending);

    std::string folder_;
    std::vector<ImportedFile> files_;
    std::set<std::string> taken_;
    std::map<std::string, StagedImage> images_;  ///< by the original's path and color
    std::string decodedPath_;
    Image decoded_;
};

}  // namespace plumb
