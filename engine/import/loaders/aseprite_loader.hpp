#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "math/rect.hpp"
#include "reflect/json.hpp"

/// A sprite sheet that Aseprite exported, as its JSON says it. Units are px and ms, as in the file.
namespace plumb::aseprite {

struct Frame {
    std::string name;
    Rect area;             ///< in the sheet
    bool rotated = false;  ///< a quarter turn in the sheet, by packers
    Vec2 trimmed;          ///< where the area lies in the whole frame
    int width = 0;         ///< of the whole frame
    int height = 0;
    int milliseconds = 100;
};

/// Frames that belong together.
struct Tag {
    std::string name;
    int from = 0;
    int to = 0;             ///< the last one
    std::string direction;  ///< "forward", "reverse", "pingpong" or "pingpong_reverse"
    int repeat = 0;         ///< 0 is for ever
    Json notes = Json::object();
};

struct Sheet {
    std::string image;  ///< relative to the file's folder
    std::vector<Frame> frames;
    std::vector<Tag> tags;
    Json slices = Json::array();  ///< as they stand
    Json layers = Json::array();  ///< as they stand
    std::string version;
};

/// Reads both forms, the hash and the array. What is wrong inside is listed in `warnings` and left out.
/// @error  no sheet of Aseprite at all
Result<Sheet> parseSheet(std::string_view text, std::string_view where, std::vector<Error>& warnings);

}  // namespace plumb::aseprite
