#include "editor/model/project/module_library.hpp"

#if defined(_WIN32)
#include <process.h>
#else
#include <unistd.h>
#endif

#include "core/text.hpp"
#include "platform/shared_library.hpp"
#include "reflect/type_key.hpp"

namespace plumb::editor {
namespace {

namespace fs = std::filesystem;

#if defined(_WIN32)
int processNumber() { return _getpid(); }
#else
int processNumber() { return getpid(); }
#endif

/// Returns a path that no program has loaded a library from: a program loads each path only once, and a file
/// that is loaded must not be overwritten.
Path freshPath(const Path& library, const Path& folder) {
    static int count = 0;
    return folder / format("{}-{}-{}{}", library.stem().string(), processNumber(), count++,
                           library.extension().string());
}

}  // namespace

Result<Module> loadModule(const Path& library, const Path& folder) {
    const Path copy = freshPath(library, folder);
    std::error_code failed;
    fs::create_directories(folder, failed);
    fs::copy_file(library, copy, fs::copy_options::overwrite_existing, failed);
    if (failed)
        return Error{library.generic_string(), failed.message(), "build the code: ./plumb edit PROJECT"};
    beginReloadableTypes();
    const Result<SharedLibrary> loaded = SharedLibrary::load(copy);
    fs::remove(copy, failed);  // fails on Windows as long as the library is loaded
    if (!loaded) return loaded.error();
    auto* const describe = loaded->find<void(Module&)>("plumbDescribeModule");
    if (describe == nullptr)
        return Error{library.generic_string(), "it contains no PLUMB_MODULE",
                     "write PLUMB_MODULE(module) { module.components<...>(); } in a file of the code"};
    Module module;
    describe(module);
    return module;
}

}  // namespace plumb::editor
