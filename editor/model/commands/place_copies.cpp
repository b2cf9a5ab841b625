#include "editor/model/commands/place_copies.hpp"

#include <map>
#include <set>
#include <utility>

#include "ecs/hierarchy.hpp"
#include "editor/model/commands/reorder.hpp"
#include "scene/components/prefab_instance.hpp"

namespace plumb::editor {
namespace {

using Blocks = std::map<ObjectId, std::vector<ObjectId>>;

bool isPart(const Document& document, ObjectId id) {
    return document.world.has<PrefabPart>(document.find(id));
}

/// Returns the entity that stands for `id` in the file order: `id` itself, or for a part of a prefab instance
/// the outermost instance; null if that does not exist.
ObjectId withPlace(const Document& document, ObjectId id) {
    while (const PrefabPart* part = document.world.find<PrefabPart>(document.find(id))) id = {part->instance};
    return document.find(id) ? id : ObjectId{};
}

/// Groups the copies, with their descendants, by the entity after which they are placed; within a group they
/// keep their order.
Blocks blocksOf(const Document& document, const std::vector<ObjectId>& copies,
                const std::vector<ObjectId>& originals) {
    Blocks blocks;
    std::map<ObjectId, ObjectId> behind;  // by copy: the entity after which it is placed
    for (std::size_t i = 0; i < copies.size(); ++i) {
        const EntityId entity = document.find(copies[i]);
        const auto parent = behind.find(document.idOf(parentOf(document.world, entity)));
        const ObjectId place = parent != behind.end() ? parent->second : withPlace(document, originals[i]);
        behind[copies[i]] = place;
        if (place && !isPart(document, copies[i])) blocks[place].push_back(copies[i]);
    }
    return blocks;
}

/// Second command of insertCopies: moves the copies, which were inserted at the end, after their originals.
class PlaceCopies final : public Command {
public:
    PlaceCopies(std::vector<ObjectId> copies, std::vector<ObjectId> originals)
        : copies_{std::move(copies)}, originals_{std::move(originals)} {}

    [[nodiscard]] std::string label() const override { return "change order"; }
    void apply(Document& document) override { placeCopies(document, copies_, originals_); }
    void revert(Document& document) override { placeAtEnd(document, copies_); }

private:
    std::vector<ObjectId> copies_;
    std::vector<ObjectId> originals_;
};

}  // namespace

void placeCopies(Document& document, const std::vector<ObjectId>& copies,
                 const std::vector<ObjectId>& originals) {
    const Blocks blocks = blocksOf(document, copies, originals);
    if (blocks.empty()) return;
    std::set<ObjectId> moved;
    for (const auto& [place, block] : blocks) moved.insert(block.begin(), block.end());
    std::vector<ObjectId> line;
    std::vector<ObjectId> open;  // originals whose descendants are not all listed yet, innermost last
    const auto closeBefore = [&](EntityId next) {
        while (!open.empty() && (!next || !isAncestor(document.world, document.find(open.back()), next))) {
            const std::vector<ObjectId>& block = blocks.at(open.back());
            line.insert(line.end(), block.begin(), block.end());
            open.pop_back();
        }
    };
    for (const ObjectId id : fileOrder(document)) {
        if (moved.count(id) != 0) continue;
        closeBefore(document.find(id));
        line.push_back(id);
        if (blocks.count(id) != 0) open.push_back(id);
    }
    closeBefore({});
    placeInOrder(document, line);
}

void placeAtEnd(Document& document, const std::vector<ObjectId>& copies) {
    const std::set<ObjectId> moved{copies.begin(), copies.end()};
    std::vector<ObjectId> line = fileOrder(document);
    std::erase_if(line, [&](ObjectId id) { return moved.count(id) != 0; });
    for (const ObjectId id : copies) {
        if (!isPart(document, id)) line.push_back(id);
    }
    placeInOrder(document, line);
}

void insertCopies(UndoStack& undo, std::unique_ptr<InsertEntities> copies, std::vector<ObjectId> originals) {
    Transaction transaction{undo, copies->label()};
    std::vector<ObjectId> ids = copies->ids();
    undo.push(std::move(copies));
    undo.push(std::make_unique<PlaceCopies>(std::move(ids), std::move(originals)));
    transaction.commit();
}

}  // namespace plumb::editor
