#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace plumb::reference {

/// A sparse square matrix of 3x3 blocks, and its solution by elimination. Rows are eliminated in the order
/// of minimum degree, which costs n log n if the blocks are those of bodies in a plane that touch, and n
/// for chains and trees. Only the pattern has to be symmetric.
/// Source: A. George, J. Liu, The Evolution of the Minimum Degree Ordering Algorithm, SIAM Review 31, 1989.
class BlockMatrix {
public:
    using Block = std::array<double, 9>;  // by rows
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    /// Sets the pattern of off-diagonal blocks; setting the same one again costs nothing.
    /// @param edges  sorted, without doubles, each with its lower index first
    void shape(std::uint32_t count, std::vector<Edge> edges);
    void clear();
    /// The block of a row and a column. @pre equal, or one of the edges
    Block& at(std::uint32_t row, std::uint32_t column);
    /// Factors the matrix. @return false if a block has no inverse
    bool factor();
    /// @param values the right-hand side, three values per row; replaced by the solution
    void solve(std::span<double> values);

private:
    void order();
    [[nodiscard]] std::uint32_t indexOf(std::uint32_t low, std::uint32_t high) const;

    std::uint32_t count_ = 0;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> placeOf_, rowAt_;  // from a row to its position in the order, and back
    std::vector<std::uint32_t> first_, later_;    // by position: later positions that are coupled to it
    std::vector<std::uint32_t> updates_;          // for each turn and each pair of `later`: where it goes
    std::vector<Block> diagonal_, upper_, lower_;
    std::vector<double> sorted_;
};

}  // namespace plumb::reference
