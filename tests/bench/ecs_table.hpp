#pragma once

#include <array>
#include <cstddef>

namespace plumb::bench {

inline constexpr std::array<std::size_t, 4> kSizes = {1000, 10000, 100000, 1000000};

/// A row of the table of targets: ns per item for each size, measured on a reference machine. On other
/// machines the target is scaled by the ratio of both machines' limits (the same work on plain arrays). Rows
/// without a limit are scaled by the time to iterate two plain arrays. Rows that create entities have no
/// limit, because growing vectors would measure the allocator.
struct TableLine {
    const char* name;
    std::array<double, 4> limit;   ///< ns per item of plain arrays, by size; 0: not measured
    std::array<double, 4> target;  ///< ns per item, by size
};

enum TableName : std::size_t {
    kCreate,
    kCreateBulk,
    kDestroyEach,
    kDestroyAll,
    kRandomGet,
    kAddRemove,
    kAddRemoveInLoop,
    kIterateOne,
    kIterateTwo,
    kIterateThree,
    kMove,
    kRangeFor,
    kOneInEight,
    kManySets,
    kChurn,
    kSnapshot
};

inline constexpr std::array<double, 4> kNoLimit = {0, 0, 0, 0};
inline constexpr std::array<double, 4> kMoveLimit = {.13, .18, .18, .51};

inline constexpr TableLine kTable[] = {
    {"create with 2 components, warm", kNoLimit, {7, 7, 7, 8}},
    {"create 2, bulk", kNoLimit, {2.5, 2, 2.5, 3.5}},
    {"destroy each", kNoLimit, {8, 8, 8, 8}},
    {"destroy all", kNoLimit, {1.5, 1.5, 1.5, 1.5}},
    {"random get, generation checked", {.50, .51, .51, 1.7}, {.7, .9, 1.8, 7}},
    {"add + remove", kNoLimit, {6, 6, 6, 6}},
    {"add + remove inside loops", kNoLimit, {12, 12, 14, 40}},
    {"iterate 1", {.11, .14, .14, .26}, {.12, .14, .14, .27}},
    {"iterate 2", {.11, .17, .18, .50}, {.12, .17, .18, .50}},
    {"iterate 3", {.12, .28, .47, .74}, {.14, .25, .45, .77}},
    {"move (pos += vel * dt)", kMoveLimit, {.1365, .189, .189, .5355}},
    {"range-for with [entity, a, b]", kNoLimit, {.6, .6, .6, .6}},
    {"1 in 8 matches (per match)", {.14, .12, .18, .20}, {.16, .14, .16, .22}},
    {"256 different component sets, move", kMoveLimit, {.15, .18, .20, .55}},
    {"1 % churn + move", kNoLimit, {.8, .9, 1.5, 2.5}},
    {"snapshot of the world, total", kNoLimit, {2000, 18000, 500000, 8000000}},
};

}  // namespace plumb::bench
