#include "tests/accuracy/report/orders.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "tests/accuracy/report/chart.hpp"
#include "tests/accuracy/report/scene_texts.hpp"

namespace plumb::accuracy {

namespace {

std::vector<std::string> scenesIn(const std::vector<Row>& rows) {
    std::vector<std::string> scenes;
    for (const Row& row : rows) {
        if (scenes.empty() || scenes.back() != row.scene) scenes.push_back(row.scene);
    }
    return scenes;
}

}  // namespace

std::vector<OrderRow> ordersOf(const std::vector<Row>& rows) {
    std::vector<OrderRow> orders;
    for (const std::string& scene : scenesIn(rows)) {
        const std::vector<Row> own = rowsOf(rows, scene);
        const SceneText& text = textOf(scene);
        const Chart chart = chartOf(scene, own);
        for (std::size_t i = 0; i < chart.lines.size(); ++i) {
            const ChartLine& line = chart.lines[i];
            std::vector<Sample> samples;
            for (const Row& row : line.rows)
                samples.push_back({static_cast<double>(row.substeps), row.error});
            OrderRow order{scene, line.name, orderOf(samples), std::nullopt, chart.unit, {}};
            if (const double power = textbookOrder(line.name); power > 0.0) {
                order.expected = power;
            } else if (text.order != SceneText::kNoOrder) {
                order.expected = text.order;
            }
            if (i == 0) order.why = text.why;
            orders.push_back(std::move(order));
        }
    }
    return orders;
}

std::string powerText(const Order& order) {
    return order.points < 2 ? "too few points" : fixedText(order.power, 2);
}

std::string rangeText(const Order& order) {
    if (order.points < 2) return "-";
    return format("{} to {}", static_cast<int>(order.first), static_cast<int>(order.last));
}

std::string floorText(const OrderRow& row) {
    if (row.order.floorFrom == 0.0) return "not met";
    return format("{} {} from {} substeps on", figureText(row.order.floor), row.unit,
                  static_cast<int>(row.order.floorFrom));
}

}  // namespace plumb::accuracy
