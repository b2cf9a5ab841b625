#pragma once

#include <algorithm>
#include <limits>

#include "physics/trees/joint_trees.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

// Finds the impulses of all motors and limits of a tree. They minimize a convex, piecewise quadratic function
// (the complementarity conditions of Drive are its optimality conditions), by the active set method: the rows
// that do not exert a given impulse are solved with the tree, and all impulses move towards the result until
// the first one reaches the end of its range. Source: P. Stark and R. Parker, "Bounded-Variable
// Least-Squares: an Algorithm and Applications", Computational Statistics 10, 1995.

/// Velocity that a drive gives with an impulse in a range.
inline double targetOf(const Drive& drive, Drive::Range range) {
    if (range == Drive::Range::Above) return drive.slowest;
    return range == Drive::Range::Below ? drive.fastest
                                        : std::clamp(drive.speed, drive.slowest, drive.fastest);
}

/// Returns the part of the impulse that is the motor's. At a limit it still pushes towards its speed.
inline double motorImpulseOf(const Drive& drive) {
    if (drive.speed > drive.fastest) return drive.most;
    return drive.speed < drive.slowest ? -drive.most : std::clamp(drive.impulse, -drive.most, drive.most);
}

/// Starts with the impulse of the last step, for substeps of h seconds.
inline void startDrive(Drive& drive, double h) {
    drive.most = drive.maxForce * h;
    drive.impulse = drive.force * h;
    drive.exerts = drive.impulse == drive.most || drive.impulse == -drive.most;
    drive.range = drive.impulse > drive.most    ? Drive::Range::Above
                  : drive.impulse < -drive.most ? Drive::Range::Below
                                                : Drive::Range::Within;
}

/// Calls act(link) for all links of a tree with a motor or limits.
template <class Act>
void forDrives(JointTrees& trees, const JointTree& tree, Act&& act) {
    if (!tree.drives) return;
    forLinks(trees, tree, [&](Link& link) {
        if (link.drive.on) act(link);
    });
}

/// Returns the change of a value's velocity by the computed velocity changes of its bodies.
inline double velocityChangeOf(const JointTrees& trees, const Link& link) {
    const double change = dot(link.onTreeBody[2], trees.treeBodies[link.treeBody].impulse);
    if (link.parent == kNone) return change;
    return change + dot(link.onParent[2], trees.treeBodies[link.parent].impulse);
}

/// Moves all impulses towards the computed ones until one reaches the end of its range, which it then exerts.
/// @return true if one did
inline bool stopAtEnds(JointTrees& trees, const JointTree& tree) {
    const auto endOf = [](const Drive& drive, bool upper) {
        const double sign = upper ? 1.0 : -1.0;
        if (drive.range == Drive::Range::Within) return sign * drive.most;
        const bool isOpen = (drive.range == Drive::Range::Above) == upper;
        return sign * (isOpen ? std::numeric_limits<double>::infinity() : -drive.most);
    };
    const auto wantedOf = [](const Link& link) { return link.given.turn + link.answer.turn; };
    // Part of the way after which an impulse reaches the end of its range.
    const auto partOf = [&](const Link& link) {
        const Drive& drive = link.drive;
        const double change = wantedOf(link) - drive.impulse;
        if (drive.exerts || change == 0.0) return 1.0;
        return std::clamp((endOf(drive, change > 0.0) - drive.impulse) / change, 0.0, 1.0);
    };
    double part = 1.0;
    forDrives(trees, tree, [&](const Link& link) { part = std::min(part, partOf(link)); });
    forDrives(trees, tree, [&](Link& link) {
        Drive& drive = link.drive;
        if (drive.exerts) return;
        const double change = wantedOf(link) - drive.impulse;
        drive.exerts = part < 1.0 && partOf(link) <= part;
        drive.impulse = drive.exerts ? endOf(drive, change > 0.0) : drive.impulse + part * change;
    });
    return part < 1.0;
}

/// Releases drives whose velocity is not between those of the ranges on both sides of their impulse.
/// @param all  true: releases all of them; else the one with the largest error
/// @return true if one was released
inline bool releaseDrives(JointTrees& trees, const JointTree& tree, bool all) {
    using Range = Drive::Range;
    double largest = kDriveTolerance;
    Drive* worst = nullptr;
    Range next = Range::Within;
    forDrives(trees, tree, [&](Link& link) {
        Drive& drive = link.drive;
        if (!drive.exerts) return;
        const double velocity = drive.velocity + velocityChangeOf(trees, link);
        const Range above = drive.impulse == drive.most ? Range::Above : Range::Within;
        const Range below = drive.impulse == -drive.most ? Range::Below : Range::Within;
        const double tooSlow = targetOf(drive, above) - velocity, tooFast = velocity - targetOf(drive, below);
        const double error = std::max(tooSlow, tooFast);
        if (error <= (all ? kDriveTolerance : largest)) return;
        largest = error;
        next = tooSlow > tooFast ? above : below;
        worst = &drive;
        if (all) drive.exerts = false, drive.range = next;
    });
    if (worst != nullptr) worst->exerts = false, worst->range = next;
    return worst != nullptr;
}

}  // namespace plumb::physics
