#pragma once

#include <string>
#include <vector>

#include "editor/ui/fields/field_row.hpp"
#include "math/curve.hpp"

namespace plumb::editor::ui {

/// The widget of a curve field: a small plot; a click opens a popup to edit the keys. It edits the curve of
/// the last selected entity, and writes the result to all selected entities.
class CurveEdit {
public:
    void draw(const FieldRow& row);
    /// Must be called after all fields were drawn; ends a drag whose widget has disappeared.
    void endFrame(Ui& ui);

private:
    void drawPopup(const FieldRow& row, const Curve& curve);
    void drawCanvas(const FieldRow& row, const Curve& curve);
    static void drawButtons(const FieldRow& row);
    /// Moves the dragged key to `to`; ends the drag if the mouse button is up, cancels it with Esc.
    void drag(const FieldRow& row, const Curve& curve, CurveKey to);

    std::string path_;           // widget path of the curve whose key is dragged; empty: none
    std::vector<ObjectId> ids_;  // entities to change; the selection may change before the release
    std::size_t key_ = 0;        // index of the dragged key
    Curve start_;                // the curve at the start of the drag
    CurveKey grab_;              // offset from the mouse to the key at the start of the drag
    float top_ = 1.0f;           // value at the upper edge of the plot; constant during the drag
    bool drawn_ = false;         // the dragged widget was drawn in this frame
};

/// Returns a curve as text: its shape and its keys as position:value, e.g. "smooth 0:1 0.5:0.8 1:0".
std::string curveText(const Curve& curve);

}  // namespace plumb::editor::ui
