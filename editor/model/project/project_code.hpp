#pragma once

#include <cstdint>
#include <future>
#include <string>
#include <vector>

#include "app/module.hpp"
#include "core/file.hpp"
#include "core/result.hpp"
#include "editor/model/project/program.hpp"

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
    /// True if a built library exists that `load` can load.
    [[nodiscard]] bool isBuilt() const;
    /// Loads the library as it was built last.
    /// @error there is none, it was built for another version of the editor, or it does not describe a module
    Result<Module> load();

    /// Checks the code files every kInterval and starts a build if they have changed; the first call always
    /// starts a build.
    /// @param now  s, of any clock
    /// @return true if a build has just finished whose library differs from the loaded one
    bool poll(double now);
    /// Builds the library and the player, and waits. Errors are logged. @return false if the build failed
    bool buildNow();
    /// True if the code can be built, so that poll() starts a build.
    [[nodiscard]] bool canBuild() const { return !target_.empty(); }
    /// True if the last build that has ended was successful.
    [[nodiscard]] bool succeeded() const { return succeeded_; }
    [[nodiscard]] bool isBuilding() const { return build_.valid(); }
    static constexpr double kInterval = 0.05;  ///< s

private:
    void start(bool withPlayer);
    bool finish();
    [[nodiscard]] std::uint64_t stampOfFiles() const;
    [[nodiscard]] Path library() const;

    Path project_;
    Path buildFolder_;    // empty: this editor cannot build
    std::string target_;  // name of the targets in the build: TARGET-code, TARGET-player
    bool exists_ = false;
    bool succeeded_ = false;
    double next_ = 0.0;
    std::uint64_t stamp_ = 0;         // hash of names and times of the code files when the last build began
    std::uint64_t libraryStamp_ = 0;  // stamp of the library's file when it was loaded
    std::future<ProgramEnd> build_;
};

/// Returns NAME of the CMake targets NAME-code and NAME-player of a project with code, as the file
/// engine/cmake/code_target.cmake says. A project outside the engine's folder is first added to the list
/// projects.txt of the build folder, which creates its targets.
/// @error cmake is not installed, or the project has no .cpp file
Result<std::string> codeTarget(const Path& project, const Path& buildFolder);

/// Returns the program that plays a project: the player with the project's code; without code, plumb-player.
Path playerOf(const Path& project);

}  // namespace plumb::editor
