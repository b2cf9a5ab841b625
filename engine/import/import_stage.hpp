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

/// Maximum number of tiles per tileset if tiles and cells of the layer differ in size. Then each tile has an
/// entry in the tileset file, so without a limit a small file that declares millions would become a huge one.
inline constexpr int kMaxLooseTiles = 1 << 15;

/// Returns a file name that is valid on all systems: other characters are replaced by '_'.
std::string plainName(std::string_view wished);

/// A copied image. If the original is missing, the path is assigned nevertheless, so that the user can add
/// the file later.
struct StagedImage {
    std::string path;  ///< in the project
    int width = 0;     ///< px; 0 if the image cannot be read
    int height = 0;
};

/// The files that an import will write, collected before the first one is written.
class ImportStage {
public:
    /// @param folder  path in the project for all files except the scene: "assets/cave"
    explicit ImportStage(std::string folder) : folder_{std::move(folder)} {}

    /// Adds a file under the name `wished`, with a number appended if that name is in use.
    /// @return its path in the project
    std::string add(std::string_view wished, std::string_view ending, std::string bytes);

    /// Adds a copy of an image at the first call for it; later calls return the same copy.
    /// @param keyed  color key: pixels of this color become transparent; no value: none
    const StagedImage& image(const Path& from, std::optional<Color> keyed);

    /// Adds an image that the import made; later calls of `image` for `name` without a color key return it.
    /// @error  the image is empty or too large
    Result<Done> addImage(const Path& name, std::string_view wished, const Image& image);

    /// Returns the pixels of an added image; empty if it cannot be decoded. Caches the last image.
    const Image& pixels(std::string_view path);

    /// Moves the files out, in the order they were added.
    [[nodiscard]] std::vector<ImportedFile> takeFiles() { return std::move(files_); }

    [[nodiscard]] std::size_t imageCount() const { return images_.size(); }

    std::vector<Error> problems;

private:
    std::string uniquePath(std::string_view wished, std::string_view ending);

    std::string folder_;
    std::vector<ImportedFile> files_;
    std::set<std::string> taken_;
    std::map<std::string, StagedImage> images_;  ///< key: the original's path and color key
    std::string decodedPath_;
    Image decoded_;
};

}  // namespace plumb
