#include "app/saved_game.hpp"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "app/project.hpp"
#include "app/scene_game.hpp"
#include "core/random.hpp"
#include "ecs/component_type.hpp"
#include "gameplay/game_functions.hpp"
#include "gameplay/game_progress.hpp"
#include "gameplay/game_requests.hpp"
#include "gameplay/tweens.hpp"
#include "reflect/convert_component.hpp"
#include "scene/components/transform.hpp"
#include "scene/loaded_scene.hpp"
#include "scene/physics/physics_state.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_type.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb {
namespace {

std::unique_ptr<SceneGame> gameOf(const char* project, std::string scene = {}, std::uint64_t seed = 1) {
    Result<Project> loaded = loadProject(test::sourceFolder() / "projects" / project);
    if (!loaded) return nullptr;
    auto game = std::make_unique<SceneGame>(std::move(*loaded), std::move(scene), seed);
    game->onCreate();
    return game;
}

/// Random keys and mouse positions.
InputFrame randomFrame(Random& random) {
    InputFrame frame;
    for (const Key key : {Key::Right, Key::Left, Key::Space, Key::Enter, Key::Up, Key::X})
        frame.set(key, random.below(key == Key::Right ? 2 : 6) == 0);
    frame.setMouse({random.between(0.0f, 320.0f), random.between(0.0f, 180.0f)});
    frame.mouseButtons = random.below(8) == 0 ? 1 : 0;
    return frame;
}

Result<Done> loadFrom(const std::string& bytes, Game& game) {
    std::vector<Error> problems;
    Result<Snapshot> snapshot = readSavedGame(bytes, game.world, "P", "test", problems);
    if (!snapshot) return snapshot.error();
    for (const Error& problem : problems) ADD_FAILURE() << problem.text();
    return game.load(*snapshot);
}

struct Played {
    const char* project;
    const char* scene;
};

class SavedGames : public ::testing::TestWithParam<Played> {};

TEST_P(SavedGames, goOnInAnotherProgramAsIfTheyHadNotBeenSaved) {
    Random random = Random::seeded(5);
    for (int round = 0; round < 3; ++round) {
        const auto game = gameOf(GetParam().project, GetParam().scene);
        ASSERT_NE(game, nullptr);
        for (std::uint32_t tick = 20 + random.below(200); tick > 0; --tick)
            tickGame(*game, randomFrame(random));
        const Result<std::string> saved = savedGame(game->world, "P");
        ASSERT_TRUE(saved) << saved.error().text();
        const std::uint64_t hash = game->world.hash();

        // A game in which other types were used, at another time.
        const auto other = gameOf(GetParam().project);
        for (std::uint32_t tick = random.below(300); tick > 0; --tick) tickGame(*other, randomFrame(random));
        const auto loaded = loadFrom(*saved, *other);
        ASSERT_TRUE(loaded) << loaded.error().text();
        ASSERT_EQ(other->world.hash(), hash);
        EXPECT_EQ(game->world.hash(), hash) << "saving changes nothing";
        for (int tick = 0; tick < 240; ++tick) {
            const InputFrame frame = randomFrame(random);
            tickGame(*game, frame);
            tickGame(*other, frame);
            ASSERT_EQ(game->world.hash(), other->world.hash()) << "round " << round << ", tick " << tick;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, SavedGames,
                         ::testing::Values(Played{"platformer", "scenes/level1.scene.json"},
                                           Played{"platformer", "scenes/level3.scene.json"},
                                           Played{"platformer", ""},
                                           Played{"arena", "scenes/arena.scene.json"},
                                           Played{"physics-playground", "scenes/ragdolls.scene.json"},
                                           Played{"physics-playground", "scenes/softbodies.scene.json"},
                                           Played{"physics-playground", "scenes/cloth.scene.json"},
                                           Played{"physics-playground", "scenes/buoyancy.scene.json"},
                                           Played{"physics-playground", "scenes/pinball.scene.json"},
                                           Played{"physics-playground", "scenes/pyramid.scene.json"},
                                           Played{"physics-lab", "scenes/springs.scene.json"}));

class SavedGame : public ::testing::Test {
protected:
    test::TemporaryFolder folder{test::memoryFolder()};
    std::unique_ptr<SceneGame> game = gameOf("platformer", "scenes/level1.scene.json");
    SaveSlots slots{folder.path, "P"};

    void play(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            InputFrame frame;
            frame.set(Key::Right, true);
            tickGame(*game, frame);
        }
    }
};

TEST_F(SavedGame, damageIsAnErrorOrChangesNothing) {
    play(60);
    const std::uint64_t hash = game->world.hash();
    const Result<std::string> saved = savedGame(game->world, "P");
    ASSERT_TRUE(saved);
    Random random = Random::seeded(11);
    int refused = 0;
    for (int round = 0; round < 2000; ++round) {
        std::string bytes = test::withWrongBytes(*saved, random);
        if (random.below(4) == 0) bytes.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
        if (random.below(8) == 0) bytes += "more";
        std::vector<Error> problems;
        const Result<Snapshot> read = readSavedGame(bytes, game->world, "P", "test", problems);
        if (!read) {
            ++refused;
            EXPECT_FALSE(read.error().remedy.empty());
            continue;
        }
        game->world.restore(*read);
        ASSERT_EQ(game->world.hash(), hash);
    }
    EXPECT_GT(refused, 1900);
}

TEST_F(SavedGame, aStateWithWrongBytesNeverCrashesWhenItIsRead) {
    play(60);
    std::vector<Error> problems;
    const std::string state = game->world.toBytes(problems);
    ASSERT_TRUE(problems.empty());
    Random random = Random::seeded(12);
    for (int round = 0; round < 300; ++round) {
        // Most wrong bytes change values only; the beginning has the sizes.
        std::string bytes = state;
        const std::uint32_t most = random.below(2) == 0 ? 4096u : static_cast<std::uint32_t>(bytes.size());
        bytes[random.below(most)] = static_cast<char>(random.below(256));
        if (random.below(3) == 0) bytes.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
        static_cast<void>(game->world.snapshotFrom(bytes, problems));
    }
}

TEST_F(SavedGame, ofAnotherGameOrANewerVersionIsRefused) {
    Result<std::string> saved = savedGame(game->world, "Q");
    ASSERT_TRUE(saved);
    std::vector<Error> problems;
    const Result<Snapshot> other = readSavedGame(*saved, game->world, "P", "1.save", problems);
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().what, "the game \"Q\" saved it, and this is \"P\"");
    (*saved)[8] = 2;
    const Result<Snapshot> newer = readSavedGame(*saved, game->world, "Q", "1.save", problems);
    ASSERT_FALSE(newer);
    EXPECT_EQ(newer.error().what, "a newer version of the game saved it");
    EXPECT_FALSE(readSavedGame("text", game->world, "P", "1.save", problems));
    EXPECT_FALSE(readSavedGame("", game->world, "P", "1.save", problems));
}

TEST_F(SavedGame, staysInItsSlotIfTheDiskIsFull) {
    play(10);
    ASSERT_TRUE(slots.save(game->world, 3));
    EXPECT_EQ(slots.filled(), 4u);
    const std::uint64_t hash = game->world.hash();
    play(50);
    const std::uint64_t later = game->world.hash();
    {
        const test::FileSizeLimit limit{100};
        const Result<Done> failed = slots.save(game->world, 3);
        ASSERT_FALSE(failed);
        EXPECT_FALSE(slots.save(game->world, 4));
    }
    EXPECT_EQ(game->world.hash(), later);
    EXPECT_EQ(slots.filled(), 4u);
    EXPECT_EQ(SaveSlots(folder.path, "P").filled(), 4u);
    const Result<SaveSlots::Saved> saved = slots.read(game->world, 3);
    ASSERT_TRUE(saved);
    ASSERT_TRUE(game->load(saved->state));
    EXPECT_EQ(game->world.hash(), hash);
    EXPECT_FALSE(slots.read(game->world, 4));
}

TEST_F(SavedGame, cannotBeSavedInAFileThatIsAFolder) {
    play(5);
    // Also for root: it may write into any folder.
    std::filesystem::create_directories(slots.fileOf(2) / "inside");
    EXPECT_FALSE(slots.save(game->world, 2));
    EXPECT_FALSE(slots.read(game->world, 2));
    std::filesystem::remove_all(folder.path / "saves");
    ASSERT_TRUE(writeFile(folder.path / "saves", "a file"));
    const Result<Done> failed = slots.save(game->world, 1);
    ASSERT_FALSE(failed);
    EXPECT_FALSE(failed.error().remedy.empty());
}

TEST(SavedFile, isWholeAtEveryMomentOfSaving) {
    const test::TemporaryFolder folder{test::memoryFolder()};
    const Path file = folder.path / "1.save";
    std::string states[2];
    World world;
    for (std::string& state : states) {
        for (int i = 0; i < 2000; ++i) world.createEntity().addComponent<Transform>();
        state = *savedGame(world, "P");
    }
    ASSERT_TRUE(writeFile(file, states[0]));
    Random random = Random::seeded(3);
    int seen[2] = {};
    for (int round = 0; round < 1000; ++round) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (std::size_t i = 0;; ++i) static_cast<void>(writeFile(file, states[i % 2]));
        }
        usleep(random.below(700));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        const Result<std::string> bytes = readFile(file);
        ASSERT_TRUE(bytes);
        const int which = *bytes == states[0] ? 0 : 1;
        ASSERT_EQ(*bytes, states[which]) << "round " << round;
        ++seen[which];
    }
    EXPECT_GT(seen[0], 0);
    EXPECT_GT(seen[1], 0);
    std::vector<Error> problems;
    EXPECT_TRUE(readSavedGame(states[1], world, "P", "1", problems));
}

