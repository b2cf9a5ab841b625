#pragma once

#include <functional>
#include <string>

#include "core/text.hpp"
#include "editor/model/cost/advice.hpp"
#include "editor/model/cost/what_if.hpp"
#include "editor/model/play/game_session.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor {

/// Builds the text of a scene entity by entity; boxes are 32 x 32 px.
class CostScene {
public:
    explicit CostScene(const std::string& physics = {}) {
        add("camera", R"("Transform": {"position": [320, 180]}, "Camera": {})" +
                          (physics.empty() ? std::string{} : format(R"(, "ScenePhysics": {{}})", physics)));
        add("ground",
            R"("Transform": {"position": [-2000, 320]}, "BoxCollider": {"width": 5000, "height": 64})");
    }
    CostScene& add(const std::string& name, const std::string& components) {
        text_ += format("{}{\"id\": \"{}\", \"name\": \"{}\", \"components\": {{}}}",
                        count_ == 0 ? "" : ",\n", hexText(std::uint64_t{0x100} + count_), name, components);
        ++count_;
        return *this;
    }
    /// @param body  JSON fields of the RigidBody
    CostScene& box(const std::string& name, Vec2 at, const std::string& body = {}) {
        return add(name, format(R"("Transform": {"position": [{}, {}]}, "RigidBody": {{}}, )"
                                R"("BoxCollider": {"width": 32, "height": 32})",
                                at.x, at.y, body));
    }
    /// Adds a vertical stack of boxes that stands on the ground.
    CostScene& stack(int boxes, float x = 100.0f) {
        for (int i = 0; i < boxes; ++i)
            box(format("box {}", i), {x, 288.0f - 32.0f * static_cast<float>(i)}, R"("friction": 0.6)");
        return *this;
    }
    [[nodiscard]] std::string text() const { return "{\"format\": 1, \"entities\": [\n" + text_ + "\n]}"; }

private:
    std::string text_;
    std::uint64_t count_ = 0;
};

/// An editor with helpers to play a scene and measure its costs.
class CostFixture : public EditorFixture {
protected:
    CostFixture() {
        workspace.makeSession = [this](const std::string& path, const std::string& text) {
            Project project;
            project.root = workspace.project.root;
            project.actions = ActionMap::defaults();
            return makeGameSession(project, path, text);
        };
    }
    void open(const CostScene& scene) {
        putFile("scenes/cost.scene.json", scene.text());
        ASSERT_TRUE(workspace.open("scenes/cost.scene.json").ok());
    }
    void play(int ticks, const std::function<InputFrame(int)>& hands = {}) {
        workspace.startPlaying(true);
        for (int tick = 0; tick < ticks; ++tick) workspace.play.step(hands ? hands(tick) : InputFrame{});
    }
    /// Measures the scene until all results are available.
    void measure() {
        whatIf.begin(workspace);
        while (whatIf.busy() && !whatIf.measured()) whatIf.update(workspace);
        whatIf.wait();
    }
    [[nodiscard]] const Advice* adviceOf(std::string_view rule) {
        result_ = whatIf.result();
        advice_ = adviceFor({result_, *whatIf.tape()});
        for (const Advice& one : advice_) {
            if (one.rule == rule) return &one;
        }
        return nullptr;
    }
    [[nodiscard]] const ScenePhysics* scenePhysics(const World& world) const {
        const ScenePhysics* found = nullptr;
        world.each<const ScenePhysics>([&](EntityId, const ScenePhysics& physics) { found = &physics; });
        return found;
    }

    WhatIf whatIf;

private:
    WhatIfResult result_;
    std::vector<Advice> advice_;
};

}  // namespace plumb::editor
