#include "editor/model/debug/script_view.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "ecs/world.hpp"
#include "editor/model/debug/line_match.hpp"
#include "editor/model/field_text.hpp"
#include "editor/model/project/project_habits.hpp"
#include "editor/model/workspace.hpp"
#include "reflect/type_registry.hpp"
#include "script/script_set.hpp"

namespace plumb::editor {
namespace {

constexpr double kPause = 0.5;               // s between two looks at the files
constexpr const char* kStopped = "stopped";  // the field of each script that errors set

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    for (std::string_view line : split(text, '\n')) {
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        lines.emplace_back(line);
    }
    if (lines.size() > 1 && lines.back().empty()) lines.pop_back();
    return lines;
}

}  // namespace

ScriptView::ScriptView(Workspace& workspace) : workspace_{workspace} {}

void ScriptView::update(double seconds) {
    waited_ += seconds;
    if (!stamp_ || waited_ >= kPause) readFiles();
    followHalt();
    const Breakpoints& breakpoints = workspace_.debugger.breakpoints;
    if (std::exchange(breakpoints_, breakpoints.revision()) != breakpoints.revision())
        keepBreakpoints(workspace_);
}

void ScriptView::breakpointsKept() { breakpoints_ = workspace_.debugger.breakpoints.revision(); }

void ScriptView::readFiles() {
    waited_ = 0.0;
    if (workspace_.project.isNone) return;
    const std::uint64_t stamp = stampOfScripts(workspace_.project.root);
    if (stamp_ == stamp) return;
    stamp_ = stamp;
    const std::vector<ScriptText> before = std::exchange(files_, {});
    std::vector<Error> problems;  // reported by the code that loads the scripts
    for (const auto& [name, text] : readScriptFiles(workspace_.project.root, problems))
        files_.push_back({format("scripts/{}.lua", name), linesOf(text)});
    for (const ScriptText& old : before) {
        const ScriptText* now = find(old.file);
        if (now != nullptr && now->lines != old.lines)
            workspace_.debugger.breakpoints.follow(old.file, linesAfterEdit(old.lines, now->lines));
    }
}

const ScriptText* ScriptView::find(std::string_view file) const {
    const auto found = std::find_if(files_.begin(), files_.end(),
                                    [file](const ScriptText& text) { return text.file == file; });
    return found == files_.end() ? nullptr : &*found;
}

void ScriptView::followHalt() {
    const Halt* halt = workspace_.debugger.halt();
    if (std::exchange(halts_, workspace_.debugger.halts()) == workspace_.debugger.halts()) return;
    if (halt == nullptr) return;
    frame = 0;
    show({halt->file, halt->line});
    const std::string& notice = workspace_.debugger.notice();
    workspace_.notice = format("{} {}", notice.empty() ? "Stopped at" : notice + ":", haltInWords());
    if (!halt->problem.empty())
        workspace_.notice = format("The condition of this breakpoint has an error: {}", halt->problem);
}

const ScriptText* ScriptView::shown() const {
    if (const ScriptText* chosen = find(chosen_)) return chosen;
    return files_.empty() ? nullptr : &files_.front();
}

void ScriptView::show(const ScriptPlace& place) {
    chosen_ = place.file;
    scrollTo_ = place.line;
    workspace_.panelToShow = "Scripts";
}

std::string ScriptView::haltInWords() const {
    const Halt* halt = workspace_.debugger.halt();
    if (halt == nullptr) return {};
    return format("{}:{}, tick {}", halt->file, halt->line, halt->moment.tick);
}

std::vector<ScriptView::Property> ScriptView::properties() const {
    std::vector<Property> properties;
    const Halt* halt = workspace_.debugger.halt();
    const ComponentType* known = halt == nullptr ? nullptr : findComponentType(halt->script);
    if (known == nullptr) return properties;
    const World& world = workspace_.play.world();
    const TypeInfo* type = world.types()->find(known->info.name);
    const void* component = type == nullptr ? nullptr : world.find(*type, halt->entity);
    if (component == nullptr) return properties;
    for (const FieldInfo& field : type->fields) {
        if (field.name == kStopped) continue;
        const FieldValue value = readField(workspace_.play, field, component);
        properties.push_back({std::string{field.name},
                              valueText(workspace_, *type, field, value),
                              {halt->entity, type, &field}});
    }
    return properties;
}

}  // namespace plumb::editor
