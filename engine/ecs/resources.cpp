#include "ecs/resources.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace plumb {

Resources::Box* Resources::find(TypeKey key) const {
    for (const std::unique_ptr<Box>& box : boxes_) {
        if (box->key == key) return box.get();
    }
    return nullptr;
}

Resources::Box& Resources::insert(std::unique_ptr<Box> box) {
    const auto at =
        std::upper_bound(boxes_.begin(), boxes_.end(), box->nameHash,
                         [](std::uint64_t hash, const auto& known) { return hash < known->nameHash; });
    return **boxes_.insert(at, std::move(box));
}

void Resources::assign(const Resources& other) {
    for (const std::unique_ptr<Box>& box : boxes_) {
        const Box* from = other.find(box->key);
        if (from != nullptr && from->present) continue;
        if (box->present) box->reset();
        box->present = false;
    }
    for (const std::unique_ptr<Box>& from : other.boxes_) {
        if (!from->present) continue;
        if (Box* to = find(from->key)) {
            to->assign(*from);
            to->present = true;
        } else {
            insert(from->copy());
        }
    }
}

std::vector<Resources::Known>& Resources::known() {
    static std::vector<Known> types;
    return types;
}

bool Resources::list(const Known& type) { return known().push_back(type), true; }

/// Returns a copy of the value of a type, or a new one; null if the program has no such type.
std::unique_ptr<Resources::Box> Resources::boxFor(std::string_view name) const {
    for (const std::unique_ptr<Box>& box : boxes_) {
        if (box->name == name) return box->copy();
    }
    const std::vector<Known>& types = known();
    const auto found = std::find_if(types.rbegin(), types.rend(), [name](const Known& type) {
        return type.name == name && (type.version == 0 || type.version == reloadableVersion());
    });
    return found == types.rend() ? nullptr : found->make();
}

void Resources::write(StateArchive& archive, std::vector<Error>& problems) const {
    std::vector<const Box*> saved;
    for (const std::unique_ptr<Box>& box : boxes_) {
        if (!box->present || box->saving() == Saving::Not) continue;
        if (box->saving() == Saving::Whole) {
            saved.push_back(box.get());
        } else {
            problems.push_back({format("resource {}", box->name), "it is not plain data",
                                "add `void archive(StateArchive&)`, which writes and reads its members, or "
                                "`static constexpr bool kNotSaved = true` if it does not belong in saved "
                                "games"});
        }
    }
    archive.count(saved.size());
    for (const Box* box : saved) {
        std::string name{box->name}, bytes;
        archive.text(name);
        StateArchive inner = StateArchive::writer(bytes);
        box->copy()->archive(inner);
        if (!inner.ok())
            problems.push_back({format("resource {}", name), "it could not be written", "see the log"});
        archive.text(bytes);
    }
}

Resources Resources::read(StateArchive& archive, std::vector<Error>& problems) const {
    Resources result;
    for (const std::unique_ptr<Box>& box : boxes_) {
        if (box->present && box->saving() == Saving::Not) result.insert(box->copy());
    }
    const std::size_t count = archive.count(0);
    for (std::size_t i = 0; i < count && archive.ok(); ++i) {
        std::string name, bytes;
        archive.text(name);
        archive.text(bytes);
        std::unique_ptr<Box> box = boxFor(name);
        StateArchive inner = StateArchive::reader(bytes);
        if (box != nullptr) box->archive(inner);
        if (box == nullptr || !inner.ok()) {
            problems.push_back({format("resource {}", name),
                                box == nullptr ? "this version of the game does not have it"
                                               : "it has another layout in this version of the game",
                                "it keeps the value that it has now"});
            const auto present = std::find_if(boxes_.begin(), boxes_.end(), [&](const auto& other) {
                return other->name == name && other->present;
            });
            if (present != boxes_.end() && result.find((*present)->key) == nullptr)
                result.insert((*present)->copy());
            continue;
        }
        box->present = true;
        if (result.find(box->key) == nullptr) result.insert(std::move(box));
    }
    return result;
}

void Resources::dropReloadable() {
    std::erase_if(boxes_, [](const std::unique_ptr<Box>& box) { return isReloadable(box->key); });
}

void Resources::addTo(Hasher& hasher) const {
    for (const std::unique_ptr<Box>& box : boxes_) {
        if (box->present) box->addTo(hasher);
    }
}

}  // namespace plumb
