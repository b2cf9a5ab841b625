#pragma once

#include <string_view>

namespace plumb {

/// What the importer knows of one element of Tiled's files, in their XML and their JSON form.
struct TmxElement {
    std::string_view name;
    std::string_view read;           ///< attributes that reach the scene, with spaces between
    std::string_view unneeded = {};  ///< attributes that mean something only inside Tiled
    bool idle = false;               ///< all of it means something only inside Tiled

    [[nodiscard]] bool reads(std::string_view attribute) const;
    [[nodiscard]] bool isIdle(std::string_view attribute) const;
};

/// Null for an element that no version of Tiled wrote when this was written.
const TmxElement* findTmxElement(std::string_view name);

}  // namespace plumb
