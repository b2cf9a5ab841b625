#include "editor/model/assets/renamed_fields.hpp"

#include <algorithm>

#include "reflect/json.hpp"
#include "reflect/json_members.hpp"

namespace plumb::editor {
namespace {

/// Iterates over the string values of a JSON text, with the object keys on the path to each.
class Walker {
public:
    explicit Walker(std::string_view json) : json_{json} {}

    /// Finds the next string value: its range without quotes. Returns false at the end.
    bool next(std::size_t& from, std::size_t& to) {
        for (; at_ < json_.size(); ++at_) {
            switch (json_[at_]) {
                case '{':
                case '[': open_.push_back({json_[at_] == '{', json_[at_] == '{', {}}); break;
                case '}':
                case ']':
                    if (!open_.empty()) open_.pop_back();
                    break;
                case ',':
                    if (!open_.empty()) open_.back().expectsKey = open_.back().object;
                    break;
                case '"':
                    from = at_ + 1;
                    to = at_ = endOfText(from);
                    if (open_.empty() || !open_.back().expectsKey) return ++at_, true;
                    open_.back().key = json_.substr(from, to - from);
                    open_.back().expectsKey = false;
                    break;
                default: break;
            }
        }
        return false;
    }
    /// Returns a key on the path to the value. @param up  0: its own key, 1: that of the enclosing object
    [[nodiscard]] std::string_view key(std::size_t up) const {
        return up < open_.size() ? open_[open_.size() - 1 - up].key : std::string_view{};
    }

private:
    struct Around {
        bool object = false;
        bool expectsKey = false;
        std::string_view key;
    };

    [[nodiscard]] std::size_t endOfText(std::size_t at) const {
        for (; at < json_.size() && json_[at] != '"'; ++at) {
            if (json_[at] == '\\') ++at;
        }
        return std::min(at, json_.size());
    }

    std::string_view json_;
    std::size_t at_ = 0;
    std::vector<Around> open_;
};

std::string quoted(std::string_view text) {
    const std::string json = compactText(Json(text));
    return json.substr(1, json.size() - 2);
}

}  // namespace

std::vector<NamingField> namingFields(const TypeRegistry& types, std::string_view name) {
    std::vector<NamingField> found;
    for (const TypeInfo& type : types.all()) {
        const FieldInfo* field = type.find(name);
        if (field != nullptr && field->kind == FieldKind::Text) found.push_back({&type, field});
    }
    return found;
}

std::string withRenamedFields(std::string_view json, const std::vector<NamingField>& fields,
                              std::string_view from, std::string_view to, int& times) {
    const std::string wanted = quoted(from);
    const std::string next = quoted(to);
    std::string result;
    std::size_t copied = 0;
    Walker walker{json};
    for (std::size_t begin = 0, end = 0; walker.next(begin, end);) {
        if (json.substr(begin, end - begin) != wanted || walker.key(2) != "components") continue;
        const bool names = std::any_of(fields.begin(), fields.end(), [&](const NamingField& one) {
            return walker.key(0) == one.field->name && walker.key(1) == one.type->name;
        });
        if (!names) continue;
        result.append(json.substr(copied, begin - copied)).append(next);
        copied = end;
        ++times;
    }
    result.append(json.substr(copied));
    return result;
}

}  // namespace plumb::editor
