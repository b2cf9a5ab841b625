#pragma once

#include "tests/accuracy/families/stage.hpp"

namespace plumb::families {

// Goals that several families have.

/// "stands": none of these bodies is further (m) from where it was planned.
Goal staysWithin(std::vector<std::uint32_t> bodies, double distance);
/// "sleeps": no dynamic body is awake. Only asked where the engine is ours and sleeping is on.
Goal sleeps();
/// "stays in": the center of each of these bodies is in the box.
Goal staysIn(std::vector<std::uint32_t> bodies, Vec2 low, Vec2 high);
/// "overlaps": no two shapes are deeper (m) in each other at the end.
Goal overlapsAtMost(double depth);
/// "rests": none of these bodies is faster (m/s).
Goal rests(std::vector<std::uint32_t> bodies, double speed);
/// "keeps its joints": no joint is open by more (m).
Goal keepsJoints(double gap);

/// False for a body that shrinking took out of the scene: goals that ask for a motion leave it out.
bool takesPart(const Stage& stage, std::uint32_t body);

}  // namespace plumb::families
