#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <unistd.h>

namespace plumb::bench {

/// Reads the instruction counts of callgrind: one for each call of the measured function, in order.
class CallgrindCounts {
public:
    explicit CallgrindCounts(std::filesystem::path folder) : folder_{std::move(folder)} {}

    /// Returns the number of instructions of the next call; 0 if there is none.
    double next() {
        std::ifstream file{folder_ / ("count." + std::to_string(++dump_))};
        for (std::string word; file >> word;) {
            if (word == "totals:" || word == "summary:") {
                double count = 0.0;
                file >> count;
                if (count > 0.0) return count;
            }
        }
        return 0.0;
    }

private:
    std::filesystem::path folder_;
    int dump_ = 0;
};

/// Runs "PROGRAM RUN" under callgrind, which resets its counters before and writes them to a file after each
/// call of `function`.
/// @param function  must have C linkage and not be inlined, so that callgrind finds its name
/// @param print     takes CallgrindCounts&, prints the results, returns an exit code
/// @return          that exit code; 77, as for a skipped test, if valgrind is not installed; 1 if it failed
template <class Print>
int countInstructions(const char* program, std::string_view function, bool quick, Print print,
                      const std::string& run = "counted") {
    if (std::system("valgrind --version > /dev/null 2>&1") != 0) {
        std::printf("valgrind is not installed: instructions are not counted\n");
        return 77;
    }
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("plumb_callgrind_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const std::string name{function};
    const std::string command = "valgrind --tool=callgrind --zero-before='" + name + "' --dump-after='" +
                                name + "' --callgrind-out-file='" + (folder / "count").string() + "' '" +
                                program + "' " + run + (quick ? " --quick" : "") + " > /dev/null 2>&1";
    int result = 1;
    if (std::system(command.c_str()) == 0) {
        CallgrindCounts counts{folder};
        result = print(counts);
    } else {
        std::printf("callgrind failed\n");
    }
    std::filesystem::remove_all(folder);
    return result;
}

/// Command line "[WHAT] [--quick]" of the benchmarks that count instructions with callgrind.
struct CountedWords {
    std::string_view what;
    bool quick = false;

    CountedWords(int count, char** arguments) {
        for (int i = 1; i < count; ++i) {
            const std::string_view word = arguments[i];
            if (word == "--quick") {
                quick = true;
            } else {
                what = word;
            }
        }
    }
};

}  // namespace plumb::bench
