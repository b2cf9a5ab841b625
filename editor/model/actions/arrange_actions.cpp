#include <array>

#include "editor/model/actions/action_rows.hpp"
#include "editor/model/arrange.hpp"

namespace plumb::editor {
namespace {

template <Alignment To>
void align(Workspace& w) {
    if (!alignEntities(w.document, w.undo, w.document.selection.all(), To))
        w.notice = "The entities are already aligned";
}
template <bool Downwards>
void spread(Workspace& w) {
    if (!spreadEntities(w.document, w.undo, w.document.selection.all(), Downwards))
        w.notice = "The gaps are already equal";
}
bool withTwo(const Workspace& w) { return editable(w) && w.document.selection.size() > 1; }
bool withThree(const Workspace& w) { return editable(w) && w.document.selection.size() > 2; }

constexpr Action row(std::string_view id, std::string_view label, bool (*enabled)(const Workspace&),
                     void (*run)(Workspace&)) {
    return {id, "Arrange", label, {}, enabled, run};
}

const std::array kRows{
    row("arrange.left", "Align left edges", withTwo, align<Alignment::Left>),
    row("arrange.center", "Align centers", withTwo, align<Alignment::Center>),
    row("arrange.right", "Align right edges", withTwo, align<Alignment::Right>),
    line("Arrange"),
    row("arrange.top", "Align top edges", withTwo, align<Alignment::Top>),
    row("arrange.middle", "Align middles", withTwo, align<Alignment::Middle>),
    row("arrange.bottom", "Align bottom edges", withTwo, align<Alignment::Bottom>),
    line("Arrange"),
    row("arrange.spreadAcross", "Distribute horizontally", withThree, spread<false>),
    row("arrange.spreadDown", "Distribute vertically", withThree, spread<true>),
};

}  // namespace

std::span<const Action> arrangeActions() { return kRows; }

}  // namespace plumb::editor
