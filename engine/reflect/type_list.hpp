#pragma once

namespace plumb {

/// Several types, in an order.
template <class... T>
struct TypeList {};

}  // namespace plumb
