#include <string_view>
#include <vector>

#include "tests/accuracy/stability/stability.hpp"

int main(int argc, char** argv) {
    const std::vector<std::string_view> words(argv + 1, argv + argc);
    return plumb::stability::runStability(words);
}
