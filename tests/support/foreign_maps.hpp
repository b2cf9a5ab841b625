#pragma once

#include <string>
#include <vector>

#include "core/file.hpp"
#include "core/text.hpp"
#include "tests/support/places.hpp"

namespace plumb::test {

/// Returns the map files of other editors with these endings: small ones in this repository and, if present,
/// those in ../shared/data/maps beside the repository and the examples of Debian's package `tiled`.
inline std::vector<Path> foreignMaps(std::initializer_list<std::string_view> endings) {
    std::vector<Path> maps;
    for (const Path& folder :
         {test::sourceFolder() / "tests/import/maps", test::sourceFolder() / "../shared/data/maps",
          Path{"/usr/share/doc/tiled/examples"}}) {
        for (const std::string_view ending : endings) {
            for (const std::string& file : filesBelow(folder, ending)) maps.push_back(folder / file);
        }
    }
    return maps;
}

}  // namespace plumb::test
