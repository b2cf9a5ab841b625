#include "app/game_content.hpp"

#include <gtest/gtest.h>

#include "app/effect_rows.hpp"
#include "app/game.hpp"
#include "gameplay/systems.hpp"
#include "reflect/type_check.hpp"
#include "scene/components/transform.hpp"
#include "scene/systems/physics_system.hpp"

// Versions of a project's code. Components must not be in an unnamed namespace.
namespace plumb {
namespace first {

struct Turret {
    float rate = 2.0f;
    int shots = 0;

    static void describe(TypeBuilder<Turret>& type) {
        type.name("Turret").doc("Shoots.");
        type.field<&Turret::rate>("rate");
        type.field<&Turret::shots>("shots");
    }
};

struct Score {
    int hits = 0;

    static void describe(TypeBuilder<Score>& type) {
        type.name("Score");
        type.field<&Score::hits>("hits");
    }
};

struct Shot {
    int number = 0;
};

struct TurretSystem {
    void update(World& world, float) const {
        for (auto [entity, turret] : world.query<Turret>()) world.emit(Shot{++turret.shots});
    }
};

void count(World& world, const Shot& shot) { world.resource<Score>().hits += shot.number; }

struct Hit {
    int number = 0;
};

/// Emits its own event, as a chain reaction does.
void chain(World& world, const Hit& hit) {
    world.resource<Score>().hits += hit.number;
    world.emit(hit);
}

Module module() {
    Module module;
    module.components<Turret>();
    module.resources<Score>();
    module.system<TurretSystem, Turret>(before<PhysicsSystem>());
    module.on<Shot, count>();
    return module;
}

}  // namespace first

namespace second {

struct Turret {
    int fired = 0;
    float rate = 1.0f;
    float reach = 5.0f;

    static void describe(TypeBuilder<Turret>& type) {
        type.name("Turret").doc("Shoots twice.");
        type.field<&Turret::fired>("fired").was("shots");
        type.field<&Turret::rate>("rate");
        type.field<&Turret::reach>("reach");
    }
};

struct Score {
    float hits = 0.0f;

    static void describe(TypeBuilder<Score>& type) {
        type.name("Score");
        type.field<&Score::hits>("hits");
    }
};

struct TurretSystem {
    void update(World& world, float) const {
        for (auto [entity, turret] : world.query<Turret>()) turret.fired += 100;
    }
};

Module module() {
    Module module;
    module.components<Turret>();
    module.resources<Score>();
    module.system<TurretSystem, Turret>(after<CollectSystem>());
    return module;
}

}  // namespace second

namespace wrong {

/// A component or resource of this name, which each test sets.
struct Named {
    static inline std::string_view name;
    static void describe(TypeBuilder<Named>& type) { type.name(name); }
};
struct OtherNamed {
    static void describe(TypeBuilder<OtherNamed>& type) { type.name(Named::name); }
};

}  // namespace wrong

namespace mistaken {

struct Nameless {
    int value = 0;

    static void describe(TypeBuilder<Nameless>& type) { type.field<&Nameless::value>("value"); }
};
struct Twice {
    int value = 0;

