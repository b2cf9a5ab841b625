#pragma once

#include <cstdint>
#include <future>
#include <string>
#include <vector>

#include "app/module.hpp"
#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb::editor {

/// The C++ code of a project, its folder `code`: builds it in the background, loads it, and builds it again
/// after its files have changed. Errors of the compiler are logged with file and line.
class ProjectCode {
public:
    explicit ProjectCode(Path project);
    ~ProjectCode();
    ProjectCode(const ProjectCode&) = delete;
    ProjectCode& operator=(const ProjectCode&) = delete;

    /// True if the project has code.
    [[nodiscard]] bool exists() const { return exists_; }
    /// True if there is a library to load.
    [[nodiscard]] bool isBuilt() const;
    /// Loads the library as it was built last.
    /// @error there is none, it was built for another version of the editor, or it does not describe a module
    Result<Module> load();

    /// Looks at the files of the code every kInterval and starts a build if they have changed; the first call
    /// starts one.
    /// @param now  s, of any clock
    /// @return true if a build has just made another library than the one that was loaded
    bool poll(double now);
    /// Builds the library and the player, and waits. Errors are logged. @return false if the build failed
    bool buildNow();
    [[nodiscard]] bool isBuilding() const { return build_.valid(); }
    static constexpr double kInterval = 0.05;  ///< s

private:
    struct Build {
        bool succeeded = false;
        std::string output;
    };

    void start(bool withPlayer);
    bool finish();
    [[nodiscard]] std::uint64_t stampOfFiles() const;
    [[nodiscard]] Path library() const;

    Path project_;
    Path buildFolder_;    // empty: this editor cannot build
    std::string target_;  // name of the targets in the build: TARGET-code, TARGET-player
    bool exists_ = false;
    double next_ = 0.0;
    std::uint64_t stamp_ = 0;         // of the files when the last build began
    std::uint64_t libraryStamp_ = 0;  // of the library when it was loaded
    int loaded_ = 0;                  // number of versions that were loaded
    std::future<Build> build_;
};

/// Name of the targets that contain the code of a project. A project outside of the engine's folder is
/// entered into the list of the build folder.
Result<std::string> codeTarget(const Path& project, const Path& buildFolder);

/// The program that plays a project, if it has code: the player that contains it.
Path playerOf(const Path& project);

}  // namespace plumb::editor
