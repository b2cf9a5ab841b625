#include "editor/model/document/undo_stack.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "editor/model/document/file_command.hpp"

namespace plumb::editor {
namespace {

/// Several commands as one undo step.
class CommandGroup final : public Command {
public:
    CommandGroup(std::string label, std::vector<std::unique_ptr<Command>> commands)
        : label_{std::move(label)}, commands_{std::move(commands)} {}

    [[nodiscard]] std::string label() const override { return label_; }
    void apply(Document& document) override {
        for (const auto& command : commands_) {
            command->apply(document);
        }
    }
    void revert(Document& document) override {
        for (auto command = commands_.rbegin(); command != commands_.rend(); ++command) {
            (*command)->revert(document);
        }
    }

    [[nodiscard]] bool writesFilesOnly() const;

private:
    std::string label_;
    std::vector<std::unique_ptr<Command>> commands_;
};

bool writesFilesOnly(const Command& command) {
    if (const auto* group = dynamic_cast<const CommandGroup*>(&command)) return group->writesFilesOnly();
    return dynamic_cast<const FileCommand*>(&command) != nullptr;
}

bool CommandGroup::writesFilesOnly() const {
    return std::all_of(commands_.begin(), commands_.end(), [](const std::unique_ptr<Command>& command) {
        return plumb::editor::writesFilesOnly(*command);
    });
}

/// Moves the position over a command, forward or back. If the command writes files only, the saved position
/// moves along, because the scene still matches its file.
void moveOver(const Command& command, std::size_t to, std::size_t& position, std::size_t& saved) {
    if (saved == position && writesFilesOnly(command)) saved = to;
    position = to;
}

}  // namespace

void UndoStack::push(std::unique_ptr<Command> command) {
    // Deleted entities have names only before `apply`, created ones only after it.
    std::string subject = nameOf(command->subject());
    command->apply(document_);
    if (subject.empty()) subject = nameOf(command->subject());
    ++document_.sceneRevision;
    if (group_ != nullptr) {
        if (groupSubject_.empty()) groupSubject_ = std::move(subject);
        group_->push_back(std::move(command));
        return;
    }
    if (gesture_ && position_ > 0 && commands_[position_ - 1]->absorb(*command)) return;
    endGesture();
    append(std::move(command), std::move(subject));
    gesture_ = true;
}

std::string UndoStack::nameOf(Subject subject) const {
    if (subject.count == 0 || !document_.find(subject.first)) return {};
    const std::string name = document_.nameOf(subject.first);
    return subject.count == 1 ? name : format("{} and {} more", name, subject.count - 1);
}

void UndoStack::append(std::unique_ptr<Command> command, std::string subject) {
    if (saved_ != kNever && saved_ > position_) saved_ = kNever;
    std::erase_if(lost_, [this](const Lost& branch) { return branch.position > position_; });
    if (position_ < commands_.size()) {
        const std::string& last = subjects_.back();
        lost_.push_back({position_, commands_.size() - position_,
                         commands_.back()->label() + (last.empty() ? "" : ": " + last)});
    }
    commands_.resize(position_);
    subjects_.resize(position_);
    commands_.push_back(std::move(command));
    subjects_.push_back(std::move(subject));
    moveOver(*commands_.back(), position_ + 1, position_, saved_);
}

void UndoStack::endGesture() {
    if (!std::exchange(gesture_, false)) return;
    if (position_ == commands_.size() && commands_.back()->changesNothing(document_)) {
        moveOver(*commands_.back(), position_ - 1, position_, saved_);
        commands_.pop_back();
        subjects_.pop_back();
    }
}

void UndoStack::cancelGesture() {
    if (!std::exchange(gesture_, false)) return;
    commands_.back()->revert(document_);
    moveOver(*commands_.back(), position_ - 1, position_, saved_);
    commands_.pop_back();
    subjects_.pop_back();
    ++document_.sceneRevision;
}

bool UndoStack::undo() {
    PLUMB_ASSERT(group_ == nullptr, "commit the transaction before undoing");
    endGesture();
    if (position_ == 0) return false;
    commands_[position_ - 1]->revert(document_);
    moveOver(*commands_[position_ - 1], position_ - 1, position_, saved_);
    ++document_.sceneRevision;
    return true;
}

bool UndoStack::redo() {
    PLUMB_ASSERT(group_ == nullptr, "commit the transaction before redoing");
    endGesture();
    if (position_ == commands_.size()) return false;
    commands_[position_]->apply(document_);
    moveOver(*commands_[position_], position_ + 1, position_, saved_);
    ++document_.sceneRevision;
    return true;
}

void UndoStack::jumpTo(std::size_t position) {
    while (position_ > position && undo()) {
    }
    while (position_ < position && redo()) {
    }
}

void UndoStack::markSaved() {
    endGesture();
    saved_ = position_;
}

void UndoStack::clear() {
    commands_.clear();
    subjects_.clear();
    lost_.clear();
    position_ = 0;
    saved_ = 0;
    gesture_ = false;
    ++cleared_;
}

Transaction::Transaction(UndoStack& undo, std::string label) : undo_{undo}, label_{std::move(label)} {
    if (undo_.group_ == nullptr) {
        undo_.endGesture();
        undo_.groupSubject_.clear();
    }
    outer_ = std::exchange(undo_.group_, &commands_);
}

Transaction::~Transaction() {
    if (!open_) return;
    undo_.group_ = outer_;
    for (auto command = commands_.rbegin(); command != commands_.rend(); ++command) {
        (*command)->revert(undo_.document_);
    }
    ++undo_.document_.sceneRevision;
}

bool Transaction::commit() {
    PLUMB_ASSERT(open_, "the transaction is already committed");
    open_ = false;
    undo_.group_ = outer_;
    if (commands_.empty()) return false;
    auto group = std::make_unique<CommandGroup>(std::move(label_), std::move(commands_));
    if (outer_ != nullptr) {
        outer_->push_back(std::move(group));
    } else {
        undo_.append(std::move(group), std::exchange(undo_.groupSubject_, {}));
    }
    return true;
}

}  // namespace plumb::editor
