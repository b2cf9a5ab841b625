#include "core/os.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace plumb::os {

std::FILE* openFile(const std::filesystem::path& path, const char* mode) {
    return std::fopen(path.c_str(), mode);
}

bool seek(std::FILE* file, std::uint64_t offset) {
    return ::fseeko(file, static_cast<off_t>(offset), SEEK_SET) == 0;
}

bool flushToDisk(std::FILE* file) { return std::fflush(file) == 0; }

void flushFolder(const std::filesystem::path&) {}  // in memory; the page keeps the files, see store.js

int lockFile(const std::filesystem::path&) { return 0; }  // a page shares its files with no other process
void unlockFile(int) {}

bool findUserFolder() { return true; }

bool reservingIsFree() { return false; }

std::size_t memoryStep() { return 64; }

void* reserveMemory(std::size_t bytes) { return std::calloc(bytes, 1); }

void releaseMemory(void* start, std::size_t) { std::free(start); }

bool commitMemory(void*, std::size_t) { return true; }

std::size_t addressLimit() { return std::numeric_limits<std::size_t>::max(); }

double processAge() { return 0.0; }

bool hasThreads() { return false; }  // they would need two headers from the server of the page

std::vector<std::string> arguments(int count, const char* const* words) {
    return {words + std::min(count, 1), words + count};
}

}  // namespace plumb::os
