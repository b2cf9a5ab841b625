#pragma once

#include <string>
#include <vector>

#include "editor/ui/fields/field_row.hpp"
#include "math/curve.hpp"

namespace plumb::editor::ui {

/// A field that is a curve: a small picture, and where a click opens it, its keys. What is changed is the
/// curve of the one selected last, and it goes to all.
class CurveEdit {
public:
    void draw(const FieldRow& row);
    /// After all fields were drawn: ends what vanished in the middle of a drag.
    void endFrame(Ui& ui);

private:
    void drawPopup(const FieldRow& row, const Curve& curve);
    void drawCanvas(const FieldRow& row, const Curve& curve);
    static void drawButtons(const FieldRow& row);
    /// The key in hand follows the mouse.
    void drag(const FieldRow& row, const Curve& curve, CurveKey to);

    std::string path_;           // of the curve whose key is dragged; empty for none
    std::vector<ObjectId> ids_;  // whose it is: by the time it is let go others may be selected
    std::size_t key_ = 0;        // the one that is dragged
    Curve start_;                // as it was when the drag began
    CurveKey grab_;              // from the mouse to the key then
    float top_ = 1.0f;           // value at the upper edge while dragging
    bool drawn_ = false;         // the drag's widget is still there
};

/// What a curve is in words, for people and tests: "smooth 0:1 0.5:0.8 1:0".
std::string curveText(const Curve& curve);

}  // namespace plumb::editor::ui
