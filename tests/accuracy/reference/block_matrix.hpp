#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace plumb::reference {

/// A sparse square matrix of 3x3 blocks with a direct solver. Rows are eliminated in minimum-degree order,
/// which takes O(n log n) for bodies in a plane that touch, and O(n) for chains and trees. Only the sparsity
/// pattern must be symmetric. Source: A. George, J. Liu, The Evolution of the Minimum Degree Ordering
/// Algorithm, SIAM Review 31, 1989.
class BlockMatrix {
public:
    using Block = std::array<double, 9>;                   // row-major
    using Edge = std::pair<std::uint32_t, std::uint32_t>;  // row and column of an off-diagonal block

    /// Sets the size, and the blocks that may be nonzero; does nothing if both are unchanged.
    /// @param edges  off-diagonal blocks in the upper triangle, sorted and unique; the pattern is symmetric
    void shape(std::uint32_t count, std::vector<Edge> edges);
    void clear();  ///< sets all blocks to 0
    /// Returns the block of a row and a column. @pre row and column are equal or form one of the edges
    Block& at(std::uint32_t row, std::uint32_t column);
    /// Factors the matrix. @return false if a pivot block is singular
    bool factor();
    /// Solves the system. @param values the right-hand side, three values per row; replaced by the solution
    void solve(std::span<double> values);

private:
    void order();
    [[nodiscard]] std::uint32_t indexOf(std::uint32_t low, std::uint32_t high) const;

    std::uint32_t count_ = 0;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> placeOf_, rowAt_;  // position of each row in the elimination, and inverse
    std::vector<std::uint32_t> first_, later_;  // later positions coupled to position i: later_[first_[i]] on
    std::vector<std::uint32_t> updates_;  // block changed by eliminating i, per pair of later positions of i
    std::vector<Block> diagonal_, upper_, lower_;
    std::vector<double> sorted_;
};

}  // namespace plumb::reference
