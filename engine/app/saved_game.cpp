#include "app/saved_game.hpp"

#include <utility>

#include "codec/compression.hpp"
#include "core/hash.hpp"
#include "core/log.hpp"
#include "core/state_archive.hpp"
#include "core/text.hpp"
#include "input/input_frame.hpp"

namespace plumb {
namespace {

constexpr std::string_view kMark = "PLUMBSAV";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kMostBytes = std::size_t{256} << 20;  ///< of the state
constexpr std::size_t kMostName = 1024;

struct Header {
    std::uint32_t version = kVersion;
    std::string project;
    std::uint64_t bytes = 0, packed = 0, hash = 0;

    void archive(StateArchive& archive) {
        archive.number(version);
        if (version != kVersion) return;  // the rest may be another
        std::uint32_t name = static_cast<std::uint32_t>(project.size());
        archive.number(name);
        if (name > kMostName) archive.fail();
        if (!archive.ok()) return;
        project.resize(name);
        archive.block(project.data(), name);
        archive.number(bytes);
        archive.number(packed);
        archive.number(hash);
    }
};

std::uint64_t hashOf(const Header& header, std::string_view packed) {
    LaneHasher hasher;
    hasher.addBytes(header.project.data(), header.project.size());
    hasher.add(header.bytes);
    hasher.addBytes(packed.data(), packed.size());
    return hasher.value();
}

Error damaged(const std::string& where) {
    return {where, "the saved game is damaged", "load another one; saving in this slot replaces it"};
}

}  // namespace

Result<std::string> savedGame(const World& world, std::string_view project) {
    std::vector<Error> problems;
    const std::string state = world.toBytes(problems);
    if (!problems.empty()) return problems.front();
    if (state.size() > kMostBytes)
        return Error{"saved game", format("the state has {} bytes, more than {}", state.size(), kMostBytes),
                     "have fewer entities or smaller tile grids"};
    const std::string packed = packZlib(state);
    Header header;
    header.project = project.substr(0, kMostName);
    header.bytes = state.size();
    header.packed = packed.size();
    header.hash = hashOf(header, packed);
    std::string file{kMark};
    StateArchive archive = StateArchive::writer(file);
    header.archive(archive);
    return file + packed;
}

Result<Snapshot> readSavedGame(std::string_view bytes, const World& world, std::string_view project,
                               const std::string& where, std::vector<Error>& problems) {
    if (!startsWith(bytes, kMark)) return Error{where, "the file is not a saved game", "load another one"};
    bytes.remove_prefix(kMark.size());
    StateArchive archive = StateArchive::reader(bytes);
    Header header;
    header.archive(archive);
    if (archive.ok() && header.version > kVersion)
        return Error{where, "a newer version of the game saved it", "update the game"};
    if (!archive.ok() || header.version != kVersion || archive.left() != header.packed) return damaged(where);
    const std::string_view packed = bytes.substr(bytes.size() - archive.left());
    if (header.hash != hashOf(header, packed) || header.bytes > kMostBytes) return damaged(where);
    if (header.project != project.substr(0, kMostName))
        return Error{where, format("the game \"{}\" saved it, and this is \"{}\"", header.project, project),
                     "load a saved game of this game"};
    const Result<std::string> state = unpackZlib(packed, header.bytes, where);
    if (!state || state->size() != header.bytes) return damaged(where);
    Result<Snapshot> snapshot = world.snapshotFrom(*state, problems);
    if (!snapshot) return Error{where, snapshot.error().what, snapshot.error().remedy};
    return snapshot;
}

SaveSlots::SaveSlots(Path folder, std::string project)
    : folder_{std::move(folder)}, project_{std::move(project)} {
    for (int slot = 1; slot <= kSaveSlots; ++slot) {
        if (fileExists(fileOf(slot))) filled_ |= 1u << (slot - 1);
    }
}

Path SaveSlots::fileOf(int slot) const { return folder_ / "saves" / format("{}.save", slot); }

Result<Done> SaveSlots::save(const World& world, int slot) {
    const Result<std::string> file = savedGame(world, project_);
    if (!file) return file.error();
    Result<Done> written = writeFile(fileOf(slot), *file);
    if (written) filled_ |= 1u << (slot - 1);
    return written;
}

Result<SaveSlots::Saved> SaveSlots::read(const World& world, int slot) const {
    const Path path = fileOf(slot);
    if (!fileExists(path)) return Error{format("slot {}", slot), "no game is saved in it", "save one first"};
    Result<std::string> file = readFile(path);
    if (!file) return file.error();
    std::vector<Error> problems;
    Result<Snapshot> snapshot = readSavedGame(*file, world, project_, path.generic_string(), problems);
    if (!snapshot) return snapshot.error();
    for (const Error& problem : problems) logWarning("Game", problem);
    return Saved{std::move(*file), std::move(*snapshot)};
}

}  // namespace plumb
