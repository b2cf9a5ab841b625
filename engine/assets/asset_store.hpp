#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "assets/animation.hpp"
#include "assets/asset_table.hpp"
#include "assets/texture.hpp"
#include "assets/tileset.hpp"
#include "core/file.hpp"
#include "core/result.hpp"
#include "reflect/field_types.hpp"

namespace plumb {

/// An asset stored as the bytes of its file: a sound or a font.
struct FileBytes {
    std::string bytes;
};

/// A file that the asset store watches for changes but does not load: a scene or a prefab.
struct WatchedFile {};

/// An asset that `pollChanges` reloaded, or a watched file that changed.
struct AssetChange {
    AssetKind kind = AssetKind::None;
    TextId path;
};

/// All assets of a project. Loads each file once, assigns ids, and returns a placeholder for a missing or
/// damaged file, so that the game continues. Paths must be inside the project; `engine:fonts/…` is a path in
/// the engine's assets.
///
/// Images are decoded when their pixels are first requested, so a game without a screen decodes none.
class AssetStore {
public:
    /// @param root        the project's folder; empty if all assets are created by code
    /// @param engineRoot  the engine's assets/ folder; empty if there is none
    explicit AssetStore(Path root = {}, Path engineRoot = {});

    /// Loads a file at the first call for it and returns its id, which depends only on the path. Errors, such
    /// as a missing file, are added to `errors()`. A file not found in the root is searched in root/assets/.
    TextureId loadTexture(std::string_view path);
    TilesetId loadTileset(std::string_view path);
    AnimationId loadAnimation(std::string_view path);
    SoundId loadSound(std::string_view path);
    FontId loadFont(std::string_view path);

    /// Loads a file of a kind that is known only at run time; scenes and prefabs are only watched.
    void load(AssetKind kind, std::string_view path);

    /// Adds an asset created by code under a name; replaces an asset of that name.
    TextureId addTexture(std::string_view name, Image image);
    TilesetId addTileset(std::string_view name, Tileset tileset);
    AnimationId addAnimation(std::string_view name, AnimationSet set);

    /// Returns the asset, or null if it was never loaded. Takes a few ns.
    [[nodiscard]] const Texture* find(TextureId id) const { return valueOf(textures(), id.path); }
    [[nodiscard]] const Tileset* find(TilesetId id) const { return valueOf(tilesets(), id.path); }
    [[nodiscard]] const AnimationSet* find(AnimationId id) const { return valueOf(animations(), id.path); }
    [[nodiscard]] const FileBytes* find(SoundId id) const { return valueOf(sounds(), id.path); }
    [[nodiscard]] const FileBytes* find(FontId id) const { return valueOf(fonts(), id.path); }

    /// Returns the asset, or an empty one if it was never loaded.
    [[nodiscard]] const Tileset& tileset(TilesetId id) const;
    [[nodiscard]] const AnimationSet& animation(AnimationId id) const;

    /// Returns the pixels, decoded at the first call; of a missing texture the placeholder, a checkerboard of
    /// magenta and black. Valid until the texture changes or is unloaded.
    const Image& image(TextureId id);

    /// Frees decoded pixels, e.g. after upload to the GPU; image() decodes them again. Does nothing for
    /// textures created by code.
    void dropImage(TextureId id);

    /// Returns the path or name of an asset; empty for an unknown id.
    [[nodiscard]] std::string_view pathOf(AssetKind kind, TextId id) const;
    template <AssetKind Kind>
    [[nodiscard]] std::string_view pathOf(AssetRef<Kind> id) const {
        return pathOf(Kind, id.path);
    }

    /// True if the asset is missing or damaged, so that a placeholder is used.
    [[nodiscard]] bool isMissing(AssetKind kind, TextId id) const;
    /// Returns a number that increases whenever the asset is replaced; 0 for an unknown id.
    [[nodiscard]] std::uint32_t revisionOf(AssetKind kind, TextId id) const;

    /// Adds or removes a reference to an asset. Tilesets and animations hold references to their textures.
    void acquire(AssetKind kind, TextId id);
    void release(AssetKind kind, TextId id);
    [[nodiscard]] int references(AssetKind kind, TextId id) const;

    /// Unloads files without references; their ids can be loaded again. Keeps assets created by code.
    /// @return the number of unloaded files
    std::size_t unloadUnused();

    /// Number of file reads, including reloads.
    [[nodiscard]] std::size_t loadCount() const { return loads_; }
    /// Approximate memory of all assets, bytes: decoded pixels, file contents, tables.
    [[nodiscard]] std::size_t byteCount() const;

