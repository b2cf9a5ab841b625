#pragma once

#include <string>

#include "editor/model/shared_components.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

inline constexpr const char* kMixed = "\xe2\x80\x94";  ///< dash, shown if entities differ in a value

/// One field in a panel: its shown value, and the entities that an edit of the field changes.
struct FieldRow {
    Ui& ui;
    const std::string& path;  ///< widget path, for tests
    const FieldTarget& target;
    const SharedField& shared;

    [[nodiscard]] bool mixed() const { return shared.mixed.any(); }
    template <class T>
    [[nodiscard]] T value() const {
        T value{};
        std::memcpy(&value, shared.value.bytes.data(), sizeof(T));
        return value;
    }
    /// Changes the field of all entities of the target, as a separate undo step.
    void change(const ChangeValue& how) const;
    /// Sets the field of all entities of the target to a value, as a separate undo step.
    void set(const FieldValue& value) const;
};

/// Returns the symbol of the unit in which numbers are shown, e.g. "px", "deg/s" or "s".
const char* shownUnit(Unit unit);

}  // namespace plumb::editor::ui
