#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/accuracy/report/order.hpp"
#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

/// Convergence of a scene's error with more substeps, compared with the expected order.
struct OrderRow {
    std::string scene;
    std::string method;  ///< solver or integrator
    Order order;
    std::optional<double> expected;
    std::string unit;
    std::string why;  ///< empty if it is as expected
};

/// For each scene with all its solvers and integrators, at one iteration.
std::vector<OrderRow> ordersOf(const std::vector<Row>& rows);

/// "1.98", "too few points".
std::string powerText(const Order& order);
/// "2 to 64": the substeps of the fitted points.
std::string rangeText(const Order& order);
/// "0.02 mm from 16 substeps on", "not met".
std::string floorText(const OrderRow& row);

}  // namespace plumb::accuracy
