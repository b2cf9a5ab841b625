#pragma once

#include <string>

#include "core/file.hpp"
#include "core/result.hpp"

namespace plumb {

/// A library of code that is loaded while the program runs. It stays loaded until the program ends: its
/// functions and type descriptions may be in use.
class SharedLibrary {
public:
    /// @error missing, or it needs functions that this program does not have
    static Result<SharedLibrary> load(const Path& file);

    /// The function of this name (extern "C"), or null.
    template <class Function>
    [[nodiscard]] Function* find(const std::string& name) const {
        return reinterpret_cast<Function*>(address(name));
    }

private:
    explicit SharedLibrary(void* handle) : handle_{handle} {}
    [[nodiscard]] void* address(const std::string& name) const;

    void* handle_;
};

}  // namespace plumb
