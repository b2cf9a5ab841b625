#include "reflect/type_check.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <string>

#include "core/text.hpp"

namespace plumb {
namespace {

/// Collects the mistakes of one type.
class TypeCheck {
public:
    explicit TypeCheck(const TypeInfo& type) : type_{type} {}

    std::vector<Error> run() {
        if (type_.name.empty()) add({}, "the description has no name", R"(begin it with type.name("..."))");
        for (std::size_t i = 0; i < type_.fields.size(); ++i) {
            const FieldInfo& field = type_.fields[i];
            for (std::size_t k = 0; k < i; ++k) compare(type_.fields[k], field);
            checkNames(field);
            checkRange(field);
        }
        return std::move(mistakes_);
    }

private:
    void add(std::string_view field, std::string what, std::string remedy) {
        std::string where = format("component \"{}\"", type_.name.empty() ? type_.cppName : type_.name);
        if (!field.empty()) where += format(", field \"{}\"", field);
        mistakes_.push_back({std::move(where), std::move(what), std::move(remedy)});
    }

    void compare(const FieldInfo& first, const FieldInfo& second) {
        if (first.name == second.name)
            add(second.name, "there are two fields of this name", "give one of them another name");
        if (first.offset == second.offset)
            add(second.name, format("its member is that of the field \"{}\" already", first.name),
                "name another member in field<&...>, or remove one of the two fields");
        if (!second.was.empty() && first.was == second.was)
            add(second.name, format("its former name \"{}\" is also that of \"{}\"", second.was, first.name),
                "remove one of the two .was(...)");
    }

    void checkNames(const FieldInfo& field) {
        if (field.name.empty())
            add(format("at byte {}", field.offset), "it has no name", R"(write field<&...>("name"))");
        if (!field.was.empty() && type_.find(field.was) != nullptr)
            add(field.name, format("its former name \"{}\" is the present name of a field", field.was),
                "remove .was(...), or rename the other field");
        if (!field.shownIf.empty() && type_.find(field.shownIf) == nullptr)
            add(field.name, format("shownIf names \"{}\", which is no field", field.shownIf),
                "name a bool or an enum of this component");
        if (field.kind == FieldKind::Enum && field.names.empty())
            add(field.name, "the enum has no names", R"(add .names({{"first", 0}, ...}))");
    }

    void checkRange(const FieldInfo& field) {
        if (!(field.min <= field.max)) {
            add(field.name, format("its range is from {} to {}", field.min, field.max),
                "write the smaller number first");
            return;
        }
        const std::optional<double> value = defaultOf(field);
        const bool isLimited =
            field.min > std::numeric_limits<float>::lowest() || field.max < std::numeric_limits<float>::max();
        if (value && isLimited && !(*value >= double{field.min} && *value <= double{field.max}))
            add(field.name,
                format("its default {} is outside of its range from {} to {}", *value, field.min, field.max),
                "change the initial value of the member, or the range");
    }

    /// The default of a number; nothing for other kinds.
    [[nodiscard]] std::optional<double> defaultOf(const FieldInfo& field) const {
        if (type_.defaults.size() < field.offset + field.size) return std::nullopt;
        const std::byte* at = type_.defaults.data() + field.offset;
        if (field.kind == FieldKind::Float) {
            float value = 0.0f;
            std::memcpy(&value, at, sizeof value);
            return double{value};
        }
        if (field.kind != FieldKind::Int) return std::nullopt;
        std::int64_t value = 0;  // little-endian, as all machines that the engine supports
        std::memcpy(&value, at, field.size);
        const bool isNegative = field.isSigned && field.size < 8 && (value >> (8 * field.size - 1)) != 0;
        if (isNegative) value -= std::int64_t{1} << (8 * field.size);
        return !field.isSigned && value < 0 ? static_cast<double>(static_cast<std::uint64_t>(value))
                                            : static_cast<double>(value);
    }

    const TypeInfo& type_;
    std::vector<Error> mistakes_;
};

}  // namespace

std::vector<Error> mistakesOf(const TypeInfo& type) { return TypeCheck{type}.run(); }

}  // namespace plumb
