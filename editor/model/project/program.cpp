#include "editor/model/project/program.hpp"

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

/// @param output  file that receives both outputs; none: those of this program are used
/// @return 0, or the number of the error
int spawn(const std::vector<std::string>& words, std::optional<int> output, pid_t& child) {
    if (words.empty()) return ENOENT;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (output) {
        posix_spawn_file_actions_adddup2(&actions, *output, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, *output, STDERR_FILENO);
    }
    std::vector<char*> list = listOf(words);
    const int failed = posix_spawnp(&child, list.front(), &actions, nullptr, list.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failed;
}

#endif

}  // namespace

#if defined(_WIN32)

ProgramEnd runProgram(const std::vector<std::string>& words) {
    ProgramEnd end;
    std::string command;
    for (const std::string& word : words) command += quoted(word) + " ";
    std::FILE* pipe = _popen((command + "2>&1").c_str(), "r");
    if (pipe == nullptr) return end;
    std::array<char, 4096> part{};
    while (std::fgets(part.data(), static_cast<int>(part.size()), pipe) != nullptr) end.text += part.data();
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

ProgramEnd runProgram(const std::vector<std::string>& words) {
    ProgramEnd end;
    std::array<int, 2> pipe{};
    if (::pipe(pipe.data()) != 0) return end;
    for (const int side : pipe) fcntl(side, F_SETFD, FD_CLOEXEC);  // other children must not hold it open
    pid_t child = 0;
    const int failed = spawn(words, pipe[1], child);
    close(pipe[1]);
    if (failed != 0) {
        close(pipe[0]);
        end.text = cannotStart(words, failed).text();
        return end;
    }
    std::array<char, 4096> part{};
    for (ssize_t size = 0; (size = read(pipe[0], part.data(), part.size())) != 0;) {
        if (size < 0 && errno != EINTR) break;
        if (size > 0) end.text.append(part.data(), static_cast<std::size_t>(size));
    }
    close(pipe[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    end.succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return end;
}

Result<Done> startProgram(const std::vector<std::string>& words) {
    pid_t child = 0;
    if (const int failed = spawn(words, std::nullopt, child); failed != 0) return cannotStart(words, failed);
    std::thread{[child] { waitpid(child, nullptr, 0); }}.detach();  // else it stays in the table of processes
    return Done{};
}

#endif

}  // namespace plumb::editor
