#include "ecs/events.hpp"

#include <algorithm>
#include <memory>

#include "core/assert.hpp"

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
