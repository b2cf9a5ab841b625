#include "ecs/events.hpp"

#include <algorithm>
#include <memory>

#include "core/assert.hpp"
#include "core/text.hpp"

namespace plumb {

Events::Events() = default;
Events::~Events() = default;

Events::Inbox* Events::find(TypeKey event, TypeKey handler) const {
    if (event >= inboxes_.size()) return nullptr;
    for (const std::unique_ptr<Inbox>& inbox : inboxes_[event]) {
        if (inbox->handler == handler) return inbox.get();
    }
    return nullptr;
}

void Events::closeInboxes(TypeKey handler) {
    for (Inboxes& ofType : inboxes_) {
        std::erase_if(ofType, [=](const std::unique_ptr<Inbox>& inbox) { return inbox->handler == handler; });
    }
}

void Events::failNested() { PLUMB_ASSERT(false, "deliver() was called by the handler to which it delivers"); }

void Events::dropWaiting() {
    for (const Inboxes& ofType : inboxes_) {
        for (const std::unique_ptr<Inbox>& inbox : ofType) inbox->clear();
    }
}

void Events::save(Inboxes& saved) const {
    // In code that was loaded again, the events may have another layout.
    std::erase_if(saved, [](const auto& old) { return old->version != reloadableVersion(); });
    for (const std::unique_ptr<Inbox>& old : saved) old->clear();
    for (const Inboxes& ofType : inboxes_) {
        for (const std::unique_ptr<Inbox>& inbox : ofType) {
            if (inbox->size() == 0) continue;
            const auto same = std::find_if(saved.begin(), saved.end(), [&](const auto& old) {
                return old->type == inbox->type && old->handler == inbox->handler;
            });
            if (same != saved.end()) {
                (*same)->assign(*inbox);
            } else {
                saved.push_back(inbox->copy());
            }
        }
    }
}

void Events::restore(const Inboxes& saved) {
    dropWaiting();
    for (const std::unique_ptr<Inbox>& from : saved) {
        if (Inbox* to = find(from->type, from->handler)) to->assign(*from);
    }
}

void Events::write(StateArchive& archive, std::vector<Error>& problems) const {
    Inboxes filled;
    save(filled);
    std::size_t count = 0;
    std::string all;
    StateArchive inner = StateArchive::writer(all);
    for (const std::unique_ptr<Inbox>& inbox : filled) {
        std::string event{typeNameOf(inbox->type)}, handler{typeNameOf(inbox->handler)}, bytes;
        StateArchive events = StateArchive::writer(bytes);
        if (!inbox->archive(events)) {
            problems.push_back({format("event {}", event),
                                "a handler has yet to receive it, and it is not plain "
                                "data, which cannot be saved",
                                "use texts of world.texts() and lists of a fixed size in events"});
            continue;
        }
        inner.text(event);
        inner.text(handler);
        inner.text(bytes);
        ++count;
    }
    archive.count(count);
    archive.text(all);
}

Events::Inboxes Events::read(StateArchive& archive, std::vector<Error>& problems) const {
    Inboxes inboxes;
    const std::size_t count = archive.count(0);
    std::string all;
    archive.text(all);
    StateArchive inner = StateArchive::reader(all);
    for (std::size_t i = 0; i < count && inner.ok(); ++i) {
        std::string event, handler, bytes;
        inner.text(event);
        inner.text(handler);
        inner.text(bytes);
        StateArchive events = StateArchive::reader(bytes);
        const Inbox* known = find(findTypeKey(event), findTypeKey(handler));
        std::unique_ptr<Inbox> made = known == nullptr ? nullptr : known->copy();
        if (made != nullptr && made->archive(events) && events.ok()) {
            inboxes.push_back(std::move(made));
        } else {
            problems.push_back({format("event {}", event),
                                format("this version of the game has no handler {} for it", handler),
                                "the event was left out"});
        }
    }
    if (!inner.ok()) archive.fail();
    return inboxes;
}

void Events::addTo(Hasher& hasher) const {
    // As a sum, as neither the keys of types nor the order of inboxes are state.
    std::uint64_t sum = 0;
    for (const Inboxes& ofType : inboxes_) {
        for (const std::unique_ptr<Inbox>& inbox : ofType) {
            if (inbox->size() == 0) continue;
            Hasher one;
            one.add(typeNameOf(inbox->type));
            one.add(std::uint64_t{inbox->size()});
            sum += one.value();
        }
    }
    if (sum != 0) hasher.add(sum);
}

}  // namespace plumb
