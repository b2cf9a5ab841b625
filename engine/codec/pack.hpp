#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/file.hpp"

namespace plumb {

/// A pack contains the files of a game in one file, for export: each content once, compressed where that
/// helps, with a checksum. The same files give the same bytes.
///
/// All numbers are little-endian:
///
///     "PLUMBPAK"  u32 version  u32 packed bytes of the table  u32 bytes of the table  u64 hash of the table
///     table, packed by Zstandard:
///         u32 contents, each: u64 offset in the pack, u32 packed bytes (as many as `bytes`: not packed), u32
///         bytes,
///             u64 hash
///         u32 files, sorted by path, each: u16 length of the path, the path, u32 index of its content
///     contents

/// Returns the bytes of a pack. @param files  path, with '/', and content of each; paths are relative and
/// unique
std::string writePack(std::vector<std::pair<std::string, std::string>> files);

/// An open pack. Its files are read when they are asked for.
class Pack : public FileSource {
public:
    /// @error missing, not a pack, of a newer version, damaged, paths that leave the folder
    static Result<std::shared_ptr<const Pack>> open(const Path& file);
    /// The same for bytes in memory. @param where  prefix of errors
    static Result<std::shared_ptr<const Pack>> open(std::string bytes, std::string_view where);

    [[nodiscard]] std::span<const std::string> paths() const override { return paths_; }
    /// @error the content is damaged
    [[nodiscard]] Result<std::string> read(std::size_t index) const override;

private:
    struct Content {
        std::uint64_t offset = 0;
        std::uint32_t packed = 0;
        std::uint32_t bytes = 0;
        std::uint64_t hash = 0;
    };
    class Bytes;

    Pack();
    ~Pack() override;
    friend struct std::default_delete<Pack>;
    static Result<std::shared_ptr<const Pack>> read(std::shared_ptr<Bytes> bytes, std::string_view where);
    [[nodiscard]] Result<Done> readTable(std::string_view table);

    std::string where_;
    std::shared_ptr<Bytes> bytes_;
    std::vector<Content> contents_;
    std::vector<std::string> paths_;
    std::vector<std::uint32_t> contentOf_;  // of each path
};

}  // namespace plumb
