#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

/// What differs between operating systems. Each of the folders `posix`, `windows` and `web` implements all of
/// it; engine/cmake/house.cmake chooses the folder.
namespace plumb::os {

// ---- files

/// Like std::fopen(), for paths with any characters.
std::FILE* openFile(const std::filesystem::path& path, const char* mode);
/// Moves to a byte of the file, counted from its start, also beyond 2 GiB. Returns false if that is
/// impossible.
bool seek(std::FILE* file, std::uint64_t offset);
/// Waits until everything written to the file is on the disk. Returns false if that is impossible.
bool flushToDisk(std::FILE* file);
/// Makes a rename in this folder durable. Best effort: some file systems do not support it.
void flushFolder(const std::filesystem::path& folder);

/// Opens or creates a file and locks it. Returns -1 if another process holds the lock, or without permission.
int lockFile(const std::filesystem::path& path);
void unlockFile(int handle);

/// Prepares the environment for a library that asks it for the folder of the user's files. Returns false if
/// the system does not say where they are.
bool findUserFolder();

// ---- memory

/// True if reserving address space takes no memory. Otherwise worlds reserve less.
[[nodiscard]] bool reservingIsFree();
/// Bytes to which the parts of a reservation are best aligned: a huge page if reservingIsFree(), else a cache
/// line.
[[nodiscard]] std::size_t memoryStep();
/// Reserves zeroed memory; null if there is not enough. Pages are allocated when they are first used where
/// reservingIsFree(), at once elsewhere.
void* reserveMemory(std::size_t bytes);
void releaseMemory(void* start, std::size_t bytes);
/// Makes a part of reserved memory usable. Returns false if there is not enough memory.
bool commitMemory(void* start, std::size_t bytes);
/// Bytes of address space that this process may reserve (`ulimit -v`); SIZE_MAX if unlimited.
[[nodiscard]] std::size_t addressLimit();

// ---- processes and threads

/// Seconds since the start of the process; 0 if it is unknown.
[[nodiscard]] double processAge();
/// False where programs cannot start threads.
[[nodiscard]] bool hasThreads();
/// The arguments of main() as UTF-8, without the name of the program.
std::vector<std::string> arguments(int count, const char* const* words);

}  // namespace plumb::os
