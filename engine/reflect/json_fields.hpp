#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "math/vec2.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb {

/// A property that the engine does not know: its value as JSON text, kept to be written back.
struct KeptProperty {
    std::string name;
    std::string json;

    friend bool operator==(const KeptProperty&, const KeptProperty&) = default;
};

/// Writes kept properties back into their object.
void writeKept(Json& object, const std::vector<KeptProperty>& properties);

/// Reads the properties of one JSON object of a file. The result for a missing property is its fallback; for
/// an invalid one it is the fallback and a problem is reported. warnUnknown() reports properties never read.
class JsonFields {
public:
    /// @param where  the path of the object, for messages, e.g. "tiles.tileset.json: tiles[3]"
    /// @param object  must outlive this; anything but an object is reported and read as an empty one
    JsonFields(const Json& object, std::string where, std::vector<Error>& problems);

    [[nodiscard]] const std::string& where() const { return where_; }

    /// The JSON value of the property; null if it is missing.
    const Json* find(std::string_view key);

    std::string text(std::string_view key, std::string_view fallback = {});
    bool flag(std::string_view key, bool fallback);
    int whole(std::string_view key, int fallback, int min, int max);
    float number(std::string_view key, float fallback, float min, float max);
    Vec2 vec2(std::string_view key, Vec2 fallback);

    /// The index of the value in `names`.
    std::size_t choice(std::string_view key, std::size_t fallback, std::span<const std::string_view> names);

    /// The items of an array of objects, each with its own path; empty if it is missing or not an array.
    std::vector<JsonFields> objects(std::string_view key, std::size_t limit);

    /// The items of an array of any values; null if it is missing or not an array.
    const Json* array(std::string_view key);

    /// Checks the version of the file in "format".
    /// @return false, after reporting a problem, if this program is too old for it
    bool acceptFormat(int newest);

    void warn(std::string_view key, std::string what, std::string remedy);

    /// Reports the properties that were never read, and returns them so that they can be kept.
    std::vector<KeptProperty> keepUnknown();
    void warnUnknown() { static_cast<void>(keepUnknown()); }

    /// The properties of a nested object, unchanged: only the game interprets them.
    std::vector<KeptProperty> kept(std::string_view key);

private:
    const Json* object_;
    std::string where_;
    std::vector<Error>* problems_;
    std::vector<std::string_view> asked_;  ///< keys that were read
};

/// The value as short text for messages: "\"fast\"", "[…]", "12".
std::string briefText(const Json& json);

}  // namespace plumb
