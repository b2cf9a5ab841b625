#include "render/texture_library.hpp"

namespace plumb {
namespace {

constexpr TextureRegion kWhite{{}, 0, 0, 1, 1};

}  // namespace

const TextureRegion& TextureLibrary::regionOf(TextureId id) {
    if (id.empty()) return kWhite;
    if (const auto* known = uploaded_.find(id.path)) return known->value.region;
    auto& entry = uploaded_.add(id.path, {});
    entry.value.region = atlas_.add(assets_.image(id));
    entry.value.revision = assets_.revisionOf(AssetKind::Texture, id.path);
    assets_.dropImage(id);
    return entry.value.region;
}

void TextureLibrary::refresh() {
    for (std::size_t i = 0; i < uploaded_.size();) {
        AssetEntry<Uploaded>& entry = uploaded_.at(i);
        const std::uint32_t revision = assets_.revisionOf(AssetKind::Texture, entry.id);
        if (revision == 0 && entry.value.revision != 0) {  // the store unloaded it
            forget(TextureId{entry.id});
            continue;
        }
        ++i;
        if (revision == entry.value.revision) continue;
        const TextureId id{entry.id};
        const TextureRegion before = entry.value.region;
        entry.value.region = atlas_.replace(before, assets_.image(id));
        entry.value.revision = revision;
        assets_.dropImage(id);
        if (entry.value.region != before) ++version_;
    }
}

void TextureLibrary::forget(TextureId id) {
    if (const auto* known = uploaded_.find(id.path)) atlas_.remove(known->value.region);
    uploaded_.removeIf([id](const AssetEntry<Uploaded>& entry) { return entry.id == id.path; });
    ++version_;
}

}  // namespace plumb
