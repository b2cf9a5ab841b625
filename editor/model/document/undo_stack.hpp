#pragma once

#include <memory>
#include <string>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/document.hpp"

namespace plumb::editor {

/// All changes of a document since it was opened, and the only door to make one.
class UndoStack {
public:
    explicit UndoStack(Document& document) : document_{document} {}

    /// Applies a command. Until `endGesture` it may melt into the one before: a drag is one step.
    void push(std::unique_ptr<Command> command);
    /// The drag, slider or stroke is over; what came back to where it was leaves no step.
    void endGesture();
    /// Esc: takes the open gesture back.
    void cancelGesture();

    bool undo();
    bool redo();
    /// Goes to the state after the first `position` commands.
    void jumpTo(std::size_t position);

    [[nodiscard]] std::size_t size() const { return position_; }          ///< steps that can be undone
    [[nodiscard]] std::size_t total() const { return commands_.size(); }  ///< with those that can be redone
    [[nodiscard]] std::string label(std::size_t step) const { return commands_[step]->label(); }
    /// The entity that a step was about, by the name it had then: "crate", "crate and 2 more"; empty for
    /// none.
    [[nodiscard]] const std::string& subject(std::size_t step) const { return subjects_[step]; }
    [[nodiscard]] bool inGesture() const { return gesture_; }

    /// Steps that were undone and can never be redone, because another change was made instead.
    struct Lost {
        std::size_t position = 0;  ///< after so many steps
        std::size_t steps = 0;
        std::string last;  ///< label and subject of the last one
    };
    [[nodiscard]] const std::vector<Lost>& lost() const { return lost_; }

    void markSaved();
    /// No step is as in the file: it was changed by another program, or never written.
    void markUnsaved() { saved_ = kNever; }
    [[nodiscard]] bool isSaved() const { return saved_ == position_; }
    [[nodiscard]] std::size_t savedPosition() const { return saved_; }  ///< kNever when it is out of reach
    static constexpr std::size_t kNever = static_cast<std::size_t>(-1);

    /// Forgets all, after another scene was opened.
    void clear();
    [[nodiscard]] std::size_t cleared() const { return cleared_; }  ///< how often

private:
    friend class Transaction;

    void append(std::unique_ptr<Command> command, std::string subject);
    [[nodiscard]] std::string nameOf(Subject subject) const;

    Document& document_;
    std::vector<std::unique_ptr<Command>> commands_;
    std::vector<std::string> subjects_;  // of each command
    std::vector<Lost> lost_;
    std::size_t position_ = 0;
    std::size_t saved_ = 0;
    std::size_t cleared_ = 0;
    bool gesture_ = false;
    std::vector<std::unique_ptr<Command>>* group_ = nullptr;  // of the open transaction
    std::string groupSubject_;                                // of the first command in it that has one
};

/// Makes several commands one step. Destroyed without commit, it takes them back.
class Transaction {
public:
    Transaction(UndoStack& undo, std::string label);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    /// @return false when no command was pushed in it, so that there is no step
    bool commit();

private:
    UndoStack& undo_;
    std::string label_;
    std::vector<std::unique_ptr<Command>> commands_;
    std::vector<std::unique_ptr<Command>>* outer_ = nullptr;
    bool open_ = true;
};

}  // namespace plumb::editor