    static void describe(TypeBuilder<Twice>& type) {
        type.name("Twice");
        type.field<&Twice::value>("value");
        type.field<&Twice::value>("other");
    }
};

}  // namespace mistaken

namespace {

std::size_t positionOf(const GameContent& content, std::string_view name) {
    for (std::size_t i = 0; i < content.systems().size(); ++i) {
        if (content.systems()[i].name == name) return i;
    }
    return content.systems().size();
}

class GameContentTest : public ::testing::Test {
protected:
    std::vector<Error> problems;
};

TEST_F(GameContentTest, containsTheCodeInItsPlaceInTheOrder) {
    const GameContent content{first::module(), problems};
    EXPECT_TRUE(problems.empty());
    ASSERT_NE(content.types().find("Turret"), nullptr);
    EXPECT_EQ(positionOf(content, "TurretSystem") + 1, positionOf(content, PhysicsSystem::kName));
    EXPECT_EQ(content.systems().size(), systemTable().size() + 2);
    EXPECT_NE(content.effects().find("TurretSystem"), EffectTable::kNone);
    const GameContent other{second::module(), problems};
    EXPECT_EQ(positionOf(other, "TurretSystem"), positionOf(other, CollectSystem::kName) + 1);
}

TEST_F(GameContentTest, runsSystemsAndHandlersOnlyWhenTheyAreRequired) {
    const GameContent content{first::module(), problems};
    Game game{content};
    content.addSystems(game.world);
    const std::size_t effect = content.effects().find("TurretSystem");
    tickGame(game, {});
    EXPECT_EQ(game.effects.runsOf(game.world, effect), 0u);
    const Entity entity = game.world.createEntity();
    entity.addComponent<first::Turret>();
    for (int i = 0; i < 3; ++i) tickGame(game, {});
    EXPECT_EQ(entity.get<first::Turret>().shots, 3);
    EXPECT_EQ(game.world.resource<first::Score>().hits, 1 + 2 + 3);
    EXPECT_EQ(game.effects.runsOf(game.world, effect), 3u);
}

TEST_F(GameContentTest, codeWithSystemsMayReadGamepads) {
    const World empty;
    const auto readsPads = [&](const Module& code) {
        const GameContent content{code, problems};
        const EffectTable& effects = content.effects();
        return effects.rows()[effects.find("pads")].isRequired(empty);
    };
    EXPECT_FALSE(readsPads(Module{}));
    EXPECT_TRUE(readsPads(first::module()));
}

TEST_F(GameContentTest, reportsNamesThatAreUsedAndUnknownSystems) {
    wrong::Named::name = "Transform";
    Module module;
    module.components<wrong::Named>();
    module.system<first::TurretSystem>({.before = "physic"});
    module.system<second::TurretSystem>();
    const GameContent content{module, problems};
    ASSERT_EQ(problems.size(), 3u);
    EXPECT_EQ(
        problems[0].text(),
        "code: component \"Transform\": there is a component of this name already; choose another name in "
        "describe()");
    EXPECT_EQ(problems[1].what, "there is no system \"physic\" to run before or after");
    EXPECT_EQ(problems[2].where, "code: system \"TurretSystem\"");
    EXPECT_EQ(content.types().all().size(), engineContent().types().all().size());
}

TEST_F(GameContentTest, reportsMistakesInDescriptions) {
    Module module;
    module.components<mistaken::Nameless, mistaken::Twice>();
    std::vector<Error> found;
    const GameContent content{std::move(module), found};
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].where, "code: component \"Nameless\"");
    EXPECT_EQ(found[1].where, "code: component \"Twice\", field \"other\"");
    EXPECT_EQ(content.types().find(""), nullptr);
}

TEST_F(GameContentTest, theComponentsOfTheEngineHaveNoMistakes) {
    std::vector<Error> found;
    const GameContent content{Module{}, found};
    EXPECT_GT(content.types().all().size(), 70u);
    for (const TypeInfo& type : content.types().all()) {
        for (const Error& mistake : mistakesOf(type)) ADD_FAILURE() << mistake.text();
    }
}

TEST_F(GameContentTest, reportsTwoComponentsOfOneNameAgainWhenTheCodeIsLoadedAgain) {
    wrong::Named::name = "Turret";
    Module module = first::module();
    module.components<wrong::Named>();
    GameContent content{module, problems};
    EXPECT_EQ(problems.size(), 1u);
    static_cast<void>(content.update(module, problems));
    EXPECT_EQ(problems.size(), 2u);
    EXPECT_EQ(content.types().find("Turret")->key, typeKey<first::Turret>());
}

TEST_F(GameContentTest, reportsResourcesWithTheNameOfAComponentOrOfAnotherResource) {
    wrong::Named::name = "Turret";
    Module module = first::module();
    module.resources<wrong::Named>();
    const GameContent content{module, problems};
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].text(),
              "code: resource \"Turret\": there is a component of this name already; choose another name in "
              "describe()");

    wrong::Named::name = "Lives";
    Module two;
    two.resources<wrong::Named, wrong::OtherNamed>();
    const GameContent other{two, problems};
    ASSERT_EQ(problems.size(), 2u);
    EXPECT_EQ(problems[1].what, "there is a resource of this name already");
}

