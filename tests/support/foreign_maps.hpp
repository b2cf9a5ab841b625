#pragma once

#include <string>
#include <vector>

#include "core/file.hpp"
#include "core/text.hpp"
#include "tests/support/places.hpp"

namespace plumb::test {

/// Maps that nobody of this project made, where this machine has them: beside the repository, and those that
/// Debian's package `tiled` brings. Empty elsewhere.
inline std::vector<Path> foreignMaps(std::initializer_list<std::string_view> endings) {
    std::vector<Path> maps;
    for (const Path& folder :
         {test::sourceFolder() / "../shared/data/maps", Path{"/usr/share/doc/tiled/examples"}}) {
        for (const std::string_view ending : endings) {
            for (const std::string& file : filesBelow(folder, ending)) maps.push_back(folder / file);
        }
    }
    return maps;
}

}  // namespace plumb::test
