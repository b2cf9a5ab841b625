#pragma once

#include <string>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "editor/model/project/project_session.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::editor {

/// A copy of one of the repository's projects in a temporary folder, opened in an editor without a window.
/// Tests may change its files.
class ProjectCopy {
public:
    explicit ProjectCopy(const std::string& name = "platformer", std::string_view scene = "level1") {
        std::filesystem::copy(test::sourceFolder() / "projects" / name, folder_.path,
                              std::filesystem::copy_options::recursive);
        reopen(scene);
    }
    /// Opens the project in a new session, like after a restart of the program.
    void reopen(std::string_view scene = "level1") {
        session_.reset();
        Result<std::unique_ptr<ProjectSession>> session = ProjectSession::open(folder_.path.string());
        EXPECT_TRUE(session.ok());
        session_ = std::move(*session);
        session_->openFirst(scene);
    }
    [[nodiscard]] Workspace& workspace() { return session_->workspace(); }
    [[nodiscard]] const Path& root() const { return folder_.path; }
    [[nodiscard]] std::string fileText() { return *readFile(folder_.path / workspace().document.scenePath); }

private:
    test::TemporaryFolder folder_;
    std::unique_ptr<ProjectSession> session_;
};

/// Returns the number in an environment variable, or `otherwise` if it is not set. Used to lengthen tests.
inline int fromEnvironment(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::atoi(text);
}

}  // namespace plumb::editor
