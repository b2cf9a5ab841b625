#include "reflect/cbor.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/text.hpp"
#include "reflect/json.hpp"

namespace plumb {
namespace {

// The major types, in the top three bits of a value's first byte.
enum class Major : std::uint8_t { Unsigned, Negative, Bytes, Text, Array, Map, Tag, Simple };

constexpr std::uint8_t kFalse = 20, kTrue = 21, kNull = 22, kHalf = 25, kFloat = 26, kDouble = 27;

class CborReader {
public:
    CborReader(std::string_view bytes, std::string_view where, const JsonLimits& limits)
        : bytes_{bytes}, where_{where}, limits_{limits} {}

    Result<Json> read() {
        Json json;
        if (bytes_.size() > limits_.bytes) {
            fail(format("the file has {} bytes, the limit is {}", bytes_.size(), limits_.bytes), "split it");
            return *std::move(error_);
        }
        if (!readValue(json, 0)) return *std::move(error_);
        if (at_ != bytes_.size()) {
            fail("bytes follow after the last value", "save the file again");
            return *std::move(error_);
        }
        return json;
    }

private:
    bool fail(std::string what, std::string remedy) {
        error_ = Error{format("{}: byte {}", where_, at_), std::move(what), std::move(remedy)};
        return false;
    }
    bool failShort() { return fail("the file ends in the middle of a value", "save or copy it again"); }

    bool readBigEndian(std::size_t count, std::uint64_t& number) {
        if (bytes_.size() - at_ < count) return failShort();
        number = 0;
        for (std::size_t i = 0; i < count; ++i) {
            number = number << 8 | static_cast<unsigned char>(bytes_[at_++]);
        }
        return true;
    }

    bool readArgument(std::uint8_t info, std::uint64_t& number) {
        if (info < 24) return number = info, true;
        if (info > 27) return fail("a form of CBOR that no scene uses", "save the file again");
        return readBigEndian(std::size_t{1} << (info - 24), number);
    }

    bool readValue(Json& json, int depth) {
        if (at_ >= bytes_.size()) return failShort();
        if (++values_ > limits_.values)
            return fail(format("more than {} values", limits_.values), "split the file");
        const auto first = static_cast<unsigned char>(bytes_[at_++]);
        const auto major = static_cast<Major>(first >> 5);
        const auto info = static_cast<std::uint8_t>(first & 31);
        std::uint64_t number = 0;
        if (major == Major::Simple) return readSimple(json, info);
        if (!readArgument(info, number)) return false;
        switch (major) {
            case Major::Unsigned: return json = number, true;
            case Major::Negative:
                if (number > 0x7fffffffffffffffu) return fail("a number too small", "save the file again");
                return json = -1 - static_cast<std::int64_t>(number), true;
            case Major::Text: {
                json = std::string{};
                return readText(*json.get_ptr<std::string*>(), number);
            }
            case Major::Array: return enter(depth, number) && readArray(json, number, depth + 1);
            case Major::Map: return enter(depth, number) && readMap(json, number, depth + 1);
            default: return fail("raw bytes or a tag, which no scene uses", "save the file again");
        }
    }

