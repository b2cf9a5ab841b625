#pragma once

#include <exception>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace plumb {

/// Second line of defense around a reader of external data. A reader reports bad data as an Error. An
/// exception that leaves it, from a library or for lack of memory, is a defect of the reader; it must not
/// terminate a program that has unsaved work.
///
///     return guarded(path, [&] { return readScene(text); });
///
/// @param where  the file that is read
template <class Read>
auto guarded(std::string_view where, Read read) -> decltype(read()) {
    try {
        return read();
    } catch (const std::exception& thrown) {
        return Error{std::string{where}, std::string{"the reader of this file failed: "} + thrown.what(),
                     "undo the last change of the file, and report this defect with the file"};
    }
}

}  // namespace plumb
