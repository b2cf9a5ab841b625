#include "reflect/curve_json.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/text.hpp"
#include "reflect/field_context.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"

namespace plumb {
namespace {

constexpr std::string_view kForm = R"(write e.g. ["smooth", [0, 1], [1, 0]])";

Error valueError(const FieldInfo& field, std::string what, std::string remedy = std::string{kForm}) {
    return {std::string{field.name}, std::move(what), std::move(remedy)};
}

bool isFinite(const Json& json) {
    return json.is_number() && std::isfinite(json.get<double>()) &&
           std::fabs(json.get<double>()) <= double{std::numeric_limits<float>::max()};
}

Result<CurveShape> shapeFrom(const FieldInfo& field, const Json& json) {
    const auto* word = json.get_ptr<const std::string*>();
    if (word != nullptr && *word == "smooth") return CurveShape::Smooth;
    if (word != nullptr && *word == "linear") return CurveShape::Linear;
    return valueError(field,
                      format(R"(a curve begins with "smooth" or "linear", found {})", foundText(json)));
}

Result<CurveKey> keyFrom(const FieldInfo& field, const Json& json, std::size_t index) {
    if (!json.is_array() || json.size() != 2 || !isFinite(json[0]) || !isFinite(json[1]))
        return valueError(field, format("key {} is not a pair of numbers [position, value]", index));
    const CurveKey key{json[0].get<float>(), json[1].get<float>()};
    if (key.at < 0.0f || key.at > 1.0f)
        return valueError(field, format("key {} is at {}, outside 0 to 1", index, shortestText(key.at)),
                          "write a position from 0, the start, to 1, the end");
    return key;
}

void keepInRange(const FieldInfo& field, CurveKey& key, std::size_t index, FieldContext& context) {
    const float kept = std::clamp(key.value, field.min, field.max);
    if (kept == key.value) return;
    context.warn({std::string{field.name},
                  format("key {} has the value {}, outside {} to {}", index, shortestText(key.value),
                         shortestText(field.min), shortestText(field.max)),
                  format("using {}; write a value inside the range", shortestText(kept))});
    key.value = kept;
}

}  // namespace

Json curveToJson(const Curve& curve) {
    Json json = Json::array();
    json.push_back(curve.shape == CurveShape::Smooth ? "smooth" : "linear");
    for (std::size_t i = 0; i < curve.size(); ++i) {
        json.push_back(Json::array({double{curve.keys[i].at}, double{curve.keys[i].value}}));
    }
    return json;
}

Result<Done> readCurve(const FieldInfo& field, void* value, const Json& json, FieldContext& context) {
    if (!json.is_array() || json.empty())
        return valueError(field, format("expected a curve, found {}", foundText(json)));
    const Result<CurveShape> shape = shapeFrom(field, json[0]);
    if (!shape) return shape.error();
    const std::size_t keys = json.size() - 1;
    if (keys == 0) return valueError(field, "a curve needs at least one key");
    if (keys > Curve::kKeys)
        return valueError(field, format("{} keys, the limit is {}", keys, Curve::kKeys), "remove some keys");
    Curve curve = Curve::constant(0.0f);
    curve.shape = *shape;
    for (std::size_t i = 0; i < keys; ++i) {
        Result<CurveKey> key = keyFrom(field, json[i + 1], i);
        if (!key) return key.error();
        if (i > 0 && !(key->at > curve.keys[i - 1].at))
            return valueError(
                field, format("key {} is at {}, which is not after key {}", i, shortestText(key->at), i - 1),
                "sort the keys by position; no two may have the same");
        keepInRange(field, *key, i, context);
        curve.keys[i] = *key;
    }
    curve.count = static_cast<std::uint32_t>(keys);
    std::memcpy(value, &curve, sizeof curve);
    return Done{};
}

}  // namespace plumb
