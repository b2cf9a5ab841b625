#pragma once

#include "core/fixed_list.hpp"
#include "core/text_store.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Words that mark the entity, so that code and scripts find it: findEntities(world, "enemy").
struct Tags {
    static constexpr std::size_t kWords = 8;  ///< maximum number of words

    FixedList<TextId, kWords> words;

    [[nodiscard]] bool has(std::string_view word) const {
        const TextId wanted = textId(word);
        for (std::uint32_t i = 0; i < words.count; ++i) {
            if (words[i] == wanted) return true;
        }
        return false;
    }

    static void describe(TypeBuilder<Tags>& type) {
        type.name("Tags").doc("Words that mark the entity, so that code and scripts find it.");
        type.field<&Tags::words>("words").doc(
            "Words by which findEntities() finds the entity, e.g. \"enemy\".");
    }
};

}  // namespace plumb
