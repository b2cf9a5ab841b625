#pragma once

#include "tests/accuracy/families/stage.hpp"

namespace plumb::families {

// Goals used by several families.

/// Goal "stands": the bodies end within a distance, m, of their planned positions.
Goal staysWithin(std::vector<std::uint32_t> bodies, double distance);
/// Goal "sleeps": no dynamic body is awake. Checked in Plumb only, and only with sleeping enabled.
Goal sleeps();
/// Goal "stays in": the centers of the bodies are inside a box.
Goal staysIn(std::vector<std::uint32_t> bodies, Vec2 low, Vec2 high);
/// Goal "overlaps": no two shapes overlap by more than a depth at the end, m.
Goal overlapsAtMost(double depth);
/// Goal "rests": at the end no body is faster than a speed, m/s.
Goal rests(std::vector<std::uint32_t> bodies, double speed);
/// Goal "keeps its joints": at the end no joint error (distance of its anchors) exceeds `gap`, m.
Goal keepsJoints(double gap);

/// False for a body that was removed to reduce a failing scene (shrink() in run.hpp); goals skip such bodies.
bool takesPart(const Stage& stage, std::uint32_t body);

}  // namespace plumb::families
