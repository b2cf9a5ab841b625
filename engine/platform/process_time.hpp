#pragma once

namespace plumb {

/// Seconds since the system started this program, so that what comes before main() counts too; to a hundredth
/// on Linux. Where the system does not say, seconds since the first call. For logs and measurements only.
double processSeconds();

}  // namespace plumb
