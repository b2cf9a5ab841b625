#pragma once

namespace plumb {

/// log10(x), the same bits on every machine; |error| <= 2e-6, half of a float's last bit near 38.
/// -45 for values without a logarithm: 0, negative numbers, NaN.
float logarithm10(float x);

}  // namespace plumb
