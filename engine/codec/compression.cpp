#include "codec/compression.hpp"

#include <algorithm>
#include <limits>
#include <zlib.h>
#include <zstd.h>

#include "core/assert.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

// Arguments of inflateInit2(): the maximum window of 2^15 bytes; 16 is added for the gzip format.
constexpr int kZlibWindow = 15;
constexpr int kGzipWindow = 15 + 16;
constexpr std::size_t kFirstBytes = 4096;

Error broken(std::string_view where, std::string what) {
    return Error{std::string{where}, std::move(what), "the file is damaged or too large; export it again"};
}

Error tooLarge(std::string_view where, std::size_t limit) {
    return broken(where, format("the packed data unpacks to more than {} bytes", limit));
}

/// zlib takes its input through a pointer that is not const, and does not write through it.
Bytef* input(std::string_view bytes) { return reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())); }

/// Owns an inflate stream.
struct Inflater {
    explicit Inflater(int window) { ready = inflateInit2(&stream, window) == Z_OK; }
    ~Inflater() {
        if (ready) inflateEnd(&stream);
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    z_stream stream{};
    bool ready = false;
};

/// Returns the error of a failed inflate() call.
Error inflateError(int answer, const z_stream& stream, std::string_view where) {
    if (answer == Z_NEED_DICT) return broken(where, "zlib data with a preset dictionary is not supported");
    if (answer == Z_BUF_ERROR) return broken(where, "the packed data is truncated");
    if (answer == Z_MEM_ERROR) return broken(where, "not enough memory to unpack the data");
    return broken(where,
                  format("the packed data is damaged: {}", stream.msg ? stream.msg : "unknown format"));
}

Result<std::string> unpackDeflate(std::string_view packed, int window, std::size_t limit,
                                  std::string_view where) {
    if (packed.size() > std::numeric_limits<uInt>::max()) return tooLarge(where, limit);
    Inflater inflater{window};
    if (!inflater.ready) return broken(where, "not enough memory to unpack the data");
    z_stream& stream = inflater.stream;
    stream.next_in = input(packed);
    stream.avail_in = static_cast<uInt>(packed.size());
    // At most one byte beyond the limit is unpacked, to detect data that is too large.
    std::string out;
    for (;;) {
        const std::size_t done = out.size();
        const std::size_t room = done == 0 ? kFirstBytes : done;
        out.resize(std::min(done + room, limit + 1));
        stream.next_out = reinterpret_cast<Bytef*>(out.data() + done);
        stream.avail_out = static_cast<uInt>(out.size() - done);
        const int answer = inflate(&stream, Z_NO_FLUSH);
        out.resize(out.size() - stream.avail_out);
        if (out.size() > limit) return tooLarge(where, limit);
        if (answer == Z_STREAM_END) return out;
        if (answer != Z_OK) return inflateError(answer, stream, where);
    }
}

}  // namespace

std::string packZlib(std::string_view bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string packed(size, '\0');
    const int answer = compress(reinterpret_cast<Bytef*>(packed.data()), &size, input(bytes),
                                static_cast<uLong>(bytes.size()));
    PLUMB_ASSERT(answer == Z_OK, "compressBound() is too small for this input");
    packed.resize(size);
    return packed;
}

Result<std::string> unpackZlib(std::string_view packed, std::size_t limit, std::string_view where) {
    return unpackDeflate(packed, kZlibWindow, limit, where);
}

Result<std::string> unpackGzip(std::string_view packed, std::size_t limit, std::string_view where) {
    return unpackDeflate(packed, kGzipWindow, limit, where);
}

Result<std::string> unpackZstd(std::string_view packed, std::size_t limit, std::string_view where) {
    if (packed.empty()) return broken(where, "the packed data is truncated");
    // The header of a frame may contain its size: a frame too large is refused before memory is allocated.
    const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
    const bool isKnown = size != ZSTD_CONTENTSIZE_UNKNOWN && size != ZSTD_CONTENTSIZE_ERROR;
    if (isKnown && size > limit) return tooLarge(where, limit);
    std::string out(limit, '\0');
    const std::size_t unpacked = ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size());
    if (ZSTD_isError(unpacked)) {
        return broken(where, format("the packed data is damaged or unpacks to more than {} bytes: {}", limit,
                                    ZSTD_getErrorName(unpacked)));
    }
    out.resize(unpacked);
    return out;
}

}  // namespace plumb
