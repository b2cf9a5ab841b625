#pragma once

namespace plumb {

/// log10(x), the same bits on every machine; |error| <= 1e-6. -45 for what has no logarithm: 0, below it,
/// NaN.
float logarithm10(float x);

}  // namespace plumb
