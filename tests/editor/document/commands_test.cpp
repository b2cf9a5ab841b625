#include <iterator>
#include <vector>

#include "core/random.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/clipboard.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/delete_entities.hpp"
#include "editor/model/commands/paint_tiles.hpp"
#include "editor/model/commands/reparent.hpp"
#include "editor/model/commands/set_field.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {
namespace {

/// Returns a random entity of the scene; null if the scene is empty.
ObjectId anyObject(const Document& document, Random& random) {
    const std::vector<ObjectId>& all = document.objects();
    return all.empty() ? ObjectId{} : all[random.below(static_cast<std::uint32_t>(all.size()))];
}

std::unique_ptr<Command> randomSetField(Document& document, Random& random) {
    const ObjectId id = anyObject(document, random);
    std::vector<const TypeInfo*> has;
    for (const TypeInfo& type : document.types().all()) {
        const bool ours = type.name == "Transform" || type.name == "BoxCollider" || type.name == "Label" ||
                          type.name == "RigidBody" || type.name == "Camera";
        if (ours && document.world.has(type, document.find(id))) has.push_back(&type);
    }
    if (has.empty()) return nullptr;
    const TypeInfo& type = *has[random.below(static_cast<std::uint32_t>(has.size()))];
    const FieldInfo& field = type.fields[random.below(static_cast<std::uint32_t>(type.fields.size()))];
    FieldValue value =
        readField(document, field, std::as_const(document.world).find(type, document.find(id)));
    switch (field.kind) {
        case FieldKind::Float: value = FieldValue::of(random.between(0.0f, 50.0f)); break;
        case FieldKind::Vec2: value = FieldValue::of(Vec2{random.between(-9.0f, 9.0f), random.unit()}); break;
        case FieldKind::Bool: value = FieldValue::of(random.below(2) == 0); break;
        case FieldKind::Entity: value = FieldValue::of(anyObject(document, random)); break;
        default: break;
    }
    std::vector<SetField::Change> changes;
    changes.push_back({id, std::move(value)});
    return std::make_unique<SetField>(type, field, std::move(changes));
}

std::unique_ptr<Command> randomComponent(Document& document, Random& random) {
    const ObjectId id = anyObject(document, random);
    const auto& all = document.types().all();
    const TypeInfo& type =
        *std::next(all.begin(), 4 + random.below(static_cast<std::uint32_t>(all.size() - 4)));
    if (type.name == "Parent" || type.name == "Children") return nullptr;
    return document.world.has(type, document.find(id)) ? removeComponent(document, {id}, type)
                                                       : addComponent(document, {id}, type);
}

std::unique_ptr<Command> randomPaint(Document& document, Random& random) {
    for (const ObjectId id : document.objects()) {
        const TileLayer* layer = std::as_const(document.world).find<TileLayer>(document.find(id));
        if (layer == nullptr || document.world.tiles().find(layer->cells) == nullptr) continue;
        const auto x = static_cast<int>(random.below(6)) - 1;
        const auto y = static_cast<int>(random.below(5)) - 1;
        std::vector<PaintTiles::Cell> cells{{x, y, random.below(5)}, {x + 1, y, random.below(5)}};
        return std::make_unique<PaintTiles>(id, std::move(cells));
    }
    return nullptr;
}

/// Creates a random command of any kind for a random entity of the document.
std::unique_ptr<Command> randomCommand(Document& document, Random& random) {
    const ObjectId id = anyObject(document, random);
    if (!id) return createEntity(document, "first", {});
    switch (random.below(9)) {
        case 0:
            return createEntity(document, "new", {random.unit(), 4.0f},
                                random.below(2) == 0 ? id : ObjectId{});
        case 1: return std::make_unique<DeleteEntities>(std::vector{id});
        case 2:
            return document.objectCount() > 60 ? nullptr
                                               : std::unique_ptr<Command>{duplicateEntities(document, {id})};
        case 3: return std::make_unique<Reparent>(std::vector{id}, anyObject(document, random));
        case 4: return randomComponent(document, random);
        case 5:
            return renameEntity(document, id,
                                random.below(3) == 0 ? "" : "name" + std::to_string(random.below(9)));
        case 6: return randomPaint(document, random);
        default: return randomSetField(document, random);
    }
}

using Commands = EditorFixture;

TEST_F(Commands, openingAndSavingChangesNoByte) {
    EXPECT_EQ(workspace.text(), kSceneText);

    ASSERT_TRUE(workspace.save().ok());

    EXPECT_EQ(fileText(), kSceneText);
}

TEST_F(Commands, everyCommandRevertedLeavesTheDocumentAsItWas) {
    Document& document = workspace.document;
    for (unsigned seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const std::string before = workspace.text();
        const auto command = randomCommand(document, random);
        if (command == nullptr) continue;

        command->apply(document);
        const std::string after = workspace.text();
        command->revert(document);
        ASSERT_EQ(workspace.text(), before) << command->label();
        command->apply(document);
        ASSERT_EQ(workspace.text(), after) << command->label();
    }
}

TEST_F(Commands, tenThousandRandomCommandsAreUndoneAndRedoneByteForByte) {
    constexpr int kCommands = 10'000;
    Random random = Random::seeded(7);
    for (int i = 0; i < kCommands; ++i) {
        if (auto command = randomCommand(workspace.document, random)) workspace.undo.push(std::move(command));
        if (random.below(3) != 0) workspace.undo.endGesture();
    }
    const std::string after = workspace.text();

    while (workspace.undo.undo()) {
    }
    EXPECT_EQ(workspace.text(), kSceneText);
    while (workspace.undo.redo()) {
    }
    EXPECT_EQ(workspace.text(), after);
}

TEST_F(Commands, undoRestoresADeletedEntityWithChildrenReferencesAndUnknownComponents) {
    workspace.document.selection.set({named("player")});
    workspace.undo.push(std::make_unique<DeleteEntities>(workspace.document.selection.all()));
    EXPECT_FALSE(named("player"));
    EXPECT_FALSE(named("lamp"));
    EXPECT_TRUE(workspace.document.selection.empty());

    ASSERT_TRUE(workspace.undo.undo());

    EXPECT_EQ(workspace.text(), kSceneText);
    const Document& document = workspace.document;
    EXPECT_EQ(document.world.get<Camera>(document.find(named("camera"))).follow,
              document.find(named("player")));
    EXPECT_TRUE(document.selection.has(named("player")));
}

TEST_F(Commands, aParentBelowItselfIsRefusedAndUndoneWithoutATrace) {
    workspace.undo.push(std::make_unique<Reparent>(std::vector{named("player")}, named("lamp")));
    EXPECT_EQ(workspace.text(), kSceneText);
    ASSERT_TRUE(workspace.undo.undo());
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Commands, copiedEntitiesCanBePastedAsTextWithTheirChildren) {
    workspace.document.selection.set({named("player")});
    ASSERT_TRUE(runAction(workspace, "edit.copy"));
    ASSERT_TRUE(runAction(workspace, "edit.paste"));

    EXPECT_EQ(workspace.document.objectCount(), 8u);
    const std::vector<ObjectId> pasted = workspace.document.selection.all();
    ASSERT_EQ(pasted.size(), 1u) << "what is below goes with it";
    EXPECT_EQ(positionOf(pasted[0]), (Vec2{40.0f, 100.0f}));
    const Document& document = workspace.document;
    const auto& all = document.objects();
    EXPECT_EQ(std::count_if(all.begin(), all.end(),
                            [&](ObjectId id) {
                                return parentOf(document.world, document.find(id)) ==
                                       document.find(pasted[0]);
                            }),
              1)
        << "the lamp";
    ASSERT_TRUE(workspace.undo.undo());
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Commands, textWithoutEntitiesIsNotPasted) {
    for (const char* text :
         {"", "hello", "{}", "[1,2]", R"({"plumbEntities": 3})", R"({"plumbEntities": [1]})"}) {
        EXPECT_EQ(pasteFromText(workspace.prefabs(), text).command, nullptr) << text;
    }
}

TEST_F(Commands, aTransactionThatIsNotCommittedLeavesNothing) {
    {
        Transaction transaction{workspace.undo, "make two"};
        workspace.undo.push(createEntity(workspace.document, "one", {}));
        workspace.undo.push(createEntity(workspace.document, "two", {}));
    }
    EXPECT_EQ(workspace.text(), kSceneText);
    EXPECT_EQ(workspace.undo.size(), 0u);

    Transaction transaction{workspace.undo, "make two"};
    workspace.undo.push(createEntity(workspace.document, "one", {}));
    workspace.undo.push(createEntity(workspace.document, "two", {}));
    transaction.commit();
    EXPECT_EQ(workspace.undo.size(), 1u);
    ASSERT_TRUE(workspace.undo.undo());
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(Commands, theSavedMarkFollowsUndoAndIsLostWithItsBranch) {
    runAction(workspace, "entity.create");
    EXPECT_TRUE(workspace.unsaved());
    ASSERT_TRUE(workspace.save().ok());
    EXPECT_FALSE(workspace.unsaved());

    workspace.undo.undo();
    EXPECT_TRUE(workspace.unsaved());
    workspace.undo.redo();
    EXPECT_FALSE(workspace.unsaved());

    workspace.undo.undo();
    runAction(workspace, "entity.create");
    EXPECT_TRUE(workspace.unsaved());
    EXPECT_EQ(workspace.undo.savedPosition(), UndoStack::kNever);
}

}  // namespace
}  // namespace plumb::editor
