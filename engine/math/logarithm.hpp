#pragma once

namespace plumb {

/// log10(x), the same bits on every machine; |error| <= 1e-6.
/// -45 for values without a logarithm: 0, negative numbers, NaN.
float logarithm10(float x);

}  // namespace plumb
