#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/file.hpp"
#include "core/text_store.hpp"

namespace plumb {

/// An asset and its administrative data.
template <class T>
struct AssetEntry {
    TextId id;
    std::string path;         ///< path in the project, or name of an asset created by code
    Path file;                ///< path in the file system; empty for an asset created by code
    std::uint64_t stamp = 0;  ///< stamp (time, size) of the file when it was read; 0 if there was none
    int references = 0;
    bool missing = false;        ///< the file is missing or damaged; a placeholder is used
    std::uint32_t revision = 1;  ///< increases whenever the asset is replaced
    T value;
};

/// Hash table of the assets of one kind by id. Open addressing: a look-up needs one multiplication and
/// usually one comparison. Entries keep their address; at() returns them in the order of loading.
template <class T>
class AssetTable {
public:
    using Entry = AssetEntry<T>;

    [[nodiscard]] Entry* find(TextId id) const {
        if (slots_.empty()) return nullptr;
        for (std::size_t at = startOf(id);; at = (at + 1) & (slots_.size() - 1)) {
            Entry* entry = slots_[at];
            if (entry == nullptr || entry->id == id) return entry;
        }
    }

    /// @pre find(id) is null
    Entry& add(TextId id, std::string path) {
        if ((entries_.size() + 1) * 2 > slots_.size()) resizeSlots(slots_.empty() ? 16 : slots_.size() * 2);
        Entry& entry = *entries_.emplace_back(std::make_unique<Entry>());
        entry.id = id;
        entry.path = std::move(path);
        put(entry);
        return entry;
    }

    template <class Condition>
    std::size_t removeIf(Condition&& condition) {
        const std::size_t before = entries_.size();
        std::erase_if(entries_, [&](const std::unique_ptr<Entry>& entry) { return condition(*entry); });
        if (entries_.size() != before) resizeSlots(slots_.size());
        return before - entries_.size();
    }

    [[nodiscard]] std::size_t size() const { return entries_.size(); }
    [[nodiscard]] Entry& at(std::size_t index) const { return *entries_[index]; }

private:
    [[nodiscard]] std::size_t startOf(TextId id) const {
        return static_cast<std::size_t>(id.value * 0x9e3779b97f4a7c15ull >> 32) & (slots_.size() - 1);
    }

    void put(Entry& entry) {
        std::size_t at = startOf(entry.id);
        while (slots_[at] != nullptr) at = (at + 1) & (slots_.size() - 1);
        slots_[at] = &entry;
    }

    void resizeSlots(std::size_t count) {
        slots_.assign(count, nullptr);
        for (const std::unique_ptr<Entry>& entry : entries_) put(*entry);
    }

    std::vector<std::unique_ptr<Entry>> entries_;
    std::vector<Entry*> slots_;  // size a power of two, at most half full
};

}  // namespace plumb
