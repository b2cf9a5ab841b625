#pragma once

namespace plumb::physics {

/// The rows of four floats that a Contact is made of, for those who read eight contacts at once.
enum ContactRow {
    kSurfaceRow = 1,
    kNormalRow = 2,
    kImpulseRow = 3,
    kTurnRow = 4,
    kAnchorsRow = 5,
    kRoundRow = 7,
    kContactRows = 8
};

}  // namespace plumb::physics
