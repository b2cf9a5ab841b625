#pragma once

#include <string>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "editor/model/project/project_session.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::editor {

/// One of our projects, copied, so that a test may do anything to its files, and open in an editor without a
/// window.
class ProjectCopy {
public:
    explicit ProjectCopy(const std::string& name = "platformer", std::string_view scene = "level1") {
        std::filesystem::copy(test::sourceFolder() / "projects" / name, folder_.path,
                              std::filesystem::copy_options::recursive);
        reopen(scene);
    }
    /// As after the program was started again.
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

/// A number from the environment, for the long run of a test.
inline int fromEnvironment(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::atoi(text);
}

}  // namespace plumb::editor
