#include "codec/pack.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <optional>
#include <zstd.h>

#include "codec/compression.hpp"
#include "core/assert.hpp"
#include "core/hash.hpp"
#include "core/limits.hpp"
#include "core/os.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::string_view kMagic = "PLUMBPAK";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kHeaderBytes = 28;
constexpr std::size_t kTableBytes = std::size_t{64} << 20;  // limit
constexpr int kLevel = 19;  // of Zstandard: the best that takes as little memory to unpack as the default

std::uint64_t hashOf(std::string_view bytes) {
    Hasher hasher;
    hasher.addBytes(bytes.data(), bytes.size());
    return hasher.value();
}

// ---- numbers

template <class Number>
void put(std::string& out, Number value) {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        out += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xff);
}

/// Reads numbers and texts until one is missing.
class Cursor {
public:
    explicit Cursor(std::string_view bytes) : rest_{bytes} {}

    template <class Number>
    bool take(Number& value) {
        if (rest_.size() < sizeof(Number)) return false;
        std::uint64_t word = 0;
        for (std::size_t i = 0; i < sizeof(Number); ++i)
            word |= std::uint64_t{static_cast<unsigned char>(rest_[i])} << (8 * i);
        value = static_cast<Number>(word);
        rest_.remove_prefix(sizeof(Number));
        return true;
    }
    bool take(std::string& text, std::size_t bytes) {
        if (rest_.size() < bytes) return false;
        text = rest_.substr(0, bytes);
        rest_.remove_prefix(bytes);
        return true;
    }
    [[nodiscard]] std::size_t left() const { return rest_.size(); }

private:
    std::string_view rest_;
};

std::string packed(std::string_view bytes) {
    std::string out(ZSTD_compressBound(bytes.size()), '\0');
    const std::size_t count = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
    PLUMB_ASSERT(ZSTD_isError(count) == 0, "ZSTD_compressBound() is too small for this input");
    out.resize(count);
    return out;
}

Error damaged(std::string_view where, std::string what) {
    return {std::string{where}, std::move(what), "copy the whole game again"};
}

}  // namespace

std::string writePack(std::vector<std::pair<std::string, std::string>> files) {
    std::sort(files.begin(), files.end());
    std::string table, list, contents;
    std::map<std::string_view, std::uint32_t> known;  // content to index
    for (const auto& [path, bytes] : files) {
        const auto [at, isNew] = known.try_emplace(bytes, static_cast<std::uint32_t>(known.size()));
        put(list, static_cast<std::uint16_t>(path.size()));
        list += path;
        put(list, at->second);
        if (!isNew) continue;
        const std::string smaller = packed(bytes);
        const std::string_view stored = smaller.size() < bytes.size() ? std::string_view{smaller} : bytes;
        put(table, std::uint64_t{kHeaderBytes} + contents.size());  // the table's size is added below
        put(table, static_cast<std::uint32_t>(stored.size()));
        put(table, static_cast<std::uint32_t>(bytes.size()));
        put(table, hashOf(bytes));
        contents += stored;
    }
    // Contents come first, so that their offsets do not depend on the size of the table.
    std::string whole;
    put(whole, static_cast<std::uint32_t>(known.size()));
    whole += table;
    put(whole, static_cast<std::uint32_t>(files.size()));
    whole += list;
    const std::string packedTable = packed(whole);
    std::string out{kMagic};
    put(out, kVersion);
    put(out, static_cast<std::uint32_t>(packedTable.size()));
    put(out, static_cast<std::uint32_t>(whole.size()));
    put(out, hashOf(whole));
    return out + contents + packedTable;
}

// ---- reading

/// A file on the disk or bytes in memory, of which parts are read.
class Pack::Bytes {
public:
    explicit Bytes(std::string memory) : memory_{std::move(memory)}, size_{memory_.size()} {}
    Bytes(std::FILE* file, std::uint64_t size) : file_{file, &std::fclose}, size_{size} {}

    [[nodiscard]] std::uint64_t size() const { return size_; }
    [[nodiscard]] std::optional<std::string> read(std::uint64_t offset, std::size_t count) {
        if (offset > size_ || count > size_ - offset) return std::nullopt;
        if (file_ == nullptr) return memory_.substr(static_cast<std::size_t>(offset), count);
        const std::lock_guard lock{mutex_};
        std::string part(count, '\0');
        if (!os::seek(file_.get(), offset) || std::fread(part.data(), 1, count, file_.get()) != count)
            return std::nullopt;
        return part;
    }

private:
    std::string memory_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, &std::fclose};
    std::uint64_t size_ = 0;
    std::mutex mutex_;  // of the file's position
};

