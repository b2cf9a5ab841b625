#pragma once

#include <string>

#include "editor/model/shared_components.hpp"
#include "editor/ui/ui.hpp"

namespace plumb::editor::ui {

inline constexpr const char* kMixed = "\xe2\x80\x94";  ///< a dash: the values are not the same

/// One field in a panel: what it shows, and which entities it changes.
struct FieldRow {
    Ui& ui;
    const std::string& path;  ///< how tests call it
    const FieldTarget& target;
    const SharedField& shared;

    [[nodiscard]] bool mixed() const { return shared.mixed.any(); }
    template <class T>
    [[nodiscard]] T value() const {
        T value{};
        std::memcpy(&value, shared.value.bytes.data(), sizeof(T));
        return value;
    }
    /// Changes all of them, as a step of undo of its own.
    void change(const ChangeValue& how) const;
    void set(const FieldValue& value) const;
};

/// "px", "deg/s", "s": what a number of the unit is shown in.
const char* shownUnit(Unit unit);

}  // namespace plumb::editor::ui
