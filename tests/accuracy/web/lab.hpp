#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/report/row.hpp"
#include "tests/accuracy/web/recording.hpp"

namespace plumb::accuracy {

/// The experiments that a page runs on the machine of its reader, and their results so far.
class Lab {
public:
    /// Returns a JSON array of the scenes with known results: names, texts and what can be chosen.
    [[nodiscard]] static std::string scenesJson();

    /// Runs a scene until `seconds` of steps were measured. Its results replace those of the same method.
    /// @return its rows as JSON, see jsonOf(); "[]" if there is no such scene
    std::string measure(std::string_view scene, const Method& method, double seconds);

    /// Records a run. @return see sceneJson(); "null" if there is no such scene
    std::string record(std::string_view scene, const Method& method);
    [[nodiscard]] const std::vector<float>& poses() const { return recording_.poses; }  ///< of record()

    /// Returns the diagram of all results of a scene as SVG.
    [[nodiscard]] std::string chart(std::string_view scene) const;

private:
    std::map<std::string, std::vector<Row>, std::less<>> rows_;  ///< results of each scene
    Recording recording_;
};

/// @param substeps    1, 2, 4 to 64; 0: automatic
/// @param integrator  index of a physics::IntegratorKind
Method methodOf(int substeps, int integrator, bool jointTrees);

}  // namespace plumb::accuracy
