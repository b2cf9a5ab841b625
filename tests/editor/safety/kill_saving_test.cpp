// Kills the editor while it saves files of three sizes: the file must be complete, and the last edit must be
// in it or in the journal. PLUMB_SAVE_KILLS is the number of kills for each size.

#ifndef _WIN32

#include <cstdio>
#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "app/engine_types.hpp"
#include "core/hash.hpp"
#include "core/log.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/workspace.hpp"
#include "scene/components/transform.hpp"
#include "tests/editor/support/project_copy.hpp"
#include "tests/editor/support/victim.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::editor {
namespace {

using test::Report;
using test::Victim;

constexpr const char* kBig = "scenes/big.scene.json";

class KillWhileSaving : public testing::Test {
protected:
    KillWhileSaving() : before_{setLogSink([](const LogLine&) {})} {}
    ~KillWhileSaving() override { setLogSink(before_); }

    [[nodiscard]] std::uint64_t fileHash() const { return hashText(*readFile(folder_.path / kBig)); }
    void writeScene(std::size_t entities) const {
        std::string text = "{\n  \"format\": 1,\n  \"effects\": {},\n  \"layers\": [],\n  \"entities\": [";
        for (std::size_t i = 0; i < entities; ++i) {
            text += format(
                "{}\n    {\n      \"id\": \"{}\",\n      \"name\": \"thing{}\",\n      \"components\": {\n"
                "        \"Transform\": {\n          \"position\": [{}, {}]\n        },\n        \"Sprite\": "
                "{\n"
                "          \"width\": 16,\n          \"height\": {},\n          \"layer\": 3\n        }\n    "
                "  }\n"
                "    }",
                i == 0 ? "" : ",", hexText(i + 100), i, i % 1000, i / 1000 + 1, 8 + i % 8);
        }
        text += "\n  ]\n}\n";
        ASSERT_TRUE(writeFile(folder_.path / kBig, text).ok());
    }
    static void move(Workspace& workspace, float x) {
        const TypeInfo& type = workspace.document.types().of<Transform>();
        std::vector<SetField::Change> change{
            {workspace.document.objects().front(), FieldValue::of(Vec2{x, 0.5f})}};
        workspace.undo.push(std::make_unique<SetField>(type, *type.find("position"), std::move(change)));
        workspace.undo.endGesture();
    }
    /// In an endless loop: moves an entity, writes the journal, reports the state to the parent process and
    /// saves.
    static void keepSaving(Workspace& workspace, float first, const Victim::Tell& tell) {
        workspace.safety.keepMine();  // accepts the file that the previous process left
        workspace.safety.begin();
        for (float x = first;; x += 1.0f) {
            move(workspace, x);
            workspace.safety.update(2.0 * Journal::kMostSeconds);
            workspace.safety.finish();
            tell({.text = hashText(workspace.text())});
            if (!workspace.save().ok()) ::_exit(3);
        }
    }
    void killOften(std::size_t entities, int kills);

    test::TemporaryFolder folder_;
    LogSink before_;
};

void KillWhileSaving::killOften(std::size_t entities, int kills) {
    writeScene(entities);
    const TypeRegistry types = engineTypes();
    AssetStore assets{folder_.path};
    Workspace workspace{types, assets, {folder_.path}};
    ASSERT_TRUE(workspace.open(kBig).ok());
    const double start = wallSeconds();
    move(workspace, -1.0f);
    ASSERT_TRUE(workspace.save().ok());
    const double saving = wallSeconds() - start;
    Random random = Random::seeded(entities);
    int newFiles = 0, offered = 0;
    for (int i = 0; i < kills && !HasFailure(); ++i) {
        SCOPED_TRACE(i);
        std::set<std::uint64_t> whole{fileHash()};
        Victim victim{folder_.path / "reports", [&](const Victim::Tell& tell) {
                          keepSaving(workspace, 1000.0f * static_cast<float>(i + 1), tell);
                      }};
        ASSERT_TRUE(victim.live(1, saving * 1.5 * static_cast<double>(random.unit())));
        victim.kill();
        for (const Report& report : victim.reports()) whole.insert(report.text);
        const std::uint64_t last = victim.reports().back().text;
        const std::uint64_t now = fileHash();
        EXPECT_TRUE(whole.contains(now)) << "the file is damaged";
        Workspace again{types, assets, {folder_.path}};
        again.safety.begin();
        ASSERT_LE(again.safety.lost().size(), 1u);
        const std::uint64_t lost = again.safety.lost().empty() ? 0 : hashText(again.safety.lost()[0].text);
        EXPECT_TRUE(now == last || lost == last) << "what was done last is lost";
        // A state newer than the last report may be offered for recovery, an older one must not.
        EXPECT_FALSE(now == last && whole.contains(lost)) << "old work is offered";
        newFiles += now == last ? 1 : 0;
        offered += lost == last ? 1 : 0;
        std::filesystem::remove_all(folder_.path / ".plumb");
    }
    std::printf(
        "%d kills while saving %zu KB (%.0f ms): %d times the new file, %d times the old one and a journal\n",
        kills, static_cast<std::size_t>(std::filesystem::file_size(folder_.path / kBig)) / 1000, saving * 1e3,
        newFiles, offered);
}

TEST_F(KillWhileSaving, losesNothingOfASmallFile) { killOften(10, fromEnvironment("PLUMB_SAVE_KILLS", 20)); }
TEST_F(KillWhileSaving, losesNothingOfAFileOfAMegabyte) {
    killOften(3'800, fromEnvironment("PLUMB_SAVE_KILLS", 8));
}
TEST_F(KillWhileSaving, losesNothingOfAFileOfTwentyMegabytes) {
    killOften(76'000, fromEnvironment("PLUMB_SAVE_KILLS", 2));
}

}  // namespace
}  // namespace plumb::editor

#endif
