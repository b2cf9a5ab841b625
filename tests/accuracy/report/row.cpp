#include "tests/accuracy/report/row.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plumb::accuracy {

std::string_view integratorName(physics::IntegratorKind kind) {
    switch (kind) {
        case physics::IntegratorKind::ExplicitEuler: return "explicit Euler";
        case physics::IntegratorKind::SemiImplicitEuler: return "semi-implicit Euler";
        case physics::IntegratorKind::Verlet: return "Verlet";
        case physics::IntegratorKind::Rk4: return "Runge-Kutta 4";
        case physics::IntegratorKind::Count: break;
    }
    return "unknown";
}

std::string solverName(const Method& method, bool joints) {
    if (method.peer != nullptr) return method.peer->name;
    return joints && method.jointTrees ? "soft step with joint trees" : "soft step";
}

std::vector<Row> rowsOf(const std::vector<Row>& rows, std::string_view scene) {
    std::vector<Row> found;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(found),
                 [scene](const Row& row) { return row.scene == scene; });
    return found;
}

const Row* defaultRow(const std::vector<Row>& rows, std::string_view scene) {
    const auto found = std::find_if(rows.begin(), rows.end(), [scene](const Row& row) {
        return row.scene == scene && row.main && isDefault(row.method);
    });
    return found != rows.end() ? &*found : nullptr;
}

const Row* peerRow(const std::vector<Row>& rows, std::string_view scene, std::string_view engine) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
        return row.scene == scene && row.main && row.method.peer != nullptr && row.solver == engine;
    });
    return found != rows.end() ? &*found : nullptr;
}

std::string figureText(double value) {
    if (!std::isfinite(value)) return "fails";
    if (value == 0.0) return "0";
    const double size = std::fabs(value);
    char text[32];
    if (size < 1.0e-4 || size >= 1.0e6) {
        std::snprintf(text, sizeof text, "%.1e", value);
        return text;
    }
    // Three significant digits, no decimals from 100 on, and no trailing zeros.
    const int digits = std::max(0, 2 - static_cast<int>(std::floor(std::log10(size))));
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    std::string result = text;
    if (digits > 0) {
        while (result.back() == '0') result.pop_back();
        if (result.back() == '.') result.pop_back();
    }
    return result;
}

}  // namespace plumb::accuracy
