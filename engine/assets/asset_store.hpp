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

/// A file whose bytes are the asset: a sound or a font.
struct FileBytes {
    std::string bytes;
};

/// A file that others load and the store only watches: a scene or a prefab.
struct WatchedFile {};

/// One asset that `pollChanges` replaced, or a watched file that changed.
struct AssetChange {
    AssetKind kind = AssetKind::None;
    TextId path;
};

/// Every asset of a project: loads each file once, hands out ids, and gives a placeholder for what is missing
/// or broken, so that a game goes on. All paths stay inside the project; `engine:fonts/…` names the engine's
/// own files.
///
/// Pictures are decoded when their pixels are first asked for; a game without a screen never decodes one.
class AssetStore {
public:
    /// @param root        the project's folder; empty for a store of what code makes
    /// @param engineRoot  the engine's own assets/ folder; empty when there is none
    explicit AssetStore(Path root = {}, Path engineRoot = {});

    /// Load a file once and give its id: always the same for the same path, also when the file is missing.
    /// What went wrong is in `errors()`. A bare name that does not lie in the root is looked for in assets/.
    TextureId loadTexture(std::string_view path);
    TilesetId loadTileset(std::string_view path);
    AnimationId loadAnimation(std::string_view path);
    SoundId loadSound(std::string_view path);
    FontId loadFont(std::string_view path);

    /// As above by kind; scenes and prefabs are only watched. For readers that go by reflection.
    void load(AssetKind kind, std::string_view path);

    /// Put what code made under a name, in place of what had that name.
    TextureId addTexture(std::string_view name, Image image);
    TilesetId addTileset(std::string_view name, Tileset tileset);
    AnimationId addAnimation(std::string_view name, AnimationSet set);

    /// The asset, or null when it was never loaded. A few ns.
    [[nodiscard]] const Texture* find(TextureId id) const { return valueOf(textures(), id.path); }
    [[nodiscard]] const Tileset* find(TilesetId id) const { return valueOf(tilesets(), id.path); }
    [[nodiscard]] const AnimationSet* find(AnimationId id) const { return valueOf(animations(), id.path); }
    [[nodiscard]] const FileBytes* find(SoundId id) const { return valueOf(sounds(), id.path); }
    [[nodiscard]] const FileBytes* find(FontId id) const { return valueOf(fonts(), id.path); }

    /// The asset, or a placeholder: a checker of magenta and black, a set without tiles, a set without clips.
    [[nodiscard]] const Tileset& tileset(TilesetId id) const;
    [[nodiscard]] const AnimationSet& animation(AnimationId id) const;

    /// The pixels, decoded at the first request. Valid until the texture changes or is unloaded.
    const Image& image(TextureId id);

    /// Frees decoded pixels, e.g. once they are on the GPU; asking again decodes again. What code made stays.
    void dropImage(TextureId id);

    /// The path or name that was loaded; empty for an unknown id.
    [[nodiscard]] std::string_view pathOf(AssetKind kind, TextId id) const;
    template <AssetKind Kind>
    [[nodiscard]] std::string_view pathOf(AssetRef<Kind> id) const {
        return pathOf(Kind, id.path);
    }

    /// True when a placeholder stands in for the asset.
    [[nodiscard]] bool isMissing(AssetKind kind, TextId id) const;
    /// Grows when the asset is replaced; 0 for an unknown id.
    [[nodiscard]] std::uint32_t revisionOf(AssetKind kind, TextId id) const;

    /// Count the users of an asset. A tileset or an animation needs its pictures by itself.
    void acquire(AssetKind kind, TextId id);
    void release(AssetKind kind, TextId id);
    [[nodiscard]] int references(AssetKind kind, TextId id) const;

    /// Forgets the files without users; ids stay valid and load again. What code made stays.
    /// @return how many
    std::size_t unloadUnused();

    /// How often a file was read, each time it was loaded anew counted.
    [[nodiscard]] std::size_t loadCount() const { return loads_; }
    /// Memory that loaded assets hold: decoded pixels, bytes of files, tables (bytes).
    [[nodiscard]] std::size_t byteCount() const;

    /// Looks at the next few files and reloads those that changed. A file that became broken is listed in
    /// `errors()` and the old asset stays.
    /// @param budget  files to look at; the next call goes on behind them. About 2 us each
    std::vector<AssetChange> pollChanges(std::size_t budget = 32);

    /// Reads a file again now, after the caller has written it. A broken one is listed in `errors()` and the
    /// old asset stays. @return whether it was loaded
    bool refresh(AssetKind kind, TextId id);

    /// What went wrong since the last `clearErrors`, at most a thousand.
    [[nodiscard]] const std::vector<Error>& errors() const { return errors_; }
    void clearErrors() { errors_.clear(); }

    /// Whether loading writes to the log. On at first.
    bool logging = true;

    [[nodiscard]] const Path& root() const { return root_; }
    [[nodiscard]] std::size_t size() const;

    /// Where a path of the project lies on this machine.
    /// @error  it leaves the project
    [[nodiscard]] Result<Path> resolve(std::string_view path) const;

private:
    template <AssetKind Kind, class T>
    struct Shelf {
        static constexpr AssetKind kKind = Kind;
        AssetTable<T> table;
    };
    using Shelves = std::tuple<Shelf<AssetKind::Texture, Texture>, Shelf<AssetKind::Tileset, Tileset>,
                               Shelf<AssetKind::Animation, AnimationSet>, Shelf<AssetKind::Sound, FileBytes>,
                               Shelf<AssetKind::Font, FileBytes>, Shelf<AssetKind::Scene, WatchedFile>,
                               Shelf<AssetKind::Prefab, WatchedFile>>;

    template <class T>
    static const T* valueOf(const AssetTable<T>& table, TextId id) {
        const AssetEntry<T>* entry = table.find(id);
        return entry == nullptr ? nullptr : &entry->value;
    }
    [[nodiscard]] const AssetTable<Texture>& textures() const { return std::get<0>(shelves_).table; }
    [[nodiscard]] const AssetTable<Tileset>& tilesets() const { return std::get<1>(shelves_).table; }
    [[nodiscard]] const AssetTable<AnimationSet>& animations() const { return std::get<2>(shelves_).table; }
    [[nodiscard]] const AssetTable<FileBytes>& sounds() const { return std::get<3>(shelves_).table; }
    [[nodiscard]] const AssetTable<FileBytes>& fonts() const { return std::get<4>(shelves_).table; }

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

    /// Loads and counts the pictures that an asset is made of, or gives them back.
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
    void visitShelf(AssetKind kind, Visit&& visit);
    template <class Visit>
    void visitShelf(AssetKind kind, Visit&& visit) const;

    Path root_;
    Path engineRoot_;
    Shelves shelves_;
    std::vector<Error> errors_;
    std::size_t pollAt_ = 0;
    std::size_t loads_ = 0;
    /// Of what is loaded now: past all those before the last unloading, so that a caller that remembers what
    /// was made of an asset sees that it is another one.
    std::uint32_t firstRevision_ = 1;
};

}  // namespace plumb
