#pragma once

namespace plumb {

/// Seconds since the system started this program, including the time before main(); accurate to 0.01 s
/// on Linux. If that time is unknown, seconds since the first call. For logs and measurements only.
double processSeconds();

}  // namespace plumb
