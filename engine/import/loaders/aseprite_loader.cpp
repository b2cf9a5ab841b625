#include "import/loaders/aseprite_loader.hpp"

#include <algorithm>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_text.hpp"

namespace plumb::aseprite {
namespace {

constexpr std::size_t kMaxFrames = std::size_t{1} << 16;
constexpr std::size_t kMaxTags = 1024;
constexpr int kLongest = 1 << 28;  // ms

Rect readRect(JsonFields& owner, std::string_view key, std::vector<Error>& warnings) {
    const Json* json = owner.find(key);
    if (json == nullptr) return {};
    JsonFields fields{*json, format("{}.{}", owner.where(), key), warnings};
    const auto side = static_cast<float>(limits::kImageSide);
    const float x = fields.number("x", 0.0f, -side, side);
    const float y = fields.number("y", 0.0f, -side, side);
    return {x, y, fields.number("w", 0.0f, 0.0f, side), fields.number("h", 0.0f, 0.0f, side)};
}

Frame readFrame(JsonFields fields, std::string name, std::vector<Error>& warnings) {
    Frame frame;
    frame.name = fields.text("filename", name);
    frame.area = readRect(fields, "frame", warnings);
    frame.rotated = fields.flag("rotated", false);
    static_cast<void>(fields.flag("trimmed", false));
    const Rect inside = readRect(fields, "spriteSourceSize", warnings);
    const Rect whole = readRect(fields, "sourceSize", warnings);
    frame.trimmed = {inside.x, inside.y};
    frame.width = static_cast<int>(whole.width > 0.0f ? whole.width : frame.area.width);
    frame.height = static_cast<int>(whole.height > 0.0f ? whole.height : frame.area.height);
    frame.milliseconds = fields.whole("duration", 100, 0, kLongest);
    fields.warnUnknown();
    return frame;
}

void readFrames(JsonFields& fields, const Json& list, Sheet& sheet, std::vector<Error>& warnings) {
    if (list.is_object()) {
        for (const auto& [name, value] : list.items()) {
            if (sheet.frames.size() >= kMaxFrames) break;
            const std::string where = format("{}.frames[\"{}\"]", fields.where(), name);
            sheet.frames.push_back(readFrame(JsonFields{value, where, warnings}, name, warnings));
        }
        return;
    }
    for (JsonFields& item : fields.objects("frames", kMaxFrames))
        sheet.frames.push_back(readFrame(std::move(item), "", warnings));
}

void readTags(JsonFields& meta, Sheet& sheet) {
    const int last = static_cast<int>(sheet.frames.size()) - 1;
    for (JsonFields& item : meta.objects("frameTags", kMaxTags)) {
        Tag tag;
        tag.name = item.text("name");
        tag.from = std::clamp(item.whole("from", 0, 0, kLongest), 0, last);
        tag.to = std::clamp(item.whole("to", tag.from, 0, kLongest), tag.from, last);
        tag.direction = item.text("direction", "forward");
        const std::string repeat = item.find("repeat") == nullptr ? "0" : item.text("repeat");
        tag.repeat = static_cast<int>(parseInt(repeat).value_or(0));
        for (const char* key : {"color", "data"}) {
            if (const Json* value = item.find(key)) tag.notes[key] = *value;
        }
        item.warnUnknown();
        sheet.tags.push_back(std::move(tag));
    }
}

}  // namespace

Result<Sheet> parseSheet(std::string_view text, std::string_view where, std::vector<Error>& warnings) {
    const Result<Json> json = parseJson(text, where, &warnings);
    if (!json) return json.error();
    JsonFields fields{*json, std::string{where}, warnings};
    const Json* frames = fields.find("frames");
    const Json* meta = fields.find("meta");
    Sheet sheet;
    if (frames != nullptr && meta != nullptr) readFrames(fields, *frames, sheet, warnings);
    if (sheet.frames.empty()) {
        return Error{std::string{where}, "not an Aseprite sheet: it has no list of frames",
                     "export it with File, Export Sprite Sheet, Output: JSON Data"};
    }
    fields.warnUnknown();
    JsonFields about{*meta, format("{}: meta", where), warnings};
    sheet.image = about.text("image");
    sheet.version = about.text("version");
    readTags(about, sheet);
    if (const Json* slices = about.find("slices")) sheet.slices = *slices;
    if (const Json* layers = about.find("layers")) sheet.layers = *layers;
    for (const char* known : {"app", "format", "size", "scale"}) static_cast<void>(about.find(known));
    about.warnUnknown();
    return sheet;
}

}  // namespace plumb::aseprite
