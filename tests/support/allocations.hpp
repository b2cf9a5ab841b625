#pragma once

#include <cstddef>

namespace plumb::test {

/// Number of memory blocks allocated and freed by operators new and delete since the program began. Programs
/// that call allocations() must compile allocations.cpp, which replaces these operators.
struct Allocations {
    std::size_t made = 0;
    std::size_t freed = 0;

    [[nodiscard]] std::size_t alive() const { return made - freed; }
};

Allocations allocations();

}  // namespace plumb::test
