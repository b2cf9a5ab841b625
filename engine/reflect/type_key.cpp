#include "reflect/type_key.hpp"

namespace plumb {

TypeKey nextTypeKey() {
    static TypeKey next = 0;
    return next++;
}

}  // namespace plumb
