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

namespace plumb {

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
    ImportStage(Path root, std::string folder) : root_{std::move(root)}, folder_{std::move(folder)} {}

    /// Takes a file under a name like `wished`; characters that trouble other systems are replaced.
    /// @return its path in the project
    std::string add(std::string_view wished, std::string_view ending, std::string bytes);

    /// Copies a picture, once however often it is asked for.
    /// @param keyed  pixels of this color become transparent
    const StagedImage& image(const Path& from, std::optional<Color> keyed);

    /// The pixels of a picture in the stage; empty when it cannot be read.
    [[nodiscard]] Image pixels(std::string_view path) const;

    /// Writes everything. @return the paths in the order they were added
    [[nodiscard]] Result<std::vector<std::string>> write() const;

    [[nodiscard]] std::size_t imageCount() const { return images_.size(); }

    std::vector<Error> problems;

private:
    struct File {
        std::string path;
        std::string bytes;
    };
    std::string uniquePath(std::string_view wished, std::string_view ending);

    Path root_;
    std::string folder_;
    std::vector<File> files_;
    std::set<std::string> taken_;
    std::map<std::string, StagedImage> images_;  ///< by the original's path and color
};

}  // namespace plumb
