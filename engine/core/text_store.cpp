#include "core/text_store.hpp"

#include "core/assert.hpp"

namespace plumb {

TextStore::TextStore() : slots_(64) {}

TextStore::TextStore(const TextStore& other) : TextStore{} { *this = other; }

TextStore& TextStore::operator=(const TextStore& other) {
    if (this != &other) {
        for (const std::string& text : other.texts_) {
            add(text);
        }
    }
    return *this;
}

TextId TextStore::add(std::string_view text) {
    const TextId id = textId(text);
    if (id.empty()) return id;
    std::size_t at = slotOf(id.value);
    if (slots_[at].text != nullptr) {
        PLUMB_ASSERT(*slots_[at].text == text, "two texts share a 64-bit hash; change one of them");
        return id;
    }
    if ((texts_.size() + 1) * 2 > slots_.size()) {
        grow();
        at = slotOf(id.value);
    }
    slots_[at] = {id.value, &texts_.emplace_back(text)};
    return id;
}

std::string_view TextStore::find(TextId id) const {
    const std::string* text = slots_[slotOf(id.value)].text;
    return text != nullptr ? std::string_view{*text} : std::string_view{};
}

std::size_t TextStore::slotOf(std::uint64_t id) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = static_cast<std::size_t>(mixBits(id)) & mask;
    while (slots_[at].text != nullptr && slots_[at].id != id) {
        at = (at + 1) & mask;
    }
    return at;
}

void TextStore::grow() {
    std::vector<Slot> old = std::move(slots_);
    slots_.assign(old.size() * 2, {});
    for (const Slot& slot : old) {
        if (slot.text != nullptr) slots_[slotOf(slot.id)] = slot;
    }
}

}  // namespace plumb