TEST_F(GameContentTest, namesAHandlerThatIsRegisteredTwiceAsTheCodeWritesIt) {
    Module module;
    module.on<first::Shot, first::count>();
    module.on<first::Shot, first::count>();
    module.on<first::Shot, first::count>({.after = "physic"});
    module.on<first::Hit, first::chain>({.after = "physic"});
    const GameContent content{module, problems};
    ASSERT_EQ(problems.size(), 3u);
    EXPECT_EQ(problems[0].where.find("code: module.on<"), 0u) << problems[0].where;
    EXPECT_NE(problems[0].where.find("first::count>"), std::string::npos) << problems[0].where;
    EXPECT_EQ(problems[0].what, "this function is registered for this event already");
    EXPECT_EQ(problems[0].remedy.find("kName"), std::string::npos);
    EXPECT_EQ(problems[2].where.find("code: module.on<"), 0u) << problems[2].where;
    EXPECT_EQ(problems[2].what, "there is no system \"physic\" to run before or after");
}

TEST_F(GameContentTest, aHandlerReceivesTheEventsThatItEmitsInTheNextTick) {
    Module module = first::module();
    module.on<first::Hit, first::chain>();
    const GameContent content{module, problems};
    Game game{content};
    content.addSystems(game.world);
    game.world.beginTick();
    game.world.emit(first::Hit{1});
    game.world.emit(first::Hit{2});
    game.world.update(1.0f / 60.0f);
    EXPECT_EQ(game.world.resource<first::Score>().hits, 1 + 2);
    EXPECT_EQ(game.world.events<first::Hit>().size(), 4u) << "later systems read them";
    game.world.beginTick();
    EXPECT_TRUE(game.world.events<first::Hit>().empty()) << "those of a tick end with it";
    game.world.update(1.0f / 60.0f);
    EXPECT_EQ(game.world.resource<first::Score>().hits, 2 * (1 + 2)) << "the handler receives each once";
}

struct Unnamed {};

TEST_F(GameContentTest, typesOfUnnamedNamespacesAreRecognized) {
    static_assert(isInUnnamedNamespace(compilerTypeName<Unnamed>()));
    static_assert(!isInUnnamedNamespace(compilerTypeName<first::Turret>()));
    static_assert(!isInUnnamedNamespace(compilerTypeName<Transform>()));
}

TEST_F(GameContentTest, anotherVersionKeepsTheStateOfARunningGame) {
    GameContent content{first::module(), problems};
    Game game{content};
    content.addSystems(game.world);
    const Entity entity = game.world.createEntity();
    entity.addComponent<first::Turret>(7.0f);
    for (int i = 0; i < 3; ++i) tickGame(game, {});
    const TypeInfo& type = *content.types().find("Turret");

    const ContentChange change = content.update(second::module(), problems);
    convertWorld(game.world, content, change);
    game.effects.tableChanged();

    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(&type, content.types().find("Turret")) << "references stay valid";
    EXPECT_EQ(type.doc, "Shoots twice.");
    ASSERT_TRUE(game.world.has<second::Turret>(entity.id()));
    EXPECT_EQ(entity.get<second::Turret>().fired, 3) << "the field is found by its former name";
    EXPECT_EQ(entity.get<second::Turret>().rate, 7.0f);
    EXPECT_EQ(entity.get<second::Turret>().reach, 5.0f);
    EXPECT_EQ(game.world.resource<second::Score>().hits, 6.0f);
    tickGame(game, {});
    EXPECT_EQ(entity.get<second::Turret>().fired, 103) << "the new system runs, the old one does not";
    EXPECT_EQ(game.effects.runsOf(game.world, content.effects().find("TurretSystem")), 1u);
}

TEST_F(GameContentTest, withoutCodeIsThatOfTheEngineAgain) {
    GameContent content{first::module(), problems};
    Game game{content};
    content.addSystems(game.world);
    const Entity entity = game.world.createEntity();
    entity.addComponent<first::Turret>();
    convertWorld(game.world, content, content.update({}, problems));
    game.effects.tableChanged();
    EXPECT_EQ(content.types().find("Turret"), nullptr);
    EXPECT_EQ(content.systems().size(), systemTable().size());
    EXPECT_FALSE(game.world.has<first::Turret>(entity.id()));
    tickGame(game, {});
    EXPECT_EQ(game.world.systemNames().size(), systemTable().size());
}

}  // namespace
}  // namespace plumb
