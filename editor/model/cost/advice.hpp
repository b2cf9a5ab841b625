#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/cost/scene_physics_edit.hpp"
#include "editor/model/cost/what_if_run.hpp"

namespace plumb::editor {

/// Measurements from which the rules derive advice.
struct CostFacts {
    const WhatIfResult& result;  ///< cost and error of each variant of the physics settings
    const PhysicsTape& tape;     ///< recording of the physics for which they were measured
};

/// Advice of one rule for the measured scene.
struct Advice {
    std::string_view rule;        ///< name of the rule
    std::string words;            ///< text shown to the user
    CostRemedy remedy;            ///< change of a setting that a button offers
    std::vector<ObjectId> about;  ///< entities that a click on the advice selects
};

/// A rule that checks a scene for one kind of problem. The rules are the table in advice_rules.cpp.
struct AdviceRule {
    std::string_view name;
    /// Returns the advice, or nullopt if the scene does not have this problem.
    std::optional<Advice> (*judge)(const CostFacts& facts);
};
std::span<const AdviceRule> adviceRules();

/// Returns the advice of all rules for a scene, in the order of the rules. @pre facts.result.complete
std::vector<Advice> adviceFor(const CostFacts& facts);

}  // namespace plumb::editor
