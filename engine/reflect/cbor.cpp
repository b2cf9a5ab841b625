#include "reflect/cbor.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "reflect/json.hpp"

namespace plumb {
namespace {

/// Builds a value from the events of the parser, under the limits. A handler that returns false ends
/// the parse.
class LimitedBuilder : public nlohmann::json_sax<Json> {
public:
    LimitedBuilder(std::string_view where, const JsonLimits& limits) : where_{where}, limits_{limits} {}

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override {
        return std::isfinite(value) ? add(value) : fail("a number that is not finite", "save the file again");
    }
    bool string(string_t& value) override { return isTextAllowed(value) && add(std::move(value)); }
    bool binary(binary_t&) override { return fail("binary data is not supported", "save the file again"); }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& value) override {
        if (!isTextAllowed(value)) return false;
        key_ = std::move(value);
        return true;
    }
    bool parse_error(std::size_t position, const std::string&, const Json::exception& error) override {
        if (!error_) fail(format("byte {}: {}", position, error.what()), "save or copy the file again");
        return false;
    }

    Result<Json> take(bool parsed) {
        if (!parsed) return *std::move(error_);
        return std::move(root_);
    }

private:
    bool fail(std::string what, std::string remedy) {
        error_ = Error{std::string{where_}, std::move(what), std::move(remedy)};
        return false;
    }

    bool isTextAllowed(const std::string& text) {
        if (text.size() > limits_.textBytes)
            return fail(format("a string longer than {} bytes", limits_.textBytes), "shorten it");
        return isUtf8(text) || fail("a string is not UTF-8", "save the file again");
    }

    bool add(Json value) { return place(std::move(value)) != nullptr; }

    bool open(Json empty) {
        if (open_.size() >= static_cast<std::size_t>(limits_.depth))
            return fail(format("nested deeper than {} levels", limits_.depth), "flatten the file");
        // Only the innermost open value grows, so the addresses of the others stay.
        Json* const placed = place(std::move(empty));
        if (placed != nullptr) open_.push_back(placed);
        return placed != nullptr;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    /// Adds a value to the innermost open one. @return null beyond the limit of values
    Json* place(Json value) {
        if (++values_ > limits_.values) {
            fail(format("more than {} values", limits_.values), "split the file");
            return nullptr;
        }
        if (open_.empty()) return &(root_ = std::move(value));
        if (auto* const items = open_.back()->get_ptr<Json::array_t*>())
            return &items->emplace_back(std::move(value));
        auto& properties = *open_.back()->get_ptr<Json::object_t*>();
        return &properties.emplace_back(std::move(key_), std::move(value)).second;
    }

    std::string_view where_;
    JsonLimits limits_;
    Json root_;
    std::vector<Json*> open_;  ///< open values, from the root to the innermost
    std::string key_;          ///< key of the next property
    std::size_t values_ = 0;
    std::optional<Error> error_;
};

}  // namespace

Result<Json> readCbor(std::string_view bytes, std::string_view where, const JsonLimits& limits) {
    if (bytes.size() > limits.bytes) {
        return Error{std::string{where},
                     format("the file has {} bytes, the limit is {}", bytes.size(), limits.bytes),
                     "split it"};
    }
    LimitedBuilder builder{where, limits};
    const bool parsed = Json::sax_parse(bytes.begin(), bytes.end(), &builder, Json::input_format_t::cbor);
    return builder.take(parsed);
}

std::string writeCbor(const Json& json) {
    std::string out;
    Json::to_cbor(json, out);
    return out;
}

}  // namespace plumb
