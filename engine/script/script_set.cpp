#include "script/script_set.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include <lua.hpp>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "script/script_declaration.hpp"
#include "script/script_handlers.hpp"
#include "script/script_loader.hpp"
#include "script/script_memory.hpp"
#include "script/script_source.hpp"

namespace plumb {
namespace {

constexpr std::string_view kFolder = "scripts";
constexpr std::string_view kEnding = ".lua";

std::string pathOf(std::string_view name) { return format("{}/{}{}", kFolder, name, kEnding); }

/// "FireBall" of "enemies/fire_ball".
std::string componentName(std::string_view file) {
    const std::size_t folder = file.rfind('/');
    if (folder != std::string_view::npos) file.remove_prefix(folder + 1);
    std::string name;
    bool isStart = true;
    for (const char c : file) {
        const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (isLetter) name += isStart && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        isStart = !isLetter;
    }
    return name;
}

/// Splits "scripts/a.lua:3: what" into where and what.
Error errorOf(std::string_view message, std::string_view path) {
    const std::size_t line =
        startsWith(message, path) ? message.find(':', path.size()) : std::string_view::npos;
    const std::size_t end = line == std::string_view::npos ? line : message.find(": ", line + 1);
    if (end == std::string_view::npos) return {std::string{path}, std::string{message}, "change the file"};
    return {std::string{message.substr(0, end)}, std::string{message.substr(end + 2)}, "change this line"};
}

/// Replaces what Lua says of the function around a script (script_loader.cpp), which its author does not see.
Error plainError(Error error) {
    constexpr std::string_view kNoEnd = "'end' expected";
    constexpr std::string_view kNear = "near ";
    const std::size_t near = error.what.rfind(kNear);
    if (!startsWith(error.what, kNoEnd) || near == std::string::npos) return error;
    const std::string found = error.what.substr(near + kNear.size());
    if (found == "'else'" || found == "'elseif'" || found == "'until'") return error;
    if (found == "<eof>")
        return {error.where, "'end' expected: a function, if or loop above is not closed", "close it"};
    return {error.where, format("{} follows a return, which must be the last statement of its block", found),
            "move it above the return"};
}

std::string messageAt(lua_State* state) {
    std::size_t size = 0;
    const char* text = lua_tolstring(state, -1, &size);
    return text == nullptr ? std::string{"an error without a message"} : std::string{text, size};
}

/// Adds the functions of the table on top of the stack that seem to be handlers but are called otherwise.
void addWarnings(lua_State* state, ScriptSet::File& file) {
    for (const std::string& name : script::functionNames(state)) {
        const std::string meant = handlerMeant(name);
        if (!meant.empty())
            file.warnings.push_back({file.path, format("the engine does not call \"{}\"", name),
                                     format("name the function {}", meant)});
    }
}

/// Runs the files in a state of its own, to find the component types that they declare.
void declareTypes(ScriptSet& set, std::vector<ScriptSet::File>& files, std::vector<Error>& problems) {
    ScriptMemory memory;
    const ScriptAccess access{memory};
    lua_State* state = access.state();
    script::openScripts(state);
    for (ScriptSet::File& file : files) {
        script::resetBudget(state);
        if (!script::runFile(state, set, file.name)) {
            problems.push_back(plainError(errorOf(messageAt(state), file.path)));
            file.textHash = 0;
        } else if (script::isDeclared(state, file.name)) {
            Result<TypeInfo> type =
                script::declaredType(state, file.name, componentName(file.name), file.texts);
            if (!type)
                problems.push_back(
                    {file.path + ": " + type.error().where, type.error().what, type.error().remedy});
            if (type) file.type = *std::move(type);
            if (!type) file.textHash = 0;
            addWarnings(state, file);
        }
        lua_settop(state, 0);
    }
}

std::uint64_t nextVersion() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

}  // namespace

const ScriptSet::File* ScriptSet::find(std::string_view name) const {
    const auto found =
        std::lower_bound(files_.begin(), files_.end(), name,
                         [](const File& file, std::string_view wanted) { return file.name < wanted; });
    return found != files_.end() && found->name == name ? &*found : nullptr;
}

void ScriptSet::readTexts(const std::vector<std::pair<std::string, std::string>>& texts,
                          std::vector<Error>& problems) {
    const std::vector<File> before = std::exchange(files_, {});
    for (const auto& [name, text] : texts) {
        File& file = files_.emplace_back();
        file.name = name;
        file.path = pathOf(name);
        Result<std::string> prepared = prepareScript(text, file.path);
        if (prepared) {
            file.text = *std::move(prepared);
            file.textHash = hashText(text);
        } else {
            problems.push_back(prepared.error());
        }
    }
    std::sort(files_.begin(), files_.end(), [](const File& a, const File& b) { return a.name < b.name; });
    declareTypes(*this, files_, problems);
    // A file with an error has no hash: its former version goes on, and without one there is none.
    for (File& file : files_) {
        if (file.textHash != 0) continue;
        const auto former = std::find_if(before.begin(), before.end(),
                                         [&](const File& other) { return other.name == file.name; });
        if (former != before.end()) file = *former;
    }
    std::erase_if(files_, [](const File& file) { return file.textHash == 0; });
    version_ = nextVersion();
}

void ScriptSet::read(const Path& folder, std::vector<Error>& problems) {
    stamp_ = stampOfScripts(folder);
    const std::vector<std::pair<std::string, std::string>> texts = readScriptFiles(folder, problems);
    if (texts.empty() && files_.empty()) return;
    readTexts(texts, problems);
}

void ScriptSet::typesChanged() { version_ = nextVersion(); }

void ScriptSet::addTexts(World& world) const {
    for (const File& file : files_) {
        for (const std::string& text : file.texts) world.texts().add(text);
    }
}

namespace {

std::vector<Path> filesOf(const Path& folder) {
    std::vector<Path> files;
    for (const std::string& file : filesBelow(folder / kFolder, kEnding))
        files.push_back(folder / kFolder / file);
    return files;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> readScriptFiles(const Path& folder,
                                                                 std::vector<Error>& problems) {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const Path& path : filesOf(folder)) {
        const Result<std::string> text = readFile(path);
        if (!text) {
            problems.push_back(text.error());
            continue;
        }
        std::string name = path.lexically_relative(folder / kFolder).generic_string();
        name.resize(name.size() - kEnding.size());
        texts.emplace_back(std::move(name), *text);
    }
    return texts;
}

std::uint64_t stampOfScripts(const Path& folder) {
    Hasher hasher;
    for (const Path& path : filesOf(folder)) {
        hasher.add(hashText(path.generic_string()));
        hasher.add(fileStamp(path));
    }
    return hasher.value();
}

}  // namespace plumb
