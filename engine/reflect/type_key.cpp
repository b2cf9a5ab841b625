#include "reflect/type_key.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/assert.hpp"
#include "reflect/type_name.hpp"

namespace plumb {

namespace {

std::deque<std::string>& typeNames() {  // indexed by key; a deque, because views of its texts are returned
    static std::deque<std::string> names;
    return names;
}

}  // namespace

TypeKey nextTypeKey(std::string_view name) {
    std::deque<std::string>& names = typeNames();
    if (names.size() == kMaxTypes)
        failAssertion("more component, event and resource types are used than kMaxTypes", __FILE__, __LINE__);
    names.emplace_back(name);
    return static_cast<TypeKey>(names.size() - 1);
}

std::string_view typeNameOf(TypeKey key) {
    return key < typeNames().size() ? std::string_view{typeNames()[key]} : std::string_view{};
}

TypeKey findTypeKey(std::string_view name) {
    const std::deque<std::string>& names = typeNames();
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? kMaxTypes : static_cast<TypeKey>(found - names.begin());
}

namespace {

/// Keys of types of one name in unnamed namespaces.
struct UnnamedTypes {
    std::vector<TypeKey> keys;
    std::size_t used = 0;  // by the version of the code that was loaded last
};

struct ReloadableTypes {
    std::map<std::string, TypeKey, std::less<>> byName;
    std::map<std::string, UnnamedTypes, std::less<>> unnamed;
    std::array<bool, kMaxTypes> keys{};
    std::uint32_t version = 0;

    TypeKey add(std::string_view name) {
        const TypeKey key = nextTypeKey(name);
        keys[key] = true;
        return key;
    }
    TypeKey nextOf(std::string_view name) {
        UnnamedTypes& types = unnamed[std::string{name}];
        if (types.used == types.keys.size()) types.keys.push_back(add(name));
        return types.keys[types.used++];
    }
};

ReloadableTypes& reloadableTypes() {
    static ReloadableTypes types;
    return types;
}

}  // namespace

TypeKey reloadableTypeKey(std::string_view name) {
    ReloadableTypes& types = reloadableTypes();
    if (isInUnnamedNamespace(name)) return types.nextOf(name);
    const auto found = types.byName.find(name);
    return found != types.byName.end() ? found->second
                                       : types.byName.emplace(name, types.add(name)).first->second;
}

void beginReloadableTypes() {
    ++reloadableTypes().version;
    for (auto& [name, types] : reloadableTypes().unnamed) types.used = 0;
}

std::uint32_t reloadableVersion() { return reloadableTypes().version; }

bool isReloadable(TypeKey key) { return reloadableTypes().keys[key]; }

}  // namespace plumb
