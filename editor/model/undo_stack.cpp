#include "editor/model/undo_stack.hpp"

#include <utility>

namespace plumb::editor {
namespace {

/// Several commands as one.
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

private:
    std::string label_;
    std::vector<std::unique_ptr<Command>> commands_;
};

}  // namespace

void UndoStack::push(std::unique_ptr<Command> command) {
    command->apply(document_);
    ++document_.sceneRevision;
    if (group_ != nullptr) {
        group_->push_back(std::move(command));
        return;
    }
    if (gesture_ && position_ > 0 && commands_[position_ - 1]->absorb(*command)) return;
    endGesture();
    append(std::move(command));
    gesture_ = true;
}

void UndoStack::append(std::unique_ptr<Command> command) {
    if (saved_ != kNever && saved_ > position_) saved_ = kNever;
    commands_.resize(position_);
    commands_.push_back(std::move(command));
    ++position_;
}

void UndoStack::endGesture() {
    if (!std::exchange(gesture_, false)) return;
    if (position_ == commands_.size() && commands_.back()->changesNothing(document_)) {
        commands_.pop_back();
        --position_;
    }
}

void UndoStack::cancelGesture() {
    if (!std::exchange(gesture_, false)) return;
    commands_.back()->revert(document_);
    commands_.pop_back();
    --position_;
    ++document_.sceneRevision;
}

bool UndoStack::undo() {
    PLUMB_ASSERT(group_ == nullptr, "commit the transaction before undoing");
    endGesture();
    if (position_ == 0) return false;
    commands_[--position_]->revert(document_);
    ++document_.sceneRevision;
    return true;
}

bool UndoStack::redo() {
    PLUMB_ASSERT(group_ == nullptr, "commit the transaction before redoing");
    endGesture();
    if (position_ == commands_.size()) return false;
    commands_[position_++]->apply(document_);
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
    position_ = 0;
    saved_ = 0;
    gesture_ = false;
    ++cleared_;
}

Transaction::Transaction(UndoStack& undo, std::string label) : undo_{undo}, label_{std::move(label)} {
    if (undo_.group_ == nullptr) undo_.endGesture();
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
    PLUMB_ASSERT(open_, "a transaction is committed once");
    open_ = false;
    undo_.group_ = outer_;
    if (commands_.empty()) return false;
    auto group = std::make_unique<CommandGroup>(std::move(label_), std::move(commands_));
    if (outer_ != nullptr) {
        outer_->push_back(std::move(group));
    } else {
        undo_.append(std::move(group));
    }
    return true;
}

}  // namespace plumb::editor
