#include <array>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "core/option_rows.hpp"
#include "core/text.hpp"
#include "editor/templates/new_project.hpp"
#include "editor/templates/project_templates.hpp"

namespace plumb::editor {
namespace {

struct NewOptions {
    std::string folder;
    std::string from = "empty";  ///< id of a template
    bool help = false;
};

constexpr std::array kOptions{
    OptionRow<NewOptions>{"--template", "NAME",
                          "template of the project: empty, cpp, lua, topdown, physics, kit or platformer",
                          [](NewOptions& o, std::string_view v) {
                              o.from = v;
                              return findTemplate(v) != nullptr;
                          }},
    OptionRow<NewOptions>{"--help", "", "show this help",
                          [](NewOptions& o, std::string_view) { return o.help = true; }},
};

Result<NewOptions> parse(std::span<const char* const> words) {
    NewOptions options;
    const Result<Done> read =
        readOptions<NewOptions>(kOptions, words, options, [&](std::string_view word) -> Result<Done> {
            if (!options.folder.empty())
                return Error{"command line", format("\"{}\" is a second project", word), "name one project"};
            options.folder = word;
            return Done{};
        });
    if (!read) return read.error();
    if (options.folder.empty() && !options.help)
        return Error{"command line", "no project is named", "name the folder of the new project"};
    return options;
}

}  // namespace
}  // namespace plumb::editor

/// plumb-new: creates a project as `plumb-editor --new` does, but needs little of the engine, so that it is
/// built soon.
int main(int count, char** arguments) {
    using namespace plumb::editor;
    const std::vector<const char*> words(arguments + 1, arguments + count);
    const auto options = parse(words);
    if (!options) {
        std::fprintf(stderr, "plumb-new: %s\n", options.error().text().c_str());
        return 2;
    }
    if (options->help) {
        std::printf("usage: plumb-new FOLDER [options]\n\n%s",
                    plumb::optionLines(plumb::helpOf<NewOptions>(kOptions)).c_str());
        return 0;
    }
    return newProject(options->from, options->folder);
}
