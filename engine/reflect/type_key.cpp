#include "reflect/type_key.hpp"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/assert.hpp"
#include "reflect/type_name.hpp"

namespace plumb {

TypeKey nextTypeKey() {
    static TypeKey next = 0;
    if (next == kMaxTypes)
        failAssertion("more component, event and resource types are used than kMaxTypes", __FILE__, __LINE__);
    return next++;
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

    TypeKey add() {
        const TypeKey key = nextTypeKey();
        keys[key] = true;
        return key;
    }
    TypeKey nextOf(UnnamedTypes& types) {
        if (types.used == types.keys.size()) types.keys.push_back(add());
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
    if (isInUnnamedNamespace(name)) return types.nextOf(types.unnamed[std::string{name}]);
    const auto found = types.byName.find(name);
    return found != types.byName.end() ? found->second
                                       : types.byName.emplace(name, types.add()).first->second;
}

void beginReloadableTypes() {
    for (auto& [name, types] : reloadableTypes().unnamed) types.used = 0;
}

bool isReloadable(TypeKey key) { return reloadableTypes().keys[key]; }

}  // namespace plumb