TEST_F(SavedGame, keepsTweensAndTexts) {
    const Entity entity = game->world.createEntity();
    entity.addComponent<Transform>();
    tween(game->world, entity.id(), &Transform::rotation, 1.5f, 1.0f);
    showText(game->world, "score", "12");
    const Result<std::string> saved = savedGame(game->world, "P");
    ASSERT_TRUE(saved);
    const auto other = gameOf("platformer");
    ASSERT_TRUE(loadFrom(*saved, *other));
    for (int i = 0; i < 90; ++i) {
        tickGame(*game, {});
        tickGame(*other, {});
    }
    EXPECT_EQ(other->world.get<Transform>(entity.id()).rotation, 1.5f);
    EXPECT_EQ(other->world.hash(), game->world.hash());
}

// ---- other versions of types

class SavedTypes : public ::testing::Test {
protected:
    TypeRegistry types;
    Random random = Random::seeded(7);

    const TypeInfo& add(TypeInfo type) {
        const TypeInfo& known = types.update(std::move(type));
        updateComponentType(known);
        return known;
    }
};

TEST_F(SavedTypes, keepEveryFieldThatStaysInAThousandRandomEdits) {
    const TypeKey key = nextTypeKey();
    const TypeInfo* type = &add(made_types::random(random, key, "Made"));
    for (int edit = 0; edit < 1000; ++edit) {
        World world{types};
        const Entity entity = world.createEntity();
        auto* bytes = static_cast<std::byte*>(world.add(*type, entity.id()));
        for (std::size_t i = 0; i < type->size; ++i) bytes[i] = static_cast<std::byte>(random.below(2));
        const std::vector<std::byte> before(bytes, bytes + type->size);
        std::vector<Error> problems;
        const std::string saved = world.toBytes(problems);
        TypeInfo old = *type;
        old.defaults.clear();  // a value of the player is kept, even if it was the default

        World other{types};
        type = &add(made_types::random(random, key, "Made"));
        const Result<Snapshot> snapshot = other.snapshotFrom(saved, problems);
        ASSERT_TRUE(snapshot) << snapshot.error().text();
        ASSERT_TRUE(problems.empty()) << problems.front().text();
        other.restore(*snapshot);
        std::vector<std::byte> expected = type->defaults;
        convertComponent(old, before.data(), *type, expected.data());
        const void* now = other.find(*type, entity.id());
        ASSERT_NE(now, nullptr);
        ASSERT_EQ(std::memcmp(now, expected.data(), expected.size()), 0) << "edit " << edit;
    }
}

