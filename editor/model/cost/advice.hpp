#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/cost/scene_physics_edit.hpp"
#include "editor/model/cost/what_if_run.hpp"

namespace plumb::editor {

/// What was measured: the input of the rules.
struct CostFacts {
    const WhatIfResult& result;
    const PhysicsTape& tape;
};

/// What a rule has to say.
struct Advice {
    std::string_view rule;
    std::string words;
    CostRemedy remedy;
    std::vector<ObjectId> about;  ///< what a click on it selects
};

/// One thing that may be wrong with a scene. A row of advice_rules.cpp.
struct AdviceRule {
    std::string_view name;
    /// Nothing: the scene does not deserve it.
    std::optional<Advice> (*judge)(const CostFacts& facts);
};
std::span<const AdviceRule> adviceRules();

/// What all rules say of a scene, in their order. @pre the result is complete
std::vector<Advice> adviceFor(const CostFacts& facts);

}  // namespace plumb::editor
