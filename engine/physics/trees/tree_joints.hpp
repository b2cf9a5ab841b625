#pragma once

#include "physics/trees/joint_trees.hpp"

namespace plumb::physics {

// Equations of a link between a tree body and its parent. Hinges, the most frequent ones, are computed from
// their arms, with a third row while their drive gives a velocity; other joints from three Jacobian rows, of
// which unused ones are 0.

/// Computes the effective mass of a point link, as seen from the parent. @pre TreeBody::own is inverted
inline void stiffenPoint(const TreeBody& treeBody, Link& link) {
    const Symmetric& own = treeBody.own;
    const double x = link.limb.x, y = link.limb.y;
    link.across[0] = {own.xx - y * own.xt, own.xy - y * own.yt, own.xt - y * own.tt};
    link.across[1] = {own.xy + x * own.xt, own.yy + x * own.yt, own.yt + x * own.tt};
    const double xx = (link.across[0].x - y * link.across[0].turn) + link.softness.x;
    const double xy = link.across[0].y + x * link.across[0].turn;
    const double yy = (link.across[1].y + x * link.across[1].turn) + link.softness.y;
    if (link.turns()) {
        link.across[2] = {own.xt, own.yt, own.tt};
        link.stiffness =
            inverse({xx, xy, yy, own.xt - y * own.tt, own.yt + x * own.tt, own.tt + link.softness.turn});
    } else {
        link.stiffness = inverseUnturned({xx, xy, yy});
    }
}

inline void stiffenRows(const TreeBody& treeBody, Link& link) {
    for (int r = 0; r < 3; ++r) link.across[r] = treeBody.own * link.onTreeBody[r];
    const auto give = [&](int r, int q) { return dot(link.across[r], link.onTreeBody[q]); };
    link.stiffness = inverse({give(0, 0) + link.softness.x, give(0, 1), give(1, 1) + link.softness.y,
                              give(0, 2), give(1, 2), give(2, 2) + link.softness.turn});
}

/// Adds J^T K J of a hinge at (x, y) to a mass matrix.
inline void addPoint(double x, double y, const Symmetric& k, Symmetric& own) {
    const double xt = x * k.xy - y * k.xx + k.xt, yt = x * k.yy - y * k.xy + k.yt;
    own.xx += k.xx;
    own.xy += k.xy;
    own.yy += k.yy;
    own.xt += xt;
    own.yt += yt;
    own.tt += x * yt - y * xt + (x * k.yt - y * k.xt + k.tt);
}

inline void addRows(const Triple (&rows)[3], const Symmetric& k, Symmetric& own) {
    const Triple x{rows[0].x, rows[1].x, rows[2].x};
    const Triple y{rows[0].y, rows[1].y, rows[2].y};
    const Triple turn{rows[0].turn, rows[1].turn, rows[2].turn};
    own.xx += dot(k * x, x);
    own.xy += dot(k * y, x);
    own.yy += dot(k * y, y);
    own.xt += dot(k * turn, x);
    own.yt += dot(k * turn, y);
    own.tt += dot(k * turn, turn);
}

/// Computes a link's effective mass and adds its subtree to the mass matrix of the parent.
inline void stiffen(const TreeBody& treeBody, Link& link, TreeBody* parent) {
    if (link.byArms()) {
        stiffenPoint(treeBody, link);
        if (parent != nullptr) addPoint(link.parentLimb.x, link.parentLimb.y, link.stiffness, parent->own);
    } else {
        stiffenRows(treeBody, link);
        if (parent != nullptr) addRows(link.onParent, link.stiffness, parent->own);
    }
}

/// Returns the velocity of a link's rows for a velocity of the tree body, or of its parent.
inline Triple seenBy(const Triple (&rows)[3], const Triple& v) {
    return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
}
inline Triple seenFromLimb(const Link& link, const Triple& v) {
    if (link.byArms()) return {v.x - link.limb.y * v.turn, v.y + link.limb.x * v.turn, v.turn};
    return seenBy(link.onTreeBody, v);
}
inline Triple seenFromParent(const Link& link, const Triple& v) {
    if (link.byArms())
        return {link.parentLimb.y * v.turn - v.x, -(v.y + link.parentLimb.x * v.turn), -v.turn};
    return seenBy(link.onParent, v);
}

/// Returns the impulse (x, y, angular) on a body for given impulses of the rows.
inline Triple sumOf(const Triple (&rows)[3], const Triple& impulse) {
    return impulse.x * rows[0] + impulse.y * rows[1] + impulse.turn * rows[2];
}
inline Triple onParent(const Link& link, const Triple& impulse) {
    if (link.byArms())
        return {-impulse.x, -impulse.y,
                link.parentLimb.y * impulse.x - link.parentLimb.x * impulse.y - impulse.turn};
    return sumOf(link.onParent, impulse);
}
inline Triple onTreeBody(const Link& link, const Triple& impulse) {
    if (link.byArms())
        return {impulse.x, impulse.y, link.limb.x * impulse.y - link.limb.y * impulse.x + impulse.turn};
    return sumOf(link.onTreeBody, impulse);
}

/// Applies the impulse of a drive that exerts one to both bodies, except what was applied before.
inline void exertDrive(TreeBody& treeBody, const Link& link, TreeBody* parent) {
    if (!link.drive.on || !link.drive.exerts) return;
    const double impulse = link.drive.impulse - link.given.turn;
    treeBody.impulse += impulse * link.onTreeBody[2];
    if (parent != nullptr) parent->impulse += impulse * link.onParent[2];
}

/// Computes the impulse that removes Link::error if the parent is fixed, and its reaction on the parent.
inline void answer(TreeBody& treeBody, Link& link, TreeBody* parent) {
    exertDrive(treeBody, link, parent);
    Triple wanted{-link.error.x - dot(link.across[0], treeBody.impulse),
                  -link.error.y - dot(link.across[1], treeBody.impulse), 0.0};
    if (link.hasTwoRows()) {
        const Symmetric& k = link.stiffness;
        link.answer = {k.xx * wanted.x + k.xy * wanted.y, k.xy * wanted.x + k.yy * wanted.y, 0.0};
    } else {
        wanted.turn = -link.error.turn - dot(link.across[2], treeBody.impulse);
        link.answer = link.stiffness * wanted;
    }
    if (parent != nullptr) parent->impulse += onParent(link, link.answer);
}

/// From the velocity change of the parent (its `impulse`), computes the impulse of the link (its `answer`)
/// and the velocity change of the body.
inline void give(TreeBody& treeBody, Link& link, const TreeBody* parent) {
    Triple impulse = link.answer;
    if (parent != nullptr) {
        const Triple seen = seenFromParent(link, parent->impulse);
        const Symmetric& k = link.stiffness;
        if (link.hasTwoRows()) {
            impulse.x -= k.xx * seen.x + k.xy * seen.y;
            impulse.y -= k.xy * seen.x + k.yy * seen.y;
        } else {
            impulse = impulse - k * seen;
        }
    }
    link.answer = impulse;
    treeBody.impulse =
        treeBody.own * treeBody.impulse + impulse.x * link.across[0] + impulse.y * link.across[1];
    if (!link.hasTwoRows()) treeBody.impulse += impulse.turn * link.across[2];
}

}  // namespace plumb::physics
