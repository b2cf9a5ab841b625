#include "assets/asset_store.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/guarded.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "platform/image_file.hpp"

namespace plumb {
namespace {

constexpr std::string_view kEnginePrefix = "engine:";
constexpr std::size_t kMaxErrors = 1000;
constexpr std::uint32_t kRevisionStep = 0x10000;  // more than the number of reloads of any file

}  // namespace

template <class Visit>
void AssetStore::visitTable(AssetKind kind, Visit&& visit) {
    std::apply(
        [&](auto&... kindTable) { ((kindTable.kKind == kind ? visit(kindTable.table) : void()), ...); },
        tables_);
}

template <class Visit>
void AssetStore::visitTable(AssetKind kind, Visit&& visit) const {
    std::apply(
        [&](const auto&... kindTable) { ((kindTable.kKind == kind ? visit(kindTable.table) : void()), ...); },
        tables_);
}

AssetStore::AssetStore(Path root, Path engineRoot)
    : root_{std::move(root)}, engineRoot_{std::move(engineRoot)} {}

Result<Path> AssetStore::resolve(std::string_view path) const {
    const bool ofEngine = startsWith(path, kEnginePrefix);
    const Path& root = ofEngine ? engineRoot_ : root_;
    if (root.empty()) {
        return Error{std::string{path.substr(0, 200)},
                     ofEngine ? "the engine's assets folder was not found" : "no project is open",
                     ofEngine ? "install the engine with its assets folder" : "open a project first"};
    }
    if (ofEngine) return pathInside(root, path.substr(kEnginePrefix.size()));
    Result<Path> direct = pathInside(root, path);
    if (!direct || path.find('/') != std::string_view::npos || fileExists(*direct)) return direct;
    Result<Path> inAssets = pathInside(root, "assets/" + std::string{path});
    return inAssets && fileExists(*inAssets) ? std::move(inAssets) : std::move(direct);
}

// ---- loading ------------------------------------------------------------------------------------

template <class T>
Result<Done> AssetStore::readEntry(AssetEntry<T>& entry) {
    Result<Path> file = resolve(entry.path);
    if (!file) return file.error();
    entry.file = std::move(*file);
    entry.stamp = fileStamp(entry.file);
    ++loads_;
    const Result<std::string> bytes = readFile(entry.file);
    if (!bytes) return Error{entry.path, bytes.error().what, bytes.error().remedy};
    return guarded(entry.path, [&] { return readBytes(*bytes, entry.path, entry.value); });
}

template <class T>
TextId AssetStore::loadInto(AssetTable<T>& table, std::string_view path) {
    const TextId id = textId(path);
    if (id.empty() || table.find(id) != nullptr) return id;
    // The entry is added before the file is read, so that an asset that references itself is loaded once.
    AssetEntry<T>& entry = table.add(id, std::string{path});
    entry.revision = firstRevision_;
    if (const Result<Done> read = readEntry(entry); !read) {
        entry.missing = true;
        report(read.error());
        return id;
    }
    logLoaded(entry.path, entry.value);
    acquireParts(entry.value);
    return id;
}

TextureId AssetStore::loadTexture(std::string_view path) {
    return {loadInto(std::get<0>(tables_).table, path)};
}
TilesetId AssetStore::loadTileset(std::string_view path) {
    return {loadInto(std::get<1>(tables_).table, path)};
}
AnimationId AssetStore::loadAnimation(std::string_view path) {
    return {loadInto(std::get<2>(tables_).table, path)};
}
SoundId AssetStore::loadSound(std::string_view path) { return {loadInto(std::get<3>(tables_).table, path)}; }
FontId AssetStore::loadFont(std::string_view path) { return {loadInto(std::get<4>(tables_).table, path)}; }

void AssetStore::load(AssetKind kind, std::string_view path) {
    visitTable(kind, [&](auto& table) { loadInto(table, path); });
}

Result<Done> AssetStore::readBytes(std::string_view bytes, const std::string& path, Texture& texture) {
    const Result<ImageSize> size = readImageSize(bytes, path);
    if (!size) return size.error();
    // Decode an image in use immediately, so that the old one is kept if the new file is damaged.
    Image image;
    if (texture.wanted) {
        Result<Image> decoded = decodeImage(bytes, path);
        if (!decoded) return decoded.error();
        image = std::move(*decoded);
    }
    texture = {size->width, size->height, std::move(image), texture.wanted};
    return Done{};
}

Result<Done> AssetStore::readBytes(std::string_view bytes, const std::string& path, Tileset& tileset) {
    std::vector<Error> problems;
    Result<Tileset> read = parseTileset(bytes, path, problems);
    for (Error& problem : problems) report(std::move(problem));
    if (!read) return read.error();
    tileset = std::move(*read);
    return Done{};
}

Result<Done> AssetStore::readBytes(std::string_view bytes, const std::string& path, AnimationSet& set) {
    std::vector<Error> problems;
    Result<AnimationSet> read = parseAnimationSet(bytes, path, problems);
    for (Error& problem : problems) report(std::move(problem));
    if (!read) return read.error();
    set = std::move(*read);
    return Done{};
}

Result<Done> AssetStore::readBytes(std::string_view bytes, const std::string& path, FileBytes& file) {
    if (bytes.empty()) return Error{path, "the file is empty", "restore the file"};
    file.bytes = bytes;
    return Done{};
}

Result<Done> AssetStore::readBytes(std::string_view, const std::string&, WatchedFile&) { return Done{}; }

// ---- assets created by code ---------------------------------------------------------------------

template <class T>
TextId AssetStore::addTo(AssetTable<T>& table, std::string_view name, T value) {
    const TextId id = textId(name);
    AssetEntry<T>* entry = table.find(id);
    if (entry == nullptr) {
        entry = &table.add(id, std::string{name});
    } else {
        ++entry->revision;
        if (!entry->missing) releaseParts(entry->value);
    }
    entry->value = std::move(value);
    entry->file.clear();
    entry->missing = false;
    acquireParts(entry->value);
    return id;
}

TextureId AssetStore::addTexture(std::string_view name, Image image) {
    const int width = image.width;
    const int height = image.height;
    return {addTo(std::get<0>(tables_).table, name, Texture{width, height, std::move(image)})};
}
TilesetId AssetStore::addTileset(std::string_view name, Tileset tileset) {
    return {addTo(std::get<1>(tables_).table, name, std::move(tileset))};
}
AnimationId AssetStore::addAnimation(std::string_view name, AnimationSet set) {
    return {addTo(std::get<2>(tables_).table, name, std::move(set))};
}

// ---- queries ------------------------------------------------------------------------------------

const Tileset& AssetStore::tileset(TilesetId id) const {
    static const Tileset placeholder;
    const Tileset* found = find(id);
    return found == nullptr ? placeholder : *found;
}

const AnimationSet& AssetStore::animation(AnimationId id) const {
    static const AnimationSet placeholder;
    const AnimationSet* found = find(id);
    return found == nullptr ? placeholder : *found;
}

const Image& AssetStore::image(TextureId id) {
    AssetEntry<Texture>* entry = textures().find(id.path);
    if (entry == nullptr || entry->missing) return placeholderImage();
    Texture& texture = entry->value;
    texture.wanted = true;
    if (!texture.image.empty()) return texture.image;
    const Result<std::string> bytes = readFile(entry->file);
    Result<Image> decoded = bytes ? decodeImage(*bytes, entry->path) : Result<Image>{bytes.error()};
    if (!decoded) {
        entry->missing = true;
        report(decoded.error());
        return placeholderImage();
    }
    texture.width = decoded->width;
    texture.height = decoded->height;
    texture.image = std::move(*decoded);
    return texture.image;
}

void AssetStore::dropImage(TextureId id) {
    AssetEntry<Texture>* entry = textures().find(id.path);
    if (entry != nullptr && !entry->file.empty()) entry->value.image = {};
}

std::string_view AssetStore::pathOf(AssetKind kind, TextId id) const {
    std::string_view path;
    visitTable(kind, [&](const auto& table) {
        if (const auto* entry = table.find(id)) path = entry->path;
    });
    return path;
}

bool AssetStore::isMissing(AssetKind kind, TextId id) const {
    bool missing = true;
    visitTable(kind, [&](const auto& table) {
        if (const auto* entry = table.find(id)) missing = entry->missing;
    });
    return missing;
}

std::uint32_t AssetStore::revisionOf(AssetKind kind, TextId id) const {
    std::uint32_t revision = 0;
    visitTable(kind, [&](const auto& table) {
        if (const auto* entry = table.find(id)) revision = entry->revision;
    });
    return revision;
}

std::size_t AssetStore::size() const {
    return std::apply([](const auto&... kindTable) { return (kindTable.table.size() + ...); }, tables_);
}

// ---- references ---------------------------------------------------------------------------------

void AssetStore::acquire(AssetKind kind, TextId id) {
    visitTable(kind, [&](auto& table) {
        if (auto* entry = table.find(id)) ++entry->references;
    });
}

void AssetStore::release(AssetKind kind, TextId id) {
    visitTable(kind, [&](auto& table) {
        auto* entry = table.find(id);
        PLUMB_ASSERT(entry == nullptr || entry->references > 0,
                     "an asset was released more often than acquired");
        if (entry != nullptr && entry->references > 0) --entry->references;
    });
}

int AssetStore::references(AssetKind kind, TextId id) const {
    int count = 0;
    visitTable(kind, [&](const auto& table) {
        if (const auto* entry = table.find(id)) count = entry->references;
    });
    return count;
}

void AssetStore::acquireTexture(const std::string& path) {
    if (!path.empty()) acquire(AssetKind::Texture, loadTexture(path).path);
}

void AssetStore::releaseTexture(TextureId id) {
    if (!id.empty()) release(AssetKind::Texture, id.path);
}

void AssetStore::acquireParts(const Tileset& tileset) {
    acquireTexture(tileset.image);
    for (const TileImage& image : tileset.images) acquireTexture(image.path);
}
void AssetStore::acquireParts(const AnimationSet& set) { acquireTexture(set.image); }

void AssetStore::releaseParts(const Tileset& tileset) {
    releaseTexture(tileset.texture);
    for (const TileImage& image : tileset.images) releaseTexture(image.texture);
}
void AssetStore::releaseParts(const AnimationSet& set) { releaseTexture(set.texture); }

std::size_t AssetStore::unloadUnused() {
    const auto unload = [&](auto& table) {
        return table.removeIf([&](const auto& entry) {
            const bool fromFile = !entry.file.empty() || entry.missing;
            const bool unused = entry.references == 0 && fromFile;
            if (unused && !entry.missing) releaseParts(entry.value);
            return unused;
        });
    };
    // Textures last, because unloading tilesets and animations releases their textures.
    std::size_t count =
        std::apply([&](auto&, auto&... others) { return (unload(others.table) + ...); }, tables_);
    count += unload(std::get<0>(tables_).table);
    if (count > 0) firstRevision_ += kRevisionStep;
    return count;
}

namespace {

std::size_t bytesOf(const Texture& texture) { return texture.image.rgba.size(); }
std::size_t bytesOf(const Tileset& set) {
    return set.tiles.size() * sizeof(Tile) + set.images.size() * sizeof(TileImage);
}
std::size_t bytesOf(const AnimationSet& set) {
    std::size_t bytes = set.clips.size() * sizeof(Animation);
    for (const Animation& clip : set.clips) bytes += clip.frames.size() * sizeof(clip.frames[0]);
    return bytes;
}
std::size_t bytesOf(const FileBytes& file) { return file.bytes.size(); }
std::size_t bytesOf(const WatchedFile&) { return 0; }

}  // namespace

std::size_t AssetStore::byteCount() const {
    std::size_t bytes = 0;
    const auto add = [&bytes](const auto& table) {
        for (std::size_t i = 0; i < table.size(); ++i)
            bytes += sizeof(table.at(i)) + bytesOf(table.at(i).value);
    };
    std::apply([&](const auto&... kindTable) { (add(kindTable.table), ...); }, tables_);
    return bytes;
}

// ---- hot reload ---------------------------------------------------------------------------------

template <class T>
bool AssetStore::reload(AssetEntry<T>& entry) {
    if (entry.file.empty()) return false;
    const std::uint64_t stamp = fileStamp(entry.file);
    if (stamp == entry.stamp) return false;
    AssetEntry<T> fresh;
    fresh.path = entry.path;
    if constexpr (std::is_same_v<T, Texture>) fresh.value.wanted = entry.value.wanted;
    const Result<Done> read = readEntry(fresh);
    entry.stamp = fresh.stamp != 0 ? fresh.stamp : stamp;
    if (!fresh.file.empty()) entry.file = fresh.file;
    if (!read) {
        report(read.error());
        return false;
    }
    acquireParts(fresh.value);
    if (!entry.missing) releaseParts(entry.value);
    entry.value = std::move(fresh.value);
    entry.missing = false;
    ++entry.revision;
    if (logging) logNote("Assets", "Reloaded: {}", entry.path);
    return true;
}

std::vector<AssetChange> AssetStore::pollChanges(std::size_t budget) {
    std::vector<AssetChange> changes;
    const std::size_t total = size();
    for (std::size_t looked = 0; looked < std::min(budget, total); ++looked) {
        std::size_t index = pollAt_ = pollAt_ % total;
        ++pollAt_;
        const auto lookAt = [&](auto& kindTable) {
            if (index >= kindTable.table.size()) {
                index -= kindTable.table.size();
                return false;
            }
            if (auto& entry = kindTable.table.at(index); reload(entry))
                changes.push_back({kindTable.kKind, entry.id});
            return true;
        };
        std::apply([&](auto&... kindTable) { (lookAt(kindTable) || ...); }, tables_);
    }
    return changes;
}

bool AssetStore::refresh(AssetKind kind, TextId id) {
    bool loaded = false;
    visitTable(kind, [&](auto& table) {
        auto* entry = table.find(id);
        if (entry == nullptr) return;
        entry->stamp = 0;  // force a reload: two writes in quick succession may have the same file time
        loaded = reload(*entry);
    });
    return loaded;
}

// ---- log and errors -----------------------------------------------------------------------------

void AssetStore::report(Error error) {
    if (logging) logWarning("Assets", error);
    if (errors_.size() < kMaxErrors) errors_.push_back(std::move(error));
}

void AssetStore::logLoaded(const std::string& path, const Texture& texture) const {
    if (!logging) return;
    const int frames = texture.frameCount();
    if (frames > 1) {
        logNote("Assets", "Loaded: {} ({}x{}, {} frames)", path, texture.width / frames, texture.height,
                frames);
    } else {
        logNote("Assets", "Loaded: {} ({}x{})", path, texture.width, texture.height);
    }
}

template <class T>
void AssetStore::logLoaded(const std::string& path, const T& value) const {
    if (!logging) return;
    if constexpr (std::is_same_v<T, Tileset>) {
        logNote("Assets", "Loaded: {} ({} tiles of {}x{})", path, value.count, value.tileWidth,
                value.tileHeight);
    } else if constexpr (std::is_same_v<T, AnimationSet>) {
        logNote("Assets", "Loaded: {} ({} clips)", path, value.clips.size());
    } else if constexpr (std::is_same_v<T, FileBytes>) {
        logNote("Assets", "Loaded: {} ({} bytes)", path, value.bytes.size());
    }
}

}  // namespace plumb
