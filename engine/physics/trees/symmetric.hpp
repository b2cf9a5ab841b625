#pragma once

namespace plumb::physics {

/// Components along x, y and of the rotation: of a velocity, an impulse or a row of a Jacobian.
struct Triple {
    double x = 0.0;
    double y = 0.0;
    double turn = 0.0;
};

inline double dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.turn * b.turn; }
inline Triple& operator+=(Triple& a, const Triple& b) {
    a.x += b.x;
    a.y += b.y;
    a.turn += b.turn;
    return a;
}
inline Triple operator*(double s, const Triple& a) { return {s * a.x, s * a.y, s * a.turn}; }

/// A symmetric 3 x 3 matrix over triples.
struct Symmetric {
    double xx = 1.0;
    double xy = 0.0;
    double yy = 1.0;
    double xt = 0.0;
    double yt = 0.0;
    double tt = 1.0;
};

inline Triple operator*(const Symmetric& m, const Triple& v) {
    return {m.xx * v.x + m.xy * v.y + m.xt * v.turn, m.xy * v.x + m.yy * v.y + m.yt * v.turn,
            m.xt * v.x + m.yt * v.y + m.tt * v.turn};
}

/// Inverse of a positive definite matrix by L D L^T: positive definite too, whatever the condition number.
inline Symmetric inverse(const Symmetric& m) {
    const double d0 = 1.0 / m.xx, l10 = m.xy * d0, l20 = m.xt * d0;
    const double d1 = 1.0 / (m.yy - m.xy * l10), below = m.yt - m.xt * l10, l21 = below * d1;
    const double d2 = 1.0 / (m.tt - m.xt * l20 - below * l21);
    const double n20 = l10 * l21 - l20;
    Symmetric w;
    w.tt = d2;
    w.yt = -l21 * d2;
    w.xt = n20 * d2;
    w.yy = d1 + l21 * l21 * d2;
    w.xy = n20 * w.yt - l10 * d1;
    w.xx = d0 + l10 * l10 * d1 + n20 * n20 * d2;
    return w;
}

/// The same for a body that cannot rotate.
inline Symmetric inverseUnturned(const Symmetric& m) {
    const double scale = 1.0 / (m.xx * m.yy - m.xy * m.xy);
    return {m.yy * scale, -m.xy * scale, m.xx * scale, 0.0, 0.0, 0.0};
}

}  // namespace plumb::physics
