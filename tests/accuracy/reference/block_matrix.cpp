#include "tests/accuracy/reference/block_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace plumb::reference {

namespace {

using Block = BlockMatrix::Block;

Block product(const Block& a, const Block& b) {
    Block c;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            c[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
    return c;
}

void subtract(Block& a, const Block& b) {
    for (std::size_t i = 0; i < 9; ++i) a[i] -= b[i];
}

/// Inverts a block by Gauss-Jordan elimination with column pivoting. @return false if it is singular
bool invert(Block& a) {
    Block result{1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (std::size_t c = 0; c < 3; ++c) {
        std::size_t pivot = c;
        for (std::size_t r = c + 1; r < 3; ++r) {
            if (std::fabs(a[3 * r + c]) > std::fabs(a[3 * pivot + c])) pivot = r;
        }
        if (!(std::fabs(a[3 * pivot + c]) > 0.0) || !std::isfinite(a[3 * pivot + c])) return false;
        for (std::size_t j = 0; j < 3 && pivot != c; ++j) {
            std::swap(a[3 * pivot + j], a[3 * c + j]);
            std::swap(result[3 * pivot + j], result[3 * c + j]);
        }
        const double scale = 1.0 / a[3 * c + c];
        for (std::size_t j = 0; j < 3; ++j) a[3 * c + j] *= scale, result[3 * c + j] *= scale;
        for (std::size_t r = 0; r < 3; ++r) {
            const double part = r == c ? 0.0 : a[3 * r + c];
            for (std::size_t j = 0; j < 3 && part != 0.0; ++j) {
                a[3 * r + j] -= part * a[3 * c + j];
                result[3 * r + j] -= part * result[3 * c + j];
            }
        }
    }
    a = result;
    return true;
}

void subtractProduct(const Block& a, const double* x, double* y) {
    for (std::size_t i = 0; i < 3; ++i) y[i] -= a[3 * i] * x[0] + a[3 * i + 1] * x[1] + a[3 * i + 2] * x[2];
}

void joinSorted(std::vector<std::uint32_t>& list, std::uint32_t value) {
    const auto at = std::lower_bound(list.begin(), list.end(), value);
    if (at == list.end() || *at != value) list.insert(at, value);
}

}  // namespace

void BlockMatrix::shape(std::uint32_t count, std::vector<Edge> edges) {
    if (count == count_ && edges == edges_) return;
    count_ = count;
    edges_ = std::move(edges);
    order();
    diagonal_.resize(count_);
    upper_.resize(later_.size());
    lower_.resize(later_.size());
    sorted_.resize(3 * count_);
}

void BlockMatrix::order() {
    std::vector<std::vector<std::uint32_t>> near(count_);
    for (const auto& [a, b] : edges_) near[a].push_back(b), near[b].push_back(a);
    for (auto& list : near) std::sort(list.begin(), list.end());
    placeOf_.assign(count_, count_);
    rowAt_.clear();
    std::vector<std::vector<std::uint32_t>> later;
    for (std::uint32_t turn = 0; turn < count_; ++turn) {
        std::uint32_t best = count_;
        for (std::uint32_t row = 0; row < count_; ++row) {
            if (placeOf_[row] == count_ && (best == count_ || near[row].size() < near[best].size()))
                best = row;
        }
        placeOf_[best] = turn;
        rowAt_.push_back(best);
        for (const std::uint32_t a : near[best]) {
            near[a].erase(std::lower_bound(near[a].begin(), near[a].end(), best));
            for (const std::uint32_t b : near[best]) {
                if (a != b) joinSorted(near[a], b);
            }
        }
        later.push_back(std::move(near[best]));
    }
    first_.assign(1, 0);
    later_.clear();
    for (auto& list : later) {
        for (std::uint32_t& row : list) row = placeOf_[row];
        std::sort(list.begin(), list.end());
        later_.insert(later_.end(), list.begin(), list.end());
        first_.push_back(static_cast<std::uint32_t>(later_.size()));
    }
    updates_.clear();
    for (const auto& list : later) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            for (std::size_t j = i + 1; j < list.size(); ++j) updates_.push_back(indexOf(list[i], list[j]));
        }
    }
}

std::uint32_t BlockMatrix::indexOf(std::uint32_t low, std::uint32_t high) const {
    const auto begin = later_.begin() + first_[low], end = later_.begin() + first_[low + 1];
    return static_cast<std::uint32_t>(std::lower_bound(begin, end, high) - later_.begin());
}

void BlockMatrix::clear() {
    for (auto* const blocks : {&diagonal_, &upper_, &lower_})
        std::fill(blocks->begin(), blocks->end(), Block{});
}

BlockMatrix::Block& BlockMatrix::at(std::uint32_t row, std::uint32_t column) {
    const std::uint32_t a = placeOf_[row], b = placeOf_[column];
    if (a == b) return diagonal_[a];
    return a < b ? upper_[indexOf(a, b)] : lower_[indexOf(b, a)];
}

bool BlockMatrix::factor() {
    std::size_t update = 0;
    for (std::uint32_t turn = 0; turn < count_; ++turn) {
        if (!invert(diagonal_[turn])) return false;
        const std::uint32_t begin = first_[turn], end = first_[turn + 1];
        for (std::uint32_t i = begin; i < end; ++i) {
            lower_[i] = product(lower_[i], diagonal_[turn]);
            subtract(diagonal_[later_[i]], product(lower_[i], upper_[i]));
        }
        for (std::uint32_t i = begin; i < end; ++i) {
            for (std::uint32_t j = i + 1; j < end; ++j, ++update) {
                subtract(upper_[updates_[update]], product(lower_[i], upper_[j]));
                subtract(lower_[updates_[update]], product(lower_[j], upper_[i]));
            }
        }
    }
    return true;
}

void BlockMatrix::solve(std::span<double> values) {
    for (std::uint32_t turn = 0; turn < count_; ++turn) {
        for (std::uint32_t i = 0; i < 3; ++i) sorted_[3 * turn + i] = values[3 * rowAt_[turn] + i];
    }
    for (std::uint32_t turn = 0; turn < count_; ++turn) {
        for (std::uint32_t i = first_[turn]; i < first_[turn + 1]; ++i)
            subtractProduct(lower_[i], &sorted_[3 * turn], &sorted_[3 * later_[i]]);
    }
    for (std::uint32_t turn = count_; turn-- > 0;) {
        double rest[3] = {sorted_[3 * turn], sorted_[3 * turn + 1], sorted_[3 * turn + 2]};
        for (std::uint32_t i = first_[turn]; i < first_[turn + 1]; ++i)
            subtractProduct(upper_[i], &sorted_[3 * later_[i]], rest);
        const Block& inverse = diagonal_[turn];
        for (std::uint32_t i = 0; i < 3; ++i) {
            const double value =
                inverse[3 * i] * rest[0] + inverse[3 * i + 1] * rest[1] + inverse[3 * i + 2] * rest[2];
            sorted_[3 * turn + i] = value;
            values[3 * rowAt_[turn] + i] = value;
        }
    }
}

}  // namespace plumb::reference
