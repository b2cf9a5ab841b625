#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/accuracy/report/order.hpp"
#include "tests/accuracy/report/row.hpp"

namespace plumb::accuracy {

/// Measured and expected order of convergence of a scene's error with the number of substeps.
struct OrderRow {
    std::string scene;
    std::string method;  ///< name of the solver or integrator
    Order order;
    std::optional<double> expected;  ///< theoretical exponent; none: unknown
    std::string unit;                ///< unit of the error
    std::string why;                 ///< reason for a deviation; empty: as expected
};

/// Computes the orders of each scene for all of its solvers and integrators, at one iteration.
std::vector<OrderRow> ordersOf(const std::vector<Row>& rows);

/// Formats an order: "1.98", "too few points".
std::string powerText(const Order& order);
/// Formats the substeps of the fitted points: "2 to 64".
std::string rangeText(const Order& order);
/// Formats the floor: "0.02 mm from 16 substeps on"; "not met" if there is none.
std::string floorText(const OrderRow& row);

}  // namespace plumb::accuracy
