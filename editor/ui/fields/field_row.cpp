#include "editor/ui/fields/field_row.hpp"

#include "editor/model/workspace.hpp"

namespace plumb::editor::ui {

void FieldRow::change(const ChangeValue& how) const {
    ui.workspace.undo.endGesture();
    editFields(ui.workspace, target, how);
    ui.workspace.undo.endGesture();
}

void FieldRow::set(const FieldValue& value) const {
    change([&value](FieldValue& one, std::size_t) { one = value; });
}

const char* shownUnit(Unit unit) {
    switch (unit) {
        case Unit::None:
        case Unit::Ratio: return "";
        case Unit::Pixels: return "px";
        case Unit::PixelsPerSecond: return "px/s";
        case Unit::PixelsPerSecondSquared: return "px/s\xc2\xb2";
        case Unit::Seconds: return "s";
        case Unit::Radians:
        case Unit::Degrees: return "deg";
        case Unit::RadiansPerSecond: return "deg/s";
        case Unit::Kilograms: return "kg";
        case Unit::Tiles: return "tiles";
        case Unit::Ticks: return "ticks";
    }
    return "";
}

}  // namespace plumb::editor::ui
