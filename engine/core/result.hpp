#pragma once

#include <optional>
#include <string>
#include <utility>

#include "core/assert.hpp"

namespace plumb {

/// What went wrong, where, and what to do about it. Written for users.
struct Error {
    std::string where;   ///< "levels/cave.json: entities[3].Spin.rate"
    std::string what;    ///< "expected a number, found \"fast\""
    std::string remedy;  ///< "write the rate in radians per second, e.g. 1.5"

    [[nodiscard]] std::string text() const {
        std::string line = where + ": " + what;
        return remedy.empty() ? line : line + "; " + remedy;
    }
};

/// The value type of a Result that is only a success or an Error.
struct Done {};

/// A value, or the Error that explains why there is none. For external data; bugs of the program assert.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : value_{std::move(value)} {}
    Result(Error error) : error_{std::move(error)} {}

    explicit operator bool() const { return value_.has_value(); }
    [[nodiscard]] bool ok() const { return value_.has_value(); }

    /// @pre ok()
    T& operator*() { return checked(), *value_; }
    const T& operator*() const { return checked(), *value_; }
    T* operator->() { return checked(), &*value_; }
    const T* operator->() const { return checked(), &*value_; }

    /// @pre !ok()
    [[nodiscard]] const Error& error() const {
        PLUMB_ASSERT(!ok(), "a Result that holds a value has no error; check ok() first");
        return error_;
    }

private:
    void checked() const { PLUMB_ASSERT(ok(), "a Result without a value was read; check ok() first"); }

    std::optional<T> value_;
    Error error_;
};

}  // namespace plumb
