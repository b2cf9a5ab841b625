#include <array>
#include <cstdlib>

#include "core/text.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/set_field.hpp"
#include "scene/components/prefab_instance.hpp"
#include "scene/components/transform.hpp"
#include "tests/editor/support/project_copy.hpp"

namespace plumb::editor {
namespace {

/// Makes random changes of single entities in a scene of the sample project "platformer".
class Merging : public testing::Test {
protected:
    ObjectId anyObject() {
        const std::vector<ObjectId>& all = document().objects();
        return all[random.below(static_cast<std::uint32_t>(all.size()))];
    }

    /// Returns a random change of an entity; the same one for the same state of `random`.
    std::unique_ptr<Command> anyChange(ObjectId id) {
        const EntityId entity = document().find(id);
        std::vector<const TypeInfo*> has, lacks;
        for (const TypeInfo& type : document().types().all()) {
            if (type.fields.empty() || type.name == "SceneEntity" || startsWith(type.name, "Prefab") ||
                type.name == "Name" || type.name == "Parent" || type.name == "Children")
                continue;
            (document().world.has(type, entity) ? has : lacks).push_back(&type);
        }
        const auto pick = [this](const auto& list) {
            return list[random.below(static_cast<std::uint32_t>(list.size()))];
        };
        switch (random.below(6)) {
            case 0: return addComponent(document(), {id}, *pick(lacks));
            case 1: return removeComponent(document(), {id}, *pick(has));
            case 2: return renameEntity(document(), id, format("renamed {}", random.below(1000)));
            default: return setSomething(id, *pick(has));
        }
    }

    std::unique_ptr<Command> setSomething(ObjectId id, const TypeInfo& type) {
        const void* component = std::as_const(document().world).find(type, document().find(id));
        for (int attempt = 0; attempt < 20; ++attempt) {
            const FieldInfo& field =
                type.fields[random.below(static_cast<std::uint32_t>(type.fields.size()))];
            if (field.transient) continue;
            FieldValue value = readField(document(), field, component);
            float number = std::floor(random.between(1.0f, 200.0f));
            if (field.kind == FieldKind::Bool) {
                value.bytes[0] ^= std::byte{1};
            } else if (field.kind == FieldKind::Float || field.kind == FieldKind::Vec2) {
                std::memcpy(value.bytes.data(), &number, sizeof number);
            } else {
                continue;
            }
            std::vector<SetField::Change> changes;
            changes.push_back({id, std::move(value)});
            return std::make_unique<SetField>(type, field, std::move(changes));
        }
        return renameEntity(document(), id, "nothing to set");
    }

    /// Returns the scene's text with a change applied; the change is undone afterwards.
    std::string textAfter(std::unique_ptr<Command> change) {
        workspace().undo.push(std::move(change));
        workspace().undo.endGesture();
        std::string text = workspace().text();
        workspace().undo.jumpTo(0);
        return text;
    }

    Workspace& workspace() { return copy.workspace(); }
    Document& document() { return workspace().document; }

    ProjectCopy copy{"platformer", "level2"};
    Random random = Random::seeded(11);
};

std::size_t changedLines(const std::string& a, const std::string& b) {
    const std::vector<std::string_view> before = split(a, '\n');
    const std::vector<std::string_view> after = split(b, '\n');
    if (before.size() != after.size()) return std::max(before.size(), after.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < before.size(); ++i) count += before[i] != after[i] ? 1 : 0;
    return count;
}

TEST_F(Merging, movingAnEntityChangesAtMostTwoLinesOfTheFile) {
    const std::string before = workspace().text();
    const TypeInfo& type = document().types().of<Transform>();
    int moved = 0;
    const std::vector<ObjectId> all = document().objects();
    for (const ObjectId id : all) {
        const EntityId entity = document().find(id);
        // Moving a part of a prefab instance adds an override, which changes more than one line of the file.
        if (!document().world.has(type, entity) || document().world.has<PrefabPart>(entity)) continue;
        const Vec2 to = std::as_const(document().world).get<Transform>(entity).position + Vec2{16, 8};
        std::vector<SetField::Change> change;
        change.push_back({id, FieldValue::of(to)});
        const std::string after =
            textAfter(std::make_unique<SetField>(type, *type.find("position"), std::move(change)));
        EXPECT_EQ(changedLines(before, after), 1u) << document().nameOf(id);
        ++moved;
    }
    EXPECT_GT(moved, 20);
}

TEST_F(Merging, editsOfDifferentEntitiesAreMergedByGit) {
    if (std::system("git --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "needs git";
    const std::string base = workspace().text();
    ASSERT_EQ(base, copy.fileText());
    const std::array files{copy.root() / "ours", copy.root() / "base", copy.root() / "theirs"};
    ASSERT_TRUE(writeFile(files[1], base).ok());
    const std::string command =
        format("git merge-file -p -q {} {} {} > {}", files[0].string(), files[1].string(), files[2].string(),
               (copy.root() / "merged").string());
    const int pairs = fromEnvironment("PLUMB_MERGES", 60);
    int changed = 0;
    for (int i = 0; i < pairs; ++i) {
        SCOPED_TRACE(i);
        const ObjectId mine = anyObject();
        ObjectId yours = anyObject();
        while (yours == mine) yours = anyObject();
        const Random start = random;
        const std::string ours = textAfter(anyChange(mine));
        const std::string theirs = textAfter(anyChange(yours));
        random = start;
        workspace().undo.push(anyChange(mine));
        workspace().undo.endGesture();
        const std::string both = textAfter(anyChange(yours));
        ASSERT_TRUE(writeFile(files[0], ours).ok() && writeFile(files[2], theirs).ok());
        ASSERT_EQ(std::system(command.c_str()), 0) << "a conflict";
        ASSERT_EQ(*readFile(copy.root() / "merged"), both);
        changed += ours != base && theirs != base ? 1 : 0;
    }
    EXPECT_GT(changed, pairs / 2);
}

}  // namespace
}  // namespace plumb::editor
