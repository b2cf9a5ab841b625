#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>

#include <gtest/gtest.h>

#include "app/engine_types.hpp"
#include "editor/model/assets/reload_document.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/play/game_session.hpp"
#include "editor/model/project/module_library.hpp"
#include "editor/model/project/project_session.hpp"
#include "editor/templates/project_templates.hpp"
#include "tests/editor/support/layout_edits.hpp"
#include "tests/support/allocations.hpp"
#include "tests/support/temporary_folder.hpp"

// A project whose C++ module is loaded again after each of 1,000 random edits of its component Changing,
// while the game runs. The library is always the same: a file says what fields the component has, see
// tests/code/reload. What each value becomes is known from tests/editor/support/changing_component.hpp.

namespace plumb::editor {
namespace {

using test::ExpectedField;
using test::Value;

constexpr std::uint64_t kEntities = 12;
constexpr const char* kScene = "scenes/level1.scene.json";

bool isChanging(std::uint64_t id) { return id % 3 != 0; }

/// Balls that fall side by side.
std::string sceneText() {
    std::string entities;
    for (std::uint64_t id = 1; id <= kEntities; ++id) {
        entities += format(R"({}{"id": "{}", "components": {"Transform": {"position": [{}, 0]}, )",
                           id == 1 ? "" : ",", hexText(id), id * 100);
        entities += R"("RigidBody": {}, "CircleCollider": {}, "Steady": {})";
        entities += isChanging(id) ? R"(, "Changing": {}}})" : "}}";
    }
    return format(R"({"format": 1, "entities": [{}]})", entities);
}

/// Hash of all components of the engine.
std::uint64_t engineHash(const World& world) {
    static const TypeRegistry kTypes = engineTypes();
    Hasher hasher;
    for (const EntityId entity : world.entities()) {
        hasher.add(std::uint64_t{entity.index} << 32 | entity.generation);
        for (const TypeInfo& type : kTypes.all()) {
            if (const void* component = world.find(type, entity)) hashComponent(hasher, type, component);
        }
    }
    return hasher.value();
}

class ModuleReload : public ::testing::Test {
protected:
    using Values = std::map<std::string, Value>;     // by name of field
    using Set = std::pair<ObjectId, ExpectedField>;  // a field that was set

    ModuleReload() {
        EXPECT_TRUE(createProject(*findTemplate("cpp"), "Game", folder).ok());
        std::filesystem::remove_all(folder / "code");
        EXPECT_TRUE(writeFile(folder / kScene, sceneText()).ok());
        ::setenv(test::kLayoutVariable, (home_.path / "layout").c_str(), 1);
        session = std::move(*ProjectSession::open(folder.string()));
        session->openFirst({});
    }

    [[nodiscard]] Workspace& workspace() { return session->workspace(); }
    [[nodiscard]] World& played() { return workspace().play.world(); }
    [[nodiscard]] World& edited() { return workspace().document.world; }
    [[nodiscard]] const TypeInfo* type() { return workspace().document.types().find("Changing"); }

    /// Loads the module with the present fields.
    void reload() {
        const test::Layout layout = test::layOut(fields, listed);
        std::ofstream{home_.path / "layout", std::ios::binary}.write(reinterpret_cast<const char*>(&layout),
                                                                     sizeof layout);
        const Result<Module> loaded = loadModule(PLUMB_RELOAD_MODULE, home_.path / "loaded");
        ASSERT_TRUE(loaded.ok()) << loaded.error().text();
        module = *loaded;
        const auto start = std::chrono::steady_clock::now();
        session->useCode(*loaded);
        times.push_back(std::chrono::steady_clock::now() - start);
        ASSERT_TRUE(session->codeProblems().empty()) << session->codeProblems()[0].text();
    }

    /// What values become by the change from `before` to the present fields.
    void follow(const std::vector<ExpectedField>& before, std::map<std::uint64_t, Values>& all) {
        const auto find = [](const std::vector<ExpectedField>& in, const std::string& name) {
            const auto at = std::find_if(in.begin(), in.end(),
                                         [&](const ExpectedField& field) { return field.name == name; });
            return at == in.end() ? nullptr : &*at;
        };
        for (auto& [id, values] : all) {
            Values now;
            for (const ExpectedField& field : fields) {
                const ExpectedField* former = find(before, field.name);
                if (former == nullptr && !field.was.empty()) former = find(before, field.was);
                now[field.name] = valueAs(former, former == nullptr ? Value{} : values[former->name], field);
            }
            values = std::move(now);
        }
    }
    [[nodiscard]] Values presets() const {
        Values values;
        for (const ExpectedField& field : fields) values[field.name] = field.preset;
        return values;
    }

