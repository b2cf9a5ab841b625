#include "editor/model/assets/sheet_part.hpp"

#include <gtest/gtest.h>

namespace plumb::editor {
namespace {

TEST(SheetParts, aThumbnailShowsAWholeImageButOnlyTheBeginningOfALongStrip) {
    EXPECT_EQ(legiblePart({64.0f, 64.0f}), (Rect{0.0f, 0.0f, 64.0f, 64.0f}));
    EXPECT_EQ(legiblePart({128.0f, 32.0f}), (Rect{0.0f, 0.0f, 128.0f, 32.0f}));
    EXPECT_EQ(legiblePart({4000.0f, 32.0f}), (Rect{0.0f, 0.0f, 64.0f, 32.0f})) << "its first frames";
    EXPECT_EQ(legiblePart({16.0f, 800.0f}), (Rect{0.0f, 0.0f, 16.0f, 32.0f}));
    EXPECT_EQ(legiblePart({300.0f, 1.0f}), (Rect{0.0f, 0.0f, 2.0f, 1.0f}));
}

}  // namespace
}  // namespace plumb::editor
