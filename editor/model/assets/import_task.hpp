#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "import/import_file.hpp"

namespace plumb::editor {

/// A row of the list from which a file to import is chosen.
struct ImportRow {
    std::string name;
    bool folder = false;
};

/// Looks for a file of another editor on this machine and brings it into the project.
class ImportTask {
public:
    explicit ImportTask(Path project) : project_{std::move(project)}, folder_{project_.parent_path()} {}

    /// Goes to a folder, or to the folder of a file and chooses it. @return false when there is no such thing
    bool goTo(const Path& path);
    void goUp() { goTo(folder_.parent_path()); }
    /// Opens a folder of the list, or chooses a file.
    void choose(const ImportRow& row) { goTo(folder_ / row.name); }

    [[nodiscard]] const Path& folder() const { return folder_; }
    /// Folders first, then what may be imported; hidden ones are left out.
    [[nodiscard]] const std::vector<ImportRow>& rows() const { return rows_; }
    [[nodiscard]] const Path& file() const { return file_; }  ///< empty: none is chosen
    /// "Tiled map"; empty when the chosen file is nothing that can be imported.
    [[nodiscard]] std::string_view kind() const;
    /// Where it goes, as a path in the project; may be changed.
    std::string target;
    /// Whether something of that name is there and would be replaced.
    [[nodiscard]] bool replaces() const;

    /// Imports the chosen file. @return whether it worked; `report` or `problem` says more
    bool run();
    [[nodiscard]] const std::optional<ImportReport>& report() const { return report_; }
    [[nodiscard]] const std::string& problem() const { return problem_; }
    /// Back to choosing.
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

/// Takes a file that was dropped onto the window: what other editors made is offered for import, pictures,
/// sounds and fonts are copied into assets/ as one step of undo.
void bringIn(Workspace& workspace, const std::string& file);

}  // namespace plumb::editor
