#include "core/crash.hpp"

#include <unistd.h>

#include "core/crash_report.hpp"

namespace plumb {

constinit thread_local std::string_view Running::current;

// The page reports crashes; there is no file.

void reportCrashes(std::string_view) {}
void reportHang() {}
bool canReportCrashes() { return false; }

std::string buildId() { return {}; }

namespace crash {

int createFile(const Path::value_type*) { return -1; }
bool exists(const Path::value_type*) { return false; }
void closeFile(int) {}
bool renameFile(const Path::value_type*, const Path::value_type*) { return false; }
void removeFile(const Path::value_type*) {}
std::int64_t writeSome(int file, const char* bytes, std::size_t count) { return ::write(file, bytes, count); }
Date now() { return {}; }

}  // namespace crash
}  // namespace plumb
