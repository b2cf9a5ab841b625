#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/workspace.hpp"
#include "input/action_map.hpp"
#include "platform/events.hpp"
#include "reflect/json.hpp"

namespace plumb::editor {

/// Editor of a project's input actions and axes with their keys, buttons and sticks: the "input" object of
/// project.json. Every change is one undo step and is written to the file at once; the rest of the file stays
/// unchanged. A running game uses the change from its next tick that is not a replay.
class InputMapEdit {
public:
    enum class Kind : unsigned char { Action, Axis };
    /// A list of bindings: all of an action, or those of one part of an axis.
    struct Part {
        std::string key;  ///< "negative", "positive", "analog"; empty for an action
        std::vector<Binding> bindings;
    };
    struct Row {
        Kind kind = Kind::Action;
        std::string name;
        bool ofProject = false;  ///< listed in project.json; false: an engine default
        std::vector<Part> parts;
    };
    /// Identifies one list of bindings of an action or axis.
    struct Place {
        Kind kind = Kind::Action;
        std::string name;
        std::string part;  ///< Part::key of the list
    };

    explicit InputMapEdit(Workspace& workspace) : workspace_{workspace} {}

    /// Reads the file again if it changed. @return an error message; empty if the file is valid
    const std::string& refresh();
    /// Actions first, then axes.
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    /// Returns the names of all lists except `but` that contain a binding: "Jump", "Vertical, negative".
    [[nodiscard]] std::vector<std::string> othersOf(Binding binding, const Place& but) const;
    /// Returns the number of bindings that are in more than one list.
    [[nodiscard]] std::size_t shared() const;

    // Changes. Errors are messages for the user.

    Result<Done> add(Kind kind, std::string_view name);
    /// Renames an action or axis, also in all scenes and prefabs that reference it; either all files are
    /// written or none. The notice reports the number of references.
    Result<Done> rename(Kind kind, const std::string& from, std::string_view to);
    /// Removes an action or axis from project.json; an engine default gets its default bindings back.
    Result<Done> remove(Kind kind, const std::string& name);
    Result<Done> bind(const Place& place, Binding binding);
    Result<Done> unbind(const Place& place, std::size_t index);

private:
    /// Rereads the file. @error  it cannot be read, so the map cannot be changed
    Result<Done> ready();
    Result<Done> write(std::string label, Json project);
    /// Returns the project's JSON with the bindings of one list replaced.
    [[nodiscard]] Json withList(const Place& place, const std::vector<Binding>& bindings) const;
    [[nodiscard]] const Part* find(const Place& place) const;
    [[nodiscard]] const Row* find(Kind kind, std::string_view name) const;
    Result<Done> checkName(Kind kind, std::string_view name) const;

    Workspace& workspace_;
    std::optional<std::string> text_;  // content of the file when last read
    Json project_ = Json::object();
    std::vector<Row> rows_;
    std::string problem_;
    bool readable_ = false;
};

/// Returns the key, button or stick direction that an event reports as pressed; nullopt for all other events
/// and for key repeats.
std::optional<Binding> bindingOf(const Event& event);

}  // namespace plumb::editor
