#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/file.hpp"
#include "core/result.hpp"
#include "math/rect.hpp"
#include "reflect/json.hpp"

/// A sprite sheet exported by Aseprite, as read from its JSON. Units are px and ms, as in the file.
namespace plumb::aseprite {

struct Frame {
    std::string name;
    Rect area;             ///< region of the sheet
    bool rotated = false;  ///< rotated by 90 degrees in the sheet by a texture packer
    Vec2 trimmed;          ///< position of `area` in the untrimmed frame
    int width = 0;         ///< width of the untrimmed frame
    int height = 0;
    int milliseconds = 100;
};

/// A named range of frames.
struct Tag {
    std::string name;
    int from = 0;
    int to = 0;                   ///< last frame, inclusive
    std::string direction;        ///< "forward", "reverse", "pingpong" or "pingpong_reverse"
    int repeat = 0;               ///< number of repetitions; 0: endless
    Json notes = Json::object();  ///< color and user data of the tag, unchanged JSON
};

struct Sheet {
    std::string image;  ///< relative to the file's folder
    std::vector<Frame> frames;
    std::vector<Tag> tags;
    Json slices = Json::array();  ///< unchanged JSON
    Json layers = Json::array();  ///< unchanged JSON
    std::string version;
};

/// Reads the JSON of a sheet, with frames as a hash or an array. Invalid parts are reported in `warnings`
/// and ignored.
/// @error  not an Aseprite sheet
Result<Sheet> parseSheet(std::string_view text, std::string_view where, std::vector<Error>& warnings);

}  // namespace plumb::aseprite
