#include <cstdlib>

#include "codec/pack.hpp"
#include "tests/fuzz/fuzz_input.hpp"

/// A pack that is opened can be read to its end, or says why not; written again it has the same files.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t count) {
    const auto pack = plumb::Pack::open(std::string{plumb::test::textOf(bytes, count)}, "fuzz");
    if (!pack) return 0;
    std::vector<std::pair<std::string, std::string>> files;
    for (std::size_t i = 0; i < (*pack)->paths().size(); ++i) {
        plumb::Result<std::string> content = (*pack)->read(i);
        if (!content) return 0;
        files.emplace_back((*pack)->paths()[i], std::move(*content));
    }
    const auto again = plumb::Pack::open(plumb::writePack(files), "again");
    if (!again || (*again)->paths().size() != files.size()) std::abort();
    for (std::size_t i = 0; i < files.size(); ++i) {
        const plumb::Result<std::string> content = (*again)->read(i);
        if (!content || *content != files[i].second) std::abort();
    }
    return 0;
}