TEST_F(SavedTypes, thatAreGoneAreLeftOut) {
    World world{types};
    const TypeInfo& type = add(made_types::random(random, nextTypeKey(), "Gone"));
    const Entity entity = world.createEntity();
    world.add(type, entity.id());
    std::vector<Error> problems;
    const std::string saved = world.toBytes(problems);
    types.remove("Gone");
    TypeInfo renamed = type;
    renamed.name = "Another";
    add(std::move(renamed));
    World other{types};
    const Result<Snapshot> snapshot = other.snapshotFrom(saved, problems);
    ASSERT_TRUE(snapshot);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].where, "component Gone");
    other.restore(*snapshot);
    EXPECT_TRUE(other.alive(entity.id()));
}

struct Whole {
    int value = 3;
};
struct Unsaved {
    static constexpr bool kNotSaved = true;
    int value = 3;
};
struct Listed {
    std::vector<int> values;
};

TEST(SavedResources, arePlainDataOrSayHowTheyAreSaved) {
    World world, other;
    world.resource<Whole>().value = 8;
    world.resource<Unsaved>().value = 8;
    other.resource<Unsaved>().value = 5;
    std::vector<Error> problems;
    const std::string saved = world.toBytes(problems);
    ASSERT_TRUE(problems.empty());
    const Result<Snapshot> snapshot = other.snapshotFrom(saved, problems);
    ASSERT_TRUE(snapshot);
    other.restore(*snapshot);
    EXPECT_EQ(other.resource<Whole>().value, 8);
    EXPECT_EQ(other.resource<Unsaved>().value, 5);

    world.resource<Listed>().values = {1, 2};
    static_cast<void>(world.toBytes(problems));
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(problems[0].where.find("Listed"), std::string::npos);
}

TEST(SavedResources, areRefusedIfTheEffectsOfASceneAreDamaged) {
    LoadedScene scene, other;
    scene.effects["bloom"] = true;
    std::string bytes;
    StateArchive writer = StateArchive::writer(bytes);
    scene.archive(writer);
    StateArchive reader = StateArchive::reader(bytes);
    other.archive(reader);
    EXPECT_TRUE(reader.ok());
    EXPECT_EQ(other.effects, scene.effects);
    bytes[bytes.find("bloom") - 1] = '?';
    StateArchive damaged = StateArchive::reader(bytes);
    other.archive(damaged);
    EXPECT_FALSE(damaged.ok());
}

}  // namespace
}  // namespace plumb