    /// All values of all components in a world.
    void expectValues(const World& world, const ObjectNames& names,
                      const std::map<std::uint64_t, Values>& all) {
        ASSERT_EQ(type() == nullptr, !listed);
        if (type() == nullptr) return;
        ASSERT_EQ(world.count(*type()), all.size());
        for (const auto& [id, values] : all) {
            const void* component = world.find(*type(), names.find(ObjectId{id}));
            ASSERT_NE(component, nullptr) << "entity " << id;
            for (const ExpectedField& field : fields) {
                const void* at = type()->find(field.name)->in(component);
                const Value found = test::read(field, at, world.texts());
                ASSERT_TRUE(found == values.at(field.name))
                    << "entity " << id << ", field " << field.name << ": " << textOf(found) << " instead of "
                    << textOf(values.at(field.name));
            }
        }
    }

    void tick() {
        workspace().play.step({});
        for (auto& [id, values] : playedValues) {
            if (const auto field = values.find("ticks"); field != values.end()) field->second.number += 1.0L;
        }
        ++ticks;
    }

    /// Edits the fields while the game runs. @return true if the game had no component Changing before
    template <class Edit>
    bool change(Edit&& edit) {
        const std::vector<ExpectedField> before = fields;
        const bool wasListed = listed;
        edit();
        reload();
        if (wasListed || !listed) return follow(before, playedValues), false;
        for (auto& [id, values] : playedValues)  // the game adds it again
            played().add(*type(), workspace().play.find(ObjectId{id})), values = presets();
        return true;
    }

    /// Sets a field in the running game, as the code of a game does.
    void setPlayed() {
        if (!listed || fields.size() < 2) return;
        auto& [id, values] = *std::next(playedValues.begin(), random.below(8));
        const ExpectedField& field = anyField();
        values[field.name] = edits.value(field, random);
        void* component = played().find(*type(), workspace().play.find(ObjectId{id}));
        test::write(field, values[field.name], type()->find(field.name)->in(component), &played().texts());
    }
    /// Sets a field in the edited scene by a command. @return the value before
    Value setEdited(ObjectId object, const ExpectedField& field, const Value& value) {
        std::vector<std::byte> bytes(field.size());
        test::write(field, value, bytes.data(), &edited().texts());
        const FieldInfo& info = *type()->find(field.name);
        const Value before = editedValue(object, field);
        workspace().undo.push(std::make_unique<SetField>(
            *type(), info, std::vector<SetField::Change>{{object, FieldValue{bytes}}}));
        workspace().undo.endGesture();
        return before;
    }
    [[nodiscard]] Value editedValue(ObjectId object, const ExpectedField& field) {
        const void* component = std::as_const(edited()).find(*type(), workspace().document.find(object));
        return test::read(field, type()->find(field.name)->in(component), edited().texts());
    }
    [[nodiscard]] const ExpectedField& anyField() {
        return fields[1 + random.below(static_cast<std::uint32_t>(fields.size() - 1))];
    }
    /// A field of the resource Score.
    [[nodiscard]] int scoreOf(const World& world, const char* field = "beats") const {
        const Module::Resource& resource = module.resourceTypes().at(0);
        TypeRegistry types;
        resource.describe(types);
        const void* score = resource.find(world);
        return score == nullptr ? 0 : test::get<int>(types.all().front().find(field)->in(score));
    }

    /// Sets a field of the edited scene, undoes that and does it again.
    /// @param before  receives the value before
    std::optional<Set> expectUndoable(Value& before) {
        const ExpectedField field = anyField();
        if (field.type.kind == FieldKind::Entity) return {};
        const ObjectId object{1 + random.below(2)};
        const Value value = edits.value(field, random);
        before = setEdited(object, field, value);
        if (before == value) return {};
        EXPECT_TRUE(workspace().undo.undo());
        EXPECT_TRUE(editedValue(object, field) == before) << field.name;
        EXPECT_TRUE(workspace().undo.redo());
        EXPECT_TRUE(editedValue(object, field) == value) << field.name;
        return Set{object, field};
    }