    bool readSimple(Json& json, std::uint8_t info) {
        std::uint64_t bits = 0;
        switch (info) {
            case kFalse: return json = false, true;
            case kTrue: return json = true, true;
            case kNull: return json = nullptr, true;
            case kFloat:
                if (!readBigEndian(4, bits)) return false;
                return json = double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))}, true;
            case kDouble:
                if (!readBigEndian(8, bits)) return false;
                return json = std::bit_cast<double>(bits), true;
            case kHalf:
            default: return fail("a simple value that no scene uses", "save the file again");
        }
    }

    bool enter(int depth, std::uint64_t count) {
        if (depth >= limits_.depth) {
            return fail(format("nested deeper than {} levels", limits_.depth), "flatten the file");
        }
        // Each item takes at least one byte: a larger count is invalid and must not reserve memory.
        return count <= bytes_.size() - at_ || failShort();
    }

    bool readText(std::string& out, std::uint64_t size) {
        if (size > bytes_.size() - at_) return failShort();
        if (size > limits_.textBytes) {
            return fail(format("a text longer than {} bytes", limits_.textBytes), "shorten it");
        }
        out.assign(bytes_.substr(at_, static_cast<std::size_t>(size)));
        if (!isUtf8(out)) return fail("a text is not UTF-8", "save the file again");
        at_ += out.size();
        return true;
    }

    bool readArray(Json& json, std::uint64_t count, int depth) {
        json = Json::array();
        auto& items = *json.get_ptr<Json::array_t*>();
        for (std::uint64_t i = 0; i < count; ++i) {
            if (!readValue(items.emplace_back(), depth)) return false;
        }
        return true;
    }

    bool readMap(Json& json, std::uint64_t count, int depth) {
        json = Json::object();
        auto& properties = *json.get_ptr<Json::object_t*>();
        for (std::uint64_t i = 0; i < count; ++i) {
            Json key;
            Json value;
            if (!readValue(key, depth) || !readValue(value, depth)) return false;
            if (!key.is_string()) return fail("a key that is no text", "save the file again");
            properties.emplace_back(*key.get_ptr<std::string*>(), std::move(value));
        }
        return true;
    }

    std::string_view bytes_;
    std::string_view where_;
    JsonLimits limits_;
    std::size_t at_ = 0;
    std::size_t values_ = 0;
    std::optional<Error> error_;
};

void put(std::string& out, std::uint64_t number, int bytes) {
    for (int shift = (bytes - 1) * 8; shift >= 0; shift -= 8) {
        out += static_cast<char>(static_cast<unsigned char>(number >> shift));
    }
}

void putHead(std::string& out, Major major, std::uint64_t number) {
    const int form = number < 24             ? -1
                     : number < 0x100        ? 0
                     : number < 0x10000      ? 1
                     : number < 0x100000000u ? 2
                                             : 3;
    const std::uint64_t info = form < 0 ? number : static_cast<std::uint64_t>(24 + form);
    out += static_cast<char>(static_cast<unsigned char>(static_cast<unsigned>(major) << 5 | info));
    if (form >= 0) put(out, number, 1 << form);
}

void putReal(std::string& out, double value) {
    const auto narrow = static_cast<float>(value);
    const bool fits = std::isfinite(value) && double{narrow} == value;
    out += static_cast<char>(static_cast<unsigned char>(7 << 5 | (fits ? kFloat : kDouble)));
    if (fits) {
        put(out, std::bit_cast<std::uint32_t>(narrow), 4);
    } else {
        put(out, std::bit_cast<std::uint64_t>(value), 8);
    }
}

void putText(std::string& out, std::string_view text) {
    putHead(out, Major::Text, text.size());
    out += text;
}

void putValue(std::string& out, const Json& json) {
    const auto simple = [&out](std::uint8_t which) {
        out += static_cast<char>(static_cast<unsigned char>(7 << 5 | which));
    };
    switch (json.type()) {
        case Json::value_t::boolean: simple(json.get<bool>() ? kTrue : kFalse); break;
        case Json::value_t::number_integer: {
            const auto number = json.get<std::int64_t>();
            number < 0 ? putHead(out, Major::Negative, static_cast<std::uint64_t>(-1 - number))
                       : putHead(out, Major::Unsigned, static_cast<std::uint64_t>(number));
            break;
        }
        case Json::value_t::number_unsigned: putHead(out, Major::Unsigned, json.get<std::uint64_t>()); break;
        case Json::value_t::number_float: putReal(out, json.get<double>()); break;
        case Json::value_t::string: putText(out, *json.get_ptr<const std::string*>()); break;
        case Json::value_t::array:
            putHead(out, Major::Array, json.size());
            for (const Json& item : json) putValue(out, item);
            break;
        case Json::value_t::object:
            putHead(out, Major::Map, json.size());
            for (const auto& [key, value] : *json.get_ptr<const Json::object_t*>()) {
                putText(out, key);
                putValue(out, value);
            }
            break;
        case Json::value_t::null:
        case Json::value_t::binary:
        case Json::value_t::discarded: simple(kNull); break;
    }
}

}  // namespace

Result<Json> readCbor(std::string_view bytes, std::string_view where, const JsonLimits& limits) {
    return CborReader{bytes, where, limits}.read();
}

std::string writeCbor(const Json& json) {
    std::string out;
    putValue(out, json);
    return out;
}

}  // namespace plumb
