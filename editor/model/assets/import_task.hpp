#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "import/import_file.hpp"

namespace plumb::editor {

/// A row of the file list of the import dialog.
struct ImportRow {
    std::string name;
    bool folder = false;
};

/// Import dialog: browses the file system for files of other editors and imports one into the project.
class ImportTask {
public:
    explicit ImportTask(Path project) : project_{std::move(project)}, folder_{project_.parent_path()} {}

    /// Opens a folder, or selects a file and opens its folder. @return false if the path does not exist
    bool goTo(const Path& path);
    void goUp() { goTo(folder_.parent_path()); }
    /// Opens a folder of the list, or selects a file.
    void choose(const ImportRow& row) { goTo(folder_ / row.name); }

    [[nodiscard]] const Path& folder() const { return folder_; }
    /// Content of the open folder: subfolders first, then files that can be imported; without hidden ones.
    [[nodiscard]] const std::vector<ImportRow>& rows() const { return rows_; }
    [[nodiscard]] const Path& file() const { return file_; }  ///< selected file; empty: none
    /// Format of the selected file: "Tiled map"; empty if it cannot be imported.
    [[nodiscard]] std::string_view kind() const;
    /// Path in the project to which the file is imported; the user may change it.
    std::string target;
    /// True if `target` exists and would be replaced.
    [[nodiscard]] bool replaces() const;

    /// Imports the selected file. @return true on success; then `report` is set, else `problem`
    bool run();
    [[nodiscard]] const std::optional<ImportReport>& report() const { return report_; }
    [[nodiscard]] const std::string& problem() const { return problem_; }
    /// Returns to the file list.
    void again();

private:
    void list();

    Path project_;
    Path folder_;
    Path file_;
    ImportKind kind_ = ImportKind::None;
    std::vector<ImportRow> rows_;
    std::optional<ImportReport> report_;
    std::string problem_;
};

class Workspace;

/// Handles a file that was dropped onto the window: opens the import dialog for files of other editors;
/// copies assets (images, sounds, fonts, …) into assets/ as one undo step.
void addDroppedFile(Workspace& workspace, const std::string& file);

}  // namespace plumb::editor
