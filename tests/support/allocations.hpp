#pragma once

#include <cstddef>

namespace plumb::test {

/// What the program asked operator new for since it began. Programs that use it compile allocations.cpp too.
struct Allocations {
    std::size_t made = 0;
    std::size_t freed = 0;

    [[nodiscard]] std::size_t alive() const { return made - freed; }
};

Allocations allocations();

}  // namespace plumb::test
