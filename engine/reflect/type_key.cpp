#include "reflect/type_key.hpp"

#include "core/assert.hpp"

namespace plumb {

TypeKey nextTypeKey() {
    static TypeKey next = 0;
    if (next == kMaxTypes)
        failAssertion("a program uses more component, event and resource types than kMaxTypes", __FILE__,
                      __LINE__);
    return next++;
}

}  // namespace plumb
