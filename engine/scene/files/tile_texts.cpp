#include "scene/files/tile_texts.hpp"

#include <cstddef>
#include <map>
#include <mutex>
#include <utility>

namespace plumb {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;  // bytes in a generation

/// Cache in two generations: texts found in the older one move to the newer one; when the newer one is full,
/// it replaces the older one, which is dropped.
class TileTexts {
public:
    void remember(const BlockStamps& stamps, const std::string& text) {
        const std::lock_guard lock{mutex_};
        put(stamps, text);
    }

    std::optional<std::string> find(const BlockStamps& stamps) {
        const std::lock_guard lock{mutex_};
        if (const auto found = newer_.find(stamps); found != newer_.end()) return found->second;
        const auto found = older_.find(stamps);
        if (found == older_.end()) return std::nullopt;
        std::string text = std::move(found->second);
        older_.erase(found);
        put(stamps, text);
        return text;
    }

private:
    using Texts = std::map<BlockStamps, std::string>;

    void put(const BlockStamps& stamps, const std::string& text) {
        if (bytes_ + text.size() > kMostBytes) {
            older_ = std::exchange(newer_, {});
            bytes_ = 0;
        }
        if (newer_.insert_or_assign(stamps, text).second) bytes_ += text.size();
    }

    std::mutex mutex_;
    Texts newer_;
    Texts older_;
    std::size_t bytes_ = 0;  // total size of the texts in newer_
};

TileTexts tileTexts;

}  // namespace

void rememberTileText(const BlockStamps& stamps, const std::string& text) {
    tileTexts.remember(stamps, text);
}

std::optional<std::string> knownTileText(const BlockStamps& stamps) { return tileTexts.find(stamps); }

}  // namespace plumb