    /// Checks some files and reloads those that changed; the next call continues with the following files. If
    /// a changed file is damaged, an error is added to `errors()` and the old asset is kept.
    /// @param budget  maximum number of files to check, about 2 us each
    std::vector<AssetChange> pollChanges(std::size_t budget = 32);

    /// Reloads a file immediately, e.g. after the caller has written it. If it is damaged, an error is added
    /// to `errors()` and the old asset is kept. @return true if it was loaded
    bool refresh(AssetKind kind, TextId id);

    /// Errors since the last `clearErrors`, at most 1000.
    [[nodiscard]] const std::vector<Error>& errors() const { return errors_; }
    void clearErrors() { errors_.clear(); }

    /// Writes loaded files and errors to the log.
    bool logging = true;

    [[nodiscard]] const Path& root() const { return root_; }
    [[nodiscard]] std::size_t size() const;

    /// Converts a path in the project or in the engine's assets to a path in the file system.
    /// @error  the path is outside of the project
    [[nodiscard]] Result<Path> resolve(std::string_view path) const;

private:
    template <AssetKind Kind, class T>
    struct KindTable {
        static constexpr AssetKind kKind = Kind;
        AssetTable<T> table;
    };
    using KindTables =
        std::tuple<KindTable<AssetKind::Texture, Texture>, KindTable<AssetKind::Tileset, Tileset>,
                   KindTable<AssetKind::Animation, AnimationSet>, KindTable<AssetKind::Sound, FileBytes>,
                   KindTable<AssetKind::Font, FileBytes>, KindTable<AssetKind::Scene, WatchedFile>,
                   KindTable<AssetKind::Prefab, WatchedFile>>;

    template <class T>
    static const T* valueOf(const AssetTable<T>& table, TextId id) {
        const AssetEntry<T>* entry = table.find(id);
        return entry == nullptr ? nullptr : &entry->value;
    }
    [[nodiscard]] const AssetTable<Texture>& textures() const { return std::get<0>(tables_).table; }
    [[nodiscard]] const AssetTable<Tileset>& tilesets() const { return std::get<1>(tables_).table; }
    [[nodiscard]] const AssetTable<AnimationSet>& animations() const { return std::get<2>(tables_).table; }
    [[nodiscard]] const AssetTable<FileBytes>& sounds() const { return std::get<3>(tables_).table; }
    [[nodiscard]] const AssetTable<FileBytes>& fonts() const { return std::get<4>(tables_).table; }

    template <class T>
    TextId loadInto(AssetTable<T>& table, std::string_view path);
    template <class T>
    TextId addTo(AssetTable<T>& table, std::string_view name, T value);
    template <class T>
    bool reload(AssetEntry<T>& entry);
    template <class T>
    Result<Done> readEntry(AssetEntry<T>& entry);

    Result<Done> readBytes(std::string_view bytes, const std::string& path, Texture& texture);
    Result<Done> readBytes(std::string_view bytes, const std::string& path, Tileset& tileset);
    Result<Done> readBytes(std::string_view bytes, const std::string& path, AnimationSet& set);
    Result<Done> readBytes(std::string_view bytes, const std::string& path, FileBytes& file);
    Result<Done> readBytes(std::string_view bytes, const std::string& path, WatchedFile& file);

    /// Loads the textures that an asset uses and adds references to them, which releaseParts removes.
    void acquireParts(const Tileset& tileset);
    void acquireParts(const AnimationSet& set);
    template <class T>
    void acquireParts(const T&) {}
    void releaseParts(const Tileset& tileset);
    void releaseParts(const AnimationSet& set);
    template <class T>
    void releaseParts(const T&) {}
    void acquireTexture(const std::string& path);
    void releaseTexture(TextureId id);

    void report(Error error);
    void logLoaded(const std::string& path, const Texture& texture) const;
    template <class T>
    void logLoaded(const std::string& path, const T&) const;

    template <class Visit>
    void visitTable(AssetKind kind, Visit&& visit);
    template <class Visit>
    void visitTable(AssetKind kind, Visit&& visit) const;

    Path root_;
    Path engineRoot_;
    KindTables tables_;
    std::vector<Error> errors_;
    std::size_t pollAt_ = 0;
    std::size_t loads_ = 0;
    /// Revision of assets loaded from now on. Larger than all revisions before the last unloading, so that a
    /// caller that caches data of an asset notices when it was unloaded and loaded again.
    std::uint32_t firstRevision_ = 1;
};

}  // namespace plumb
