#include "editor/templates/new_project.hpp"

#include <cstdio>
#include <string>

#include "editor/templates/project_templates.hpp"

namespace plumb::editor {

int newProject(std::string_view from, const Path& folder) {
    std::error_code failed;
    const Path whole = std::filesystem::absolute(folder, failed).lexically_normal();
    const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
    const Result<Path> made = createProject(*findTemplate(from), name, whole);
    if (!made) {
        std::fprintf(stderr, "plumb: %s\n", made.error().text().c_str());
        return 1;
    }
    std::printf("Created %s\n", made->string().c_str());
    return 0;
}

}  // namespace plumb::editor
