#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "reflect/type_info.hpp"

namespace plumb {

class World;

/// The script files of a project, `scripts/NAME.lua`, and the component types that they declare. A service of
/// worlds.
class ScriptSet {
public:
    struct File {
        std::string name;  ///< "enemies/slime" of the file scripts/enemies/slime.lua
        std::string path;  ///< in the project
        std::string text;  ///< prepared for loading (prepareScript)
        std::uint64_t textHash = 0;
        std::optional<TypeInfo> type;  ///< component that the file declares; files without are for require()
        std::vector<Error> warnings;   ///< of functions that seem to be handlers but are called otherwise
        std::vector<std::string> texts;  ///< texts and paths in default values of properties
    };

    /// Reads the files again. A file with an error keeps its former version.
    /// @param folder    of the project
    /// @param problems  receives the errors
    void read(const Path& folder, std::vector<Error>& problems);
    /// As read(), for texts: pairs of a name and the text of its file.
    void readTexts(const std::vector<std::pair<std::string, std::string>>& texts,
                   std::vector<Error>& problems);

    /// In the order of their names.
    [[nodiscard]] const std::vector<File>& files() const { return files_; }
    [[nodiscard]] const File* find(std::string_view name) const;
    [[nodiscard]] bool empty() const { return files_.empty(); }

    /// Increases when files or component types were changed: worlds load them again then.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    void typesChanged();
    /// stampOfScripts() before the files were read: another one now means that they have changed since.
    [[nodiscard]] std::uint64_t stamp() const { return stamp_; }

    /// Adds the texts of default values to the world.
    void addTexts(World& world) const;

private:
    std::vector<File> files_;
    std::uint64_t version_ = 0;
    std::uint64_t stamp_ = 0;
};

/// Returns the names and texts of the script files of a project.
std::vector<std::pair<std::string, std::string>> readScriptFiles(const Path& folder,
                                                                 std::vector<Error>& problems);

/// Returns a number that changes when a script file is changed, added or removed.
std::uint64_t stampOfScripts(const Path& folder);

}  // namespace plumb
