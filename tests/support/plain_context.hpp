#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/text_store.hpp"
#include "reflect/field_context.hpp"
#include "reflect/json.hpp"

namespace plumb::test {

/// Texts and entities of a test: ids of files are those of `entities`, tiles are numbers.
class PlainContext final : public FieldContext {
public:
    TextStore texts;
    std::map<std::uint64_t, EntityId> entities{{0xab, {7, 1}}};
    std::vector<Error> warnings;

    [[nodiscard]] std::string_view text(TextId id) const override { return texts.find(id); }
    TextId keepText(std::string_view text) override { return texts.add(text); }
    [[nodiscard]] std::uint64_t stableId(EntityId entity) const override {
        for (const auto& [id, known] : entities) {
            if (known == entity) return id;
        }
        return 0;
    }
    [[nodiscard]] EntityId entity(std::uint64_t id) const override {
        const auto found = entities.find(id);
        return found == entities.end() ? EntityId{} : found->second;
    }
    [[nodiscard]] Json tilesToJson(TilesId tiles) const override { return tiles.value; }
    Result<TilesId> tilesFromJson(const FieldInfo&, const Json& json) override {
        return TilesId{json.get<std::uint32_t>()};
    }
    void warn(Error error) override { warnings.push_back(std::move(error)); }
};

}  // namespace plumb::test