    /// Memory blocks in use when the component has no field but `ticks`, and the scene is that of its file
    /// again: its text also contains the values of fields that the code no longer has.
    std::size_t blocksAtRest() {
        const SceneContext context{workspace().document.types(), nullptr, folder};
        EXPECT_TRUE(reloadDocument(workspace().document, context, sceneText()).ok());
        for (int i = 0; i < 2; ++i) {
            change([&] {
                fields = {test::LayoutEdits::ticks()};
                fields[0].preset.number = i;  // another default: the undo history is cleared
                listed = true;
            });
            tick();
        }
        return test::allocations().alive();
    }

private:
    test::TemporaryFolder home_{test::memoryFolder()};

protected:
    const Path folder = home_.path / "game";
    std::unique_ptr<ProjectSession> session;
    Module module;
    Random random = Random::seeded(1);
    test::LayoutEdits edits{false};
    std::vector<ExpectedField> fields{test::LayoutEdits::ticks()};
    bool listed = true;
    std::map<std::uint64_t, Values> playedValues;  // by id in the scene
    int ticks = 0;
    std::vector<std::chrono::duration<double, std::milli>> times;
};

TEST_F(ModuleReload, thousandRandomEditsKeepTheStateOfARunningGame) {
    reload();
    workspace().startPlaying(true);
    const std::unique_ptr<PlaySession> alone =
        makeGameSession(*loadProject(folder), kScene, sceneText(), engineContent());
    for (std::uint64_t id = 1; id <= kEntities; ++id) {
        if (isChanging(id)) playedValues[id] = presets();
    }
    std::size_t blocks = 0;
    std::optional<Set> undoable;  // the field that the last step set
    Value undone;
    int undoneLater = 0;
    for (int edit = 0; edit < 1000; ++edit) {
        if (edit == 300) blocks = blocksAtRest(), undoable.reset();
        for (int i = 0; i < 3; ++i) setPlayed();
        const std::vector<EntityId> entities = played().entities();
        const std::uint64_t hash = engineHash(played());
        const bool addedAgain = change([&] { edits.edit(fields, listed, random); });
        EXPECT_EQ(played().entities(), entities);
        EXPECT_EQ(engineHash(played()), hash) << "components of the engine are unchanged";
        EXPECT_EQ(scoreOf(played()), ticks);
        EXPECT_EQ(scoreOf(played(), "rings"), std::max(0, ticks - 1) / 3) << "timers of the code go on";
        expectValues(played(), workspace().play, playedValues);
        ASSERT_FALSE(HasFatalFailure()) << "edit " << edit;

        if (undoable && workspace().undo.total() != 0) {  // the component has not changed
            ASSERT_TRUE(workspace().undo.undo());
            ASSERT_TRUE(editedValue(undoable->first, undoable->second) == undone) << "edit " << edit;
            ++undoneLater;
        }
        undoable.reset();
        if (listed && fields.size() > 1) undoable = expectUndoable(undone);
        ASSERT_FALSE(HasFatalFailure()) << "edit " << edit;

        tick();
        if (edit % 20 == 0 && !addedAgain) {  // the recording begins with the new version
            const std::uint64_t first = played().hash();
            for (int i = 0; i < 3; ++i) tick();
            const std::uint64_t last = played().hash();
            workspace().play.seek(workspace().play.ticks() - 3);
            ASSERT_EQ(played().hash(), first);
            for (int i = 0; i < 3; ++i) workspace().play.step({});
            ASSERT_EQ(played().hash(), last);
        }
        expectValues(played(), workspace().play, playedValues);
        ASSERT_FALSE(HasFatalFailure()) << "edit " << edit;
    }
    EXPECT_GT(undoneLater, 30);
    EXPECT_LE(blocksAtRest(), blocks + 8) << "memory blocks";
    for (int i = 0; i < ticks; ++i) alone->tick({});
    EXPECT_EQ(engineHash(played()), engineHash(alone->world())) << "as without module";
    std::sort(times.begin(), times.end());
    RecordProperty("medianMilliseconds", std::to_string(times[times.size() / 2].count()));
    RecordProperty("longestMilliseconds", std::to_string(times.back().count()));
}

TEST_F(ModuleReload, editedScenesKeepTheirValuesAndTheirTextAgrees) {
    edits = test::LayoutEdits{true};
    reload();
    std::map<std::uint64_t, Values> all;
    for (std::uint64_t id = 1; id <= kEntities; ++id) {
        if (isChanging(id)) all[id] = presets();
    }
    for (int edit = 0; edit < 200; ++edit) {
        if (fields.size() > 1) {
            const ExpectedField& field = anyField();
            auto& [id, values] = *std::next(all.begin(), random.below(8));
            values[field.name] = edits.value(field, random);
            setEdited(ObjectId{id}, field, values[field.name]);
        }
        const std::vector<ExpectedField> before = fields;
        edits.edit(fields, listed, random);
        reload();
        follow(before, all);
        expectValues(edited(), workspace().document, all);
        ASSERT_FALSE(HasFatalFailure()) << "edit " << edit;
    }
    const std::string text = workspace().text();
    ASSERT_TRUE(writeFile(folder / kScene, text).ok());
    ASSERT_TRUE(workspace().open(kScene).ok());
    expectValues(edited(), workspace().document, all);
    EXPECT_EQ(workspace().text(), text);
}

TEST_F(ModuleReload, loadsAnotherLibraryEachTimeAndLeavesNoFile) {
    reload();
    const Module first = module;
    reload();
    EXPECT_NE(first.systems().at(0).row.add, module.systems().at(0).row.add);
    EXPECT_EQ(first.systems().at(0).row.key(), module.systems().at(0).row.key());
    EXPECT_EQ(first.systems().at(1).row.key(), module.systems().at(1).row.key()) << "of an unnamed namespace";
    EXPECT_TRUE(std::filesystem::is_empty(folder.parent_path() / "loaded"));
    const Result<Module> none = loadModule(folder / "none.so", folder);
    ASSERT_FALSE(none.ok());
    EXPECT_NE(none.error().what.find("No such file"), std::string::npos) << none.error().text();
}

}  // namespace
}  // namespace plumb::editor
