#include "reflect/type_key.hpp"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>

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

struct ReloadableTypes {
    std::map<std::string, TypeKey, std::less<>> byName;
    std::array<bool, kMaxTypes> keys{};

    TypeKey add() {
        const TypeKey key = nextTypeKey();
        keys[key] = true;
        return key;
    }
};

ReloadableTypes& reloadableTypes() {
    static ReloadableTypes types;
    return types;
}

}  // namespace

TypeKey reloadableTypeKey(std::string_view name) {
    ReloadableTypes& types = reloadableTypes();
    if (isInUnnamedNamespace(name)) return types.add();
    const auto found = types.byName.find(name);
    return found != types.byName.end() ? found->second
                                       : types.byName.emplace(name, types.add()).first->second;
}

bool isReloadable(TypeKey key) { return reloadableTypes().keys[key]; }

}  // namespace plumb
