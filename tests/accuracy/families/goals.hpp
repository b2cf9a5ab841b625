#pragma once

#include "tests/accuracy/families/stage.hpp"

namespace plumb::families {

// Goals that several families share.

/// "stands": the maximum distance (m) of these bodies from their planned positions.
Goal staysWithin(std::vector<std::uint32_t> bodies, double distance);
/// "sleeps": no dynamic body is awake. Only checked for our engine, if sleeping is on.
Goal sleeps();
/// "stays in": the centers of these bodies are in the box.
Goal staysIn(std::vector<std::uint32_t> bodies, Vec2 low, Vec2 high);
/// "overlaps": the maximum overlap (m) of two shapes at the end.
Goal overlapsAtMost(double depth);
/// "rests": the maximum speed of these bodies (m/s).
Goal rests(std::vector<std::uint32_t> bodies, double speed);
/// "keeps its joints": the maximum joint gap (m).
Goal keepsJoints(double gap);

/// False for a body that was removed by shrinking: goals about motion skip it.
bool takesPart(const Stage& stage, std::uint32_t body);

}  // namespace plumb::families