Pack::Pack() = default;
Pack::~Pack() = default;

Result<std::shared_ptr<const Pack>> Pack::open(const Path& file) {
    std::error_code failed;
    const std::uintmax_t size = std::filesystem::file_size(file, failed);
    std::FILE* handle = failed ? nullptr : os::openFile(file, "rb");
    if (handle == nullptr) return damaged(file.generic_string(), "the pack could not be opened");
    return read(std::make_shared<Bytes>(handle, size), file.generic_string());
}

Result<std::shared_ptr<const Pack>> Pack::open(std::string bytes, std::string_view where) {
    return read(std::make_shared<Bytes>(std::move(bytes)), where);
}

Result<std::shared_ptr<const Pack>> Pack::read(std::shared_ptr<Bytes> bytes, std::string_view where) {
    const std::optional<std::string> header = bytes->read(0, kHeaderBytes);
    if (!header || !startsWith(*header, kMagic)) return damaged(where, "this is not a pack of Plumb");
    std::uint32_t version = 0, packedBytes = 0, tableBytes = 0;
    std::uint64_t hash = 0;
    Cursor cursor{std::string_view{*header}.substr(kMagic.size())};
    if (!cursor.take(version) || !cursor.take(packedBytes) || !cursor.take(tableBytes) || !cursor.take(hash))
        return damaged(where, "the header is truncated");
    if (version != kVersion)
        return damaged(where, format("the version of the pack is {}, expected {}", version, kVersion));
    if (packedBytes > bytes->size() - kHeaderBytes) return damaged(where, "the pack is truncated");
    if (tableBytes > kTableBytes) return damaged(where, "the list of files is too large");
    const std::optional<std::string> packedTable = bytes->read(bytes->size() - packedBytes, packedBytes);
    if (!packedTable) return damaged(where, "the pack is truncated");
    const Result<std::string> table = unpackZstd(*packedTable, tableBytes, where);
    if (!table) return table.error();
    if (table->size() != tableBytes || hashOf(*table) != hash)
        return damaged(where, "the list of files is damaged");
    std::shared_ptr<Pack> pack{new Pack, std::default_delete<Pack>{}};
    pack->where_ = where;
    pack->bytes_ = std::move(bytes);
    if (const Result<Done> done = pack->readTable(*table); !done) return done.error();
    return std::shared_ptr<const Pack>{std::move(pack)};
}

Result<Done> Pack::readTable(std::string_view table) {
    constexpr std::size_t kContentBytes = 24, kLeastFileBytes = 7;
    const auto truncated = [&] { return damaged(where_, "the list of files is truncated"); };
    Cursor cursor{table};
    std::uint32_t count = 0;
    if (!cursor.take(count) || count > cursor.left() / kContentBytes) return truncated();
    contents_.resize(count);
    for (Content& content : contents_) {
        if (!cursor.take(content.offset) || !cursor.take(content.packed) || !cursor.take(content.bytes) ||
            !cursor.take(content.hash))
            return truncated();
        if (content.bytes > limits::kFileBytes || content.packed > content.bytes ||
            content.offset > bytes_->size() || content.packed > bytes_->size() - content.offset)
            return damaged(where_, "a file of the pack lies outside of it");
    }
    if (!cursor.take(count) || count > cursor.left() / kLeastFileBytes) return truncated();
    for (std::uint32_t i = 0; i < count; ++i) {
        std::uint16_t length = 0;
        std::string path;
        std::uint32_t content = 0;
        if (!cursor.take(length) || !cursor.take(path, length) || !cursor.take(content)) return truncated();
        if (content >= contents_.size()) return damaged(where_, "a file of the pack has no content");
        if (const std::string why = whyPathRefused(path); !why.empty())
            return damaged(where_, format("the path \"{}\" {}", path, why));
        if (!paths_.empty() && path <= paths_.back()) return damaged(where_, "the paths are not sorted");
        paths_.push_back(std::move(path));
        contentOf_.push_back(content);
    }
    return Done{};
}

Result<std::string> Pack::read(std::size_t index) const {
    const Content& content = contents_[contentOf_[index]];
    const std::string where = format("{}: {}", where_, paths_[index]);
    std::optional<std::string> stored = bytes_->read(content.offset, content.packed);
    if (!stored) return damaged(where, "the file could not be read");
    if (content.packed < content.bytes) {
        Result<std::string> unpacked = unpackZstd(*stored, content.bytes, where);
        if (!unpacked) return unpacked.error();
        stored = std::move(*unpacked);
    }
    if (stored->size() != content.bytes || hashOf(*stored) != content.hash)
        return damaged(where, "the file is damaged");
    return std::move(*stored);
}

}  // namespace plumb
