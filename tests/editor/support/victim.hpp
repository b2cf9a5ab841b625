#pragma once

#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <functional>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "core/clock.hpp"
#include "core/file.hpp"

namespace plumb::test {

/// A record that the child process writes about its state.
struct Report {
    double time = 0.0;       ///< s, clock shared by all processes
    std::uint64_t deed = 0;  ///< number of actions performed
    std::uint64_t scene = 0;
    std::uint64_t text = 0;  ///< hash of the scene's text
    std::uint64_t unsaved = 0;
};

/// A forked child process that can be killed at any moment. Its records up to then can be read from a file.
/// @pre this process has no other threads
class Victim {
public:
    using Tell = std::function<void(Report)>;

    /// @param life  work of the child process; it may run forever
    Victim(Path reports, const std::function<void(const Tell&)>& life) : reports_{std::move(reports)} {
        std::filesystem::remove(reports_);
        child_ = ::fork();
        if (child_ != 0) return;
        const int file = ::open(reports_.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0644);
        life([file](Report report) {
            report.time = wallSeconds();
            if (::write(file, &report, sizeof report) != sizeof report) ::_exit(2);
        });
        ::_exit(0);
    }
    ~Victim() { kill(); }
    Victim(const Victim&) = delete;
    Victim& operator=(const Victim&) = delete;

    /// Waits until the child has written `reports` records and then for `seconds` more.
    /// @return false if the child ended by itself
    bool live(std::size_t reports, double seconds) {
        while (count() < reports) {
            if (::waitpid(child_, nullptr, WNOHANG) == child_) return child_ = 0, false;
            ::usleep(200);
        }
        ::usleep(static_cast<unsigned>(seconds * 1e6));
        return true;
    }
    void kill() {
        if (child_ <= 0) return;
        ::kill(child_, SIGKILL);
        ::waitpid(child_, nullptr, 0);
        child_ = 0;
    }
    [[nodiscard]] std::vector<Report> reports() const {
        const Result<std::string> bytes = readFile(reports_);
        std::vector<Report> all(bytes ? bytes->size() / sizeof(Report) : 0);
        if (!all.empty()) std::memcpy(all.data(), bytes->data(), all.size() * sizeof(Report));
        return all;
    }

private:
    [[nodiscard]] std::size_t count() const {
        std::error_code failed;
        const std::uintmax_t size = std::filesystem::file_size(reports_, failed);
        return failed ? 0 : static_cast<std::size_t>(size) / sizeof(Report);
    }

    Path reports_;
    pid_t child_ = 0;
};

}  // namespace plumb::test
