#include "editor/model/action_groups.hpp"

namespace plumb::editor {

std::string groupOf(const Action& action) {
    if (!action.menu.empty()) return std::string{action.menu};
    std::string kind{action.id.substr(0, action.id.find('.'))};
    if (!kind.empty() && kind[0] >= 'a' && kind[0] <= 'z') kind[0] = static_cast<char>(kind[0] - 32);
    return kind;
}

}  // namespace plumb::editor
