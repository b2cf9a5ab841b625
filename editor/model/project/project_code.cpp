#include "editor/model/project/project_code.hpp"

#include <algorithm>
#include <chrono>

#include "core/hash.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/model/project/module_library.hpp"
#include "editor/templates/project_templates.hpp"
#include "platform/paths.hpp"

namespace plumb::editor {
namespace {

namespace fs = std::filesystem;

#if defined(_WIN32)
constexpr std::string_view kLibraryEnding = ".dll";
constexpr std::string_view kProgramEnding = ".exe";
#else
constexpr std::string_view kLibraryEnding = ".so";
constexpr std::string_view kProgramEnding = "";
#endif

/// The build folder in which this editor was built, or an empty path.
Path findBuildFolder() {
    std::error_code ignored;
    const Path folder = fs::weakly_canonical(executableFolder() / "..", ignored);
    return fs::is_regular_file(folder / "CMakeCache.txt", ignored) ? folder : Path{};
}

/// True if there is a file that the build compiles.
bool hasCode(const Path& project) { return !filesBelow(project / "code", ".cpp").empty(); }

bool isCode(const Path& file) {
    const std::string ending = file.extension().string();
    return ending == ".cpp" || ending == ".hpp" || ending == ".h" || ending == ".inl";
}

std::vector<std::string> codeFiles(const Path& project) {
    std::vector<std::string> files = filesBelow(project / "code", "");
    std::erase_if(files, [](const std::string& file) { return !isCode(file); });
    return files;
}

/// Removes the project's folder, or the link to it in the build folder (engine/cmake/code_target.cmake), from
/// a path in a line.
std::string shortened(std::string line, const Path& project) {
    constexpr std::string_view kLinks = "links/";
    const std::string root = project.generic_string() + "/";
    if (const auto at = line.find(root); at != std::string::npos) return line.erase(at, root.size());
    const auto at = line.find(kLinks);
    const auto end = at == std::string::npos ? at : line.find('/', at + kLinks.size());
    if (end == std::string::npos) return line;
    const auto blank = line.rfind(' ', at);
    const auto begin = blank == std::string::npos ? 0 : blank + 1;
    return line.erase(begin, end + 1 - begin);
}

/// Logs what a compiler reports: "FILE:LINE:COLUMN: error: TEXT".
void logDiagnostics(const Path& project, std::string_view output) {
    std::size_t errors = 0;
    for (const std::string_view line : split(output, '\n')) {
        for (const auto& [mark, level] :
             {std::pair{std::string_view{": error: "}, LogLevel::Error},
              std::pair{std::string_view{": fatal error: "}, LogLevel::Error},
              std::pair{std::string_view{": warning: "}, LogLevel::Warning},
              std::pair{std::string_view{"undefined reference to"}, LogLevel::Error}}) {
            if (line.find(mark) == std::string_view::npos) continue;
            writeLog(level, "Code", shortened(std::string{line}, project));
            errors += level == LogLevel::Error ? 1 : 0;
            break;
        }
    }
    if (errors == 0) writeLog(LogLevel::Error, "Code", "The build failed: " + std::string{output});
}

}  // namespace

Result<std::string> codeTarget(const Path& project, const Path& buildFolder) {
    const Path script = engineProjects().parent_path() / "engine/cmake/code_target.cmake";
    const ProgramEnd found =
        runProgram({"cmake", "-D", "PROJECT=" + project.generic_string(), "-D",
                    "BUILD=" + buildFolder.generic_string(), "-P", script.generic_string()});
    const std::string_view name = trimmed(found.text);
    if (found.succeeded && !name.empty()) return std::string{name};
    return Error{
        (project / "code").generic_string(),
        found.succeeded ? "cmake names no target for it"
                        : format("cmake cannot name a target for it: {}", trimmed(found.text)),
        found.succeeded ? "write a .cpp file in this folder" : "install cmake, or do what its message says"};
}

Path playerOf(const Path& project) {
    std::error_code ignored;
    const Path plain = executableFolder() / ("plumb-player" + std::string{kProgramEnding});
    if (!hasCode(project)) return plain;
    const Path build = findBuildFolder();
    const Result<std::string> target =
        build.empty() ? Result<std::string>{Error{}} : codeTarget(project, build);
    return target ? executableFolder() / (*target + "-player" + std::string{kProgramEnding}) : plain;
}

ProjectCode::ProjectCode(Path project)
    : project_{std::move(project)}, buildFolder_{findBuildFolder()}, exists_{hasCode(project_)} {
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
    libraryStamp_ = fileStamp(library());
    return loadModule(library(), buildFolder_ / "loaded");
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
    std::vector<std::string> words{"cmake", "--build", buildFolder_.generic_string(), "--target",
                                   target_ + "-code"};
    if (withPlayer) words.push_back(target_ + "-player");
    build_ = std::async(std::launch::async, [words = std::move(words)] { return runProgram(words); });
}

bool ProjectCode::finish() {
    const ProgramEnd build = build_.get();
    succeeded_ = build.succeeded;
    if (!succeeded_) logDiagnostics(project_, build.text);
    return succeeded_;
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
