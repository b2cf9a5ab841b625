#include "editor/model/project/project_code.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "core/hash.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/model/project/project_templates.hpp"
#include "platform/paths.hpp"
#include "platform/shared_library.hpp"

namespace plumb::editor {
namespace {

namespace fs = std::filesystem;

#if defined(_WIN32)
constexpr std::string_view kLibraryEnding = ".dll";
constexpr std::string_view kProgramEnding = ".exe";
std::FILE* openPipe(const std::string& command) { return _popen(command.c_str(), "r"); }
int closePipe(std::FILE* pipe) { return _pclose(pipe); }
#else
constexpr std::string_view kLibraryEnding = ".so";
constexpr std::string_view kProgramEnding = "";
std::FILE* openPipe(const std::string& command) { return popen(command.c_str(), "r"); }
int closePipe(std::FILE* pipe) { return pclose(pipe); }
#endif

/// The build folder in which this editor was built, or an empty path.
Path findBuildFolder() {
    std::error_code ignored;
    const Path folder = fs::weakly_canonical(executableFolder() / "..", ignored);
    return fs::is_regular_file(folder / "CMakeCache.txt", ignored) ? folder : Path{};
}

bool isCode(const Path& file) {
    const std::string ending = file.extension().string();
    return ending == ".cpp" || ending == ".hpp" || ending == ".h" || ending == ".inl";
}

std::vector<std::string> codeFiles(const Path& project) {
    std::vector<std::string> files = filesBelow(project / "code", "");
    std::erase_if(files, [](const std::string& file) { return !isCode(file); });
    return files;
}

/// Logs what a compiler reports: "FILE:LINE:COLUMN: error: TEXT".
void logDiagnostics(const Path& project, std::string_view output) {
    const std::string root = project.generic_string() + "/";
    std::size_t errors = 0;
    for (const std::string_view line : split(output, '\n')) {
        for (const auto& [mark, level] :
             {std::pair{std::string_view{": error: "}, LogLevel::Error},
              std::pair{std::string_view{": fatal error: "}, LogLevel::Error},
              std::pair{std::string_view{": warning: "}, LogLevel::Warning},
              std::pair{std::string_view{"undefined reference to"}, LogLevel::Error}}) {
            if (line.find(mark) == std::string_view::npos) continue;
            std::string text{line};
            if (const auto at = text.find(root); at != std::string::npos) text.erase(at, root.size());
            writeLog(level, "Code", std::move(text));
            errors += level == LogLevel::Error ? 1 : 0;
            break;
        }
    }
    if (errors == 0) writeLog(LogLevel::Error, "Code", "The build failed: " + std::string{output});
}

}  // namespace

Result<std::string> codeTarget(const Path& project, const Path& buildFolder) {
    std::error_code ignored;
    const Path folder = fs::weakly_canonical(project, ignored);
    if (!engineProjects().empty() && folder.parent_path() == fs::weakly_canonical(engineProjects(), ignored))
        return folder.filename().string();
    const Path list = buildFolder / "projects.txt";
    std::string text;
    if (const Result<std::string> known = readFile(list)) text = *known;
    std::size_t number = 0;
    for (const std::string_view line : split(text, '\n')) {
        if (line.empty()) continue;
        ++number;
        if (line == folder.generic_string()) return format("outside-{}", number);
    }
    if (const Result<Done> written = writeFile(list, text + folder.generic_string() + "\n"); !written)
        return written.error();
    return format("outside-{}", number + 1);
}

Path playerOf(const Path& project) {
    std::error_code ignored;
    const Path plain = executableFolder() / ("plumb-player" + std::string{kProgramEnding});
    if (codeFiles(project).empty()) return plain;
    const Path build = findBuildFolder();
    const Result<std::string> target =
        build.empty() ? Result<std::string>{Error{}} : codeTarget(project, build);
    return target ? executableFolder() / (*target + "-player" + std::string{kProgramEnding}) : plain;
}

ProjectCode::ProjectCode(Path project)
    : project_{std::move(project)}, buildFolder_{findBuildFolder()}, exists_{!codeFiles(project_).empty()} {
    if (!exists_) return;
    if (buildFolder_.empty()) {
        logError("Code", Error{(project_ / "code").generic_string(), "this editor cannot build code",
                               "use ./plumb edit PROJECT in a copy of the engine's sources"});
        return;
    }
    const Result<std::string> target = codeTarget(project_, buildFolder_);
    if (target) {
        target_ = *target;
    } else {
        logError("Code", target.error());
    }
}

ProjectCode::~ProjectCode() {
    if (build_.valid()) build_.wait();
}

Path ProjectCode::library() const {
    return executableFolder() / (target_ + "-code" + std::string{kLibraryEnding});
}

bool ProjectCode::isBuilt() const {
    std::error_code ignored;
    return !target_.empty() && fs::is_regular_file(library(), ignored);
}

Result<Module> ProjectCode::load() {
    // A copy, because a library of the same name is not loaded twice, and the next build overwrites the file.
    std::error_code failed;
    libraryStamp_ = fileStamp(library());
    const Path copy = buildFolder_ / "loaded" / format("{}-{}{}", target_, loaded_++, kLibraryEnding);
    fs::create_directories(copy.parent_path(), failed);
    fs::copy_file(library(), copy, fs::copy_options::overwrite_existing, failed);
    if (failed)
        return Error{library().generic_string(), failed.message(), "build the code: ./plumb edit PROJECT"};
    const Result<SharedLibrary> loaded = SharedLibrary::load(copy);
    if (!loaded) return loaded.error();
    auto* const describe = loaded->find<void(Module&)>("plumbDescribeModule");
    if (describe == nullptr)
        return Error{(project_ / "code").generic_string(), "it contains no PLUMB_MODULE",
                     "write PLUMB_MODULE(module) { module.components<...>(); } in one of its files"};
    Module module;
    describe(module);
    return module;
}

std::uint64_t ProjectCode::stampOfFiles() const {
    Hasher hasher;
    for (const std::string& file : codeFiles(project_)) {
        hasher.add(hashText(file));
        hasher.add(fileStamp(project_ / "code" / file));
    }
    return hasher.value();
}

void ProjectCode::start(bool withPlayer) {
    stamp_ = stampOfFiles();
    const std::string player = withPlayer ? format(" {}-player", target_) : std::string{};
    const std::string command = format("cmake --build \"{}\" --target {}-code{} 2>&1",
                                       buildFolder_.generic_string(), target_, player);
    build_ = std::async(std::launch::async, [command] {
        Build build;
        std::FILE* pipe = openPipe(command);
        if (pipe == nullptr) return build;
        std::array<char, 4096> part{};
        while (std::fgets(part.data(), static_cast<int>(part.size()), pipe) != nullptr)
            build.output += part.data();
        build.succeeded = closePipe(pipe) == 0;
        return build;
    });
}

bool ProjectCode::finish() {
    const Build build = build_.get();
    if (!build.succeeded) logDiagnostics(project_, build.output);
    return build.succeeded;
}

bool ProjectCode::buildNow() {
    if (target_.empty()) return false;
    if (isBuilding()) static_cast<void>(finish());
    start(true);
    return finish();
}

bool ProjectCode::poll(double now) {
    if (target_.empty()) return false;
    if (isBuilding()) {
        if (build_.wait_for(std::chrono::seconds{0}) != std::future_status::ready) return false;
        return finish() && fileStamp(library()) != libraryStamp_;
    }
    if (now < next_) return false;
    next_ = now + kInterval;
    if (stampOfFiles() != stamp_) start(false);
    return false;
}

}  // namespace plumb::editor
