#pragma once

#include <string>
#include <vector>

namespace plumb::test {

/// A script that tries to leave the sandbox, and what must happen.
struct Escape {
    std::string name;
    std::string script;
    bool fails = false;    ///< it ends with an error
    std::string expected;  ///< the result as text, or a part of the error
};

/// The scripts in tests/script/escapes/*.lua. Each follows a line `--# name | result: text` or
/// `--# name | error: part`.
std::vector<Escape> writtenEscapes();
/// Scripts whose texts are made by a program: they are long, or contain bytes that editors change.
std::vector<Escape> madeEscapes();

}  // namespace plumb::test
