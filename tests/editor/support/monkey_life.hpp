#pragma once

#include <fstream>
#include <functional>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "core/clock.hpp"
#include "core/text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::test {

/// Runs numbered actions in a child process. After a crash of the child, the parent can report the actions
/// that led to it and search for the shortest sequence that still crashes.
class Lives {
public:
    using Tell = std::function<void(const std::string& line)>;  ///< adds a line to report()
    /// Performs the actions with these numbers. @return the failure; empty on success
    using Life = std::function<std::string(const std::vector<std::uint64_t>& numbers, const Tell& tell)>;

    explicit Lives(Life life) : life_{std::move(life)} {}

    /// Runs the actions in a child process. @return the failure or how the process ended; empty on success
    std::string live(const std::vector<std::uint64_t>& numbers) {
        std::filesystem::remove(folder_.path / "wrong");
        std::fflush(nullptr);
        const pid_t child = ::fork();
        if (child == 0) {
            std::ofstream report{folder_.path / "report"};
            const std::string wrong =
                life_(numbers, [&](const std::string& line) { report << line << std::endl; });
            if (!wrong.empty()) std::ofstream{folder_.path / "wrong"} << wrong;
            std::fflush(nullptr);
            ::_exit(wrong.empty() ? 0 : 1);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
        std::ifstream file{folder_.path / "wrong"};
        const std::string wrong{std::istreambuf_iterator<char>{file}, {}};
        if (!wrong.empty()) return wrong;
        return WIFSIGNALED(status) ? format("killed by signal {}", WTERMSIG(status))
                                   : format("ended with {}", WEXITSTATUS(status));
    }
    /// Returns the lines that the last child process reported, in order.
    [[nodiscard]] std::vector<std::string> report() const {
        std::vector<std::string> lines;
        std::ifstream file{folder_.path / "report"};
        for (std::string line; std::getline(file, line);) lines.push_back(line);
        return lines;
    }
    /// Returns the shortest sequence found that still fails: removes halves first, then smaller and smaller
    /// pieces, for at most `seconds`.
    std::vector<std::uint64_t> shortest(std::vector<std::uint64_t> numbers, double seconds) {
        const double end = wallSeconds() + seconds;
        for (std::size_t piece = (numbers.size() + 1) / 2; piece > 0; piece /= 2) {
            for (std::size_t at = 0; at < numbers.size() && wallSeconds() < end;) {
                std::vector<std::uint64_t> rest = numbers;
                const auto from = rest.begin() + static_cast<std::ptrdiff_t>(at);
                rest.erase(from, from + static_cast<std::ptrdiff_t>(std::min(piece, rest.size() - at)));
                if (live(rest).empty()) {
                    at += piece;
                } else {
                    numbers = std::move(rest);
                }
            }
        }
        return numbers;
    }

private:
    Life life_;
    TemporaryFolder folder_;
};

}  // namespace plumb::test
