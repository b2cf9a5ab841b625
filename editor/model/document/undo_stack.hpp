#pragma once

#include <memory>
#include <string>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/document.hpp"

namespace plumb::editor {

/// Undo history of a document since it was opened. Every change of the document goes through it.
class UndoStack {
public:
    explicit UndoStack(Document& document) : document_{document} {}

    /// Applies a command. Until `endGesture`, it may be merged into the previous one, so that a drag is one
    /// step.
    void push(std::unique_ptr<Command> command);
    /// Ends the drag, slider or stroke. If it changed nothing in the end, its step is removed.
    void endGesture();
    /// Reverts the open gesture (Esc).
    void cancelGesture();

    bool undo();
    bool redo();
    /// Undoes or redoes steps until exactly the first `position` steps are applied.
    void jumpTo(std::size_t position);

    [[nodiscard]] std::size_t size() const { return position_; }          ///< number of undoable steps
    [[nodiscard]] std::size_t total() const { return commands_.size(); }  ///< undoable and redoable steps
    [[nodiscard]] std::string label(std::size_t step) const { return commands_[step]->label(); }
    /// Returns the entities that a step changed, by their names at that time: "crate", "crate and 2 more";
    /// empty if it changed no entities.
    [[nodiscard]] const std::string& subject(std::size_t step) const { return subjects_[step]; }
    [[nodiscard]] bool inGesture() const { return gesture_; }

    /// Undone steps that can no longer be redone because another change was made.
    struct Lost {
        std::size_t position = 0;  ///< number of steps before them
        std::size_t steps = 0;
        std::string last;  ///< label and subject of the last lost step
    };
    [[nodiscard]] const std::vector<Lost>& lost() const { return lost_; }

    void markSaved();
    /// Marks that no step matches the file, because another program changed it or it was never written.
    void markUnsaved() { saved_ = kNever; }
    [[nodiscard]] bool isSaved() const { return saved_ == position_; }
    [[nodiscard]] std::size_t savedPosition() const { return saved_; }  ///< kNever: saved in no step
    static constexpr std::size_t kNever = static_cast<std::size_t>(-1);

    /// Clears the history, after another scene was opened.
    void clear();
    [[nodiscard]] std::size_t cleared() const { return cleared_; }  ///< number of clear() calls

private:
    friend class Transaction;

    void append(std::unique_ptr<Command> command, std::string subject);
    [[nodiscard]] std::string nameOf(Subject subject) const;

    Document& document_;
    std::vector<std::unique_ptr<Command>> commands_;
    std::vector<std::string> subjects_;  // by command
    std::vector<Lost> lost_;
    std::size_t position_ = 0;  // number of applied commands
    std::size_t saved_ = 0;     // `position_` at the last save, or kNever
    std::size_t cleared_ = 0;
    bool gesture_ = false;  // the last command can still be merged with the next one
    std::vector<std::unique_ptr<Command>>* group_ = nullptr;  // commands of the open transaction
    std::string groupSubject_;                                // first known subject of the open transaction
};

/// Groups several commands into one undo step. Reverts them if destroyed without commit.
class Transaction {
public:
    Transaction(UndoStack& undo, std::string label);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;

    /// Adds the step to the history. @return false if no command was pushed, so that there is no step
    bool commit();

private:
    UndoStack& undo_;
    std::string label_;
    std::vector<std::unique_ptr<Command>> commands_;
    std::vector<std::unique_ptr<Command>>* outer_ = nullptr;
    bool open_ = true;
};

}  // namespace plumb::editor
