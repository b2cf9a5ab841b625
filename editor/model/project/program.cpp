#include "editor/model/project/program.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <optional>
#include <thread>

#include "core/text.hpp"

#if defined(_WIN32)
#include <process.h>
#else
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;  // NOLINT(readability-redundant-declaration): not every system's headers declare it
#endif

namespace plumb::editor {
namespace {

Error cannotStart(const std::vector<std::string>& words, int code) {
    return Error{words.empty() ? std::string{"program"} : words.front(),
                 format("it cannot be started: {}", std::strerror(code)),
                 "check its name, and that it is installed"};
}

/// The words as a null-terminated list, as systems expect it.
std::vector<char*> listOf(const std::vector<std::string>& words) {
    std::vector<char*> list;
    for (const std::string& word : words) list.push_back(const_cast<char*>(word.c_str()));
    list.push_back(nullptr);
    return list;
}

#if defined(_WIN32)

std::string quoted(const std::string& word) { return format("\"{}\"", word); }

#else

constexpr int kPatience = 100;  // ms between looks at a stop token

enum class Session : unsigned char { Shared, Own };

/// @param output  file that receives both outputs; none: those of this program are used
/// @return 0, or the number of the error
int spawn(const std::vector<std::string>& words, std::optional<int> output, Session session, pid_t& child) {
    if (words.empty()) return ENOENT;
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    if (session == Session::Own) posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (output) {
        posix_spawn_file_actions_adddup2(&actions, *output, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, *output, STDERR_FILENO);
    }
    std::vector<char*> list = listOf(words);
    const int failed = posix_spawnp(&child, list.front(), &actions, &attributes, list.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    return failed;
}

#endif

}  // namespace

ProgramEnd runProgram(const std::vector<std::string>& words) {
    return runProgram(words, [](std::string_view) {}, {});
}

#if defined(_WIN32)

ProgramEnd runProgram(const std::vector<std::string>& words,
                      const std::function<void(std::string_view)>& heard, const std::stop_token&) {
    ProgramEnd end;
    std::string command;
    for (const std::string& word : words) command += quoted(word) + " ";
    std::FILE* pipe = _popen((command + "2>&1").c_str(), "r");
    if (pipe == nullptr) return end;
    std::array<char, 4096> part{};
    while (std::fgets(part.data(), static_cast<int>(part.size()), pipe) != nullptr) {
        heard(part.data());
        end.text += part.data();
    }
    end.succeeded = _pclose(pipe) == 0;
    return end;
}

Result<Done> startProgram(const std::vector<std::string>& words) {
    std::vector<std::string> safe;
    for (const std::string& word : words) safe.push_back(safe.empty() ? word : quoted(word));
    if (words.empty()) return cannotStart(words, ENOENT);
    if (_spawnvp(_P_NOWAIT, words.front().c_str(), listOf(safe).data()) == -1)
        return cannotStart(words, errno);
    return Done{};
}

#else

ProgramEnd runProgram(const std::vector<std::string>& words,
                      const std::function<void(std::string_view)>& heard, const std::stop_token& stop) {
    ProgramEnd end;
    std::array<int, 2> pipe{};
    if (::pipe(pipe.data()) != 0) return end;
    for (const int side : pipe) fcntl(side, F_SETFD, FD_CLOEXEC);  // other children must not hold it open
    pid_t child = 0;
    const Session session = stop.stop_possible() ? Session::Own : Session::Shared;
    const int failed = spawn(words, pipe[1], session, child);
    close(pipe[1]);
    if (failed != 0) {
        close(pipe[0]);
        end.text = cannotStart(words, failed).text();
        return end;
    }
    std::array<char, 4096> part{};
    pollfd readable{pipe[0], POLLIN, 0};
    while (!stop.stop_requested()) {
        if (poll(&readable, 1, session == Session::Own ? kPatience : -1) <= 0) continue;
        const ssize_t size = read(pipe[0], part.data(), part.size());
        if (size == 0 || (size < 0 && errno != EINTR)) break;
        const std::string_view text{part.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
        if (!text.empty()) heard(text);
        end.text += text;
    }
    close(pipe[0]);
    if (stop.stop_requested()) kill(-child, SIGTERM);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    end.succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return end;
}

Result<Done> startProgram(const std::vector<std::string>& words) {
    pid_t child = 0;
    if (const int failed = spawn(words, std::nullopt, Session::Shared, child); failed != 0)
        return cannotStart(words, failed);
    std::thread{[child] { waitpid(child, nullptr, 0); }}.detach();  // else it stays in the table of processes
    return Done{};
}

#endif

}  // namespace plumb::editor
