#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_text.hpp"
#include "tests/support/reader_cost.hpp"

namespace plumb::test {

/// All variants of a valid JSON file in which one value is replaced by a value of another type.
class TypeSwaps {
public:
    explicit TypeSwaps(std::string_view text) {
        Result<Json> json = parseJson(text, "sample");
        EXPECT_TRUE(json.ok()) << (json ? "" : json.error().text());
        if (!json) return;
        file_ = *std::move(json);
        collect(file_, "");
    }
    TypeSwaps(const TypeSwaps&) = delete;
    TypeSwaps(TypeSwaps&&) = delete;

    [[nodiscard]] std::size_t count() const { return values_.size() * kStrangers.size(); }
    /// Returns a description of the change: "entities[3].id = [7]".
    [[nodiscard]] std::string name(std::size_t index) const {
        return format("{} = {}", values_[index / kStrangers.size()].where,
                      std::string{kStrangers[index % kStrangers.size()]});
    }
    [[nodiscard]] std::string text(std::size_t index) {
        Json& value = *values_[index / kStrangers.size()].json;
        Json kept = std::exchange(value, *parseJson(kStrangers[index % kStrangers.size()], "stranger"));
        std::string text = writeJson(file_);
        value = std::move(kept);
        return text;
    }

private:
    /// Replacement values of every type: arrays and objects with and without members, negative numbers,
    /// numbers too large for int or float, and one that is within most limits but would create a large
    /// result.
    static constexpr std::array<std::string_view, 13> kStrangers{
        "null",  "true", "7",   "-7", "16384",     "99999999999999999999", "1e300", "-1e300",
        "\"x\"", "[]",   "[7]", "{}", "{\"x\": 7}"};
    struct Value {
        Json* json;
        std::string where;
    };

    void collect(Json& json, const std::string& where) {
        values_.push_back({&json, where});
        std::size_t index = 0;
        for (auto& item : json.items()) {
            if (!json.is_structured()) break;
            collect(item.value(),
                    json.is_array() ? format("{}[{}]", where, index) : where + "." + item.key());
            ++index;
        }
    }

    Json file_;
    std::vector<Value> values_;
};

/// Returns the maximum number of files to test: the value of PLUMB_TYPE_SWAPS, where 0 means all, else
/// `usual`.
inline std::size_t typeSwapLimit(std::size_t usual) {
    const char* wanted = std::getenv("PLUMB_TYPE_SWAPS");
    if (wanted == nullptr) return usual;
    const auto limit = static_cast<std::size_t>(std::strtoull(wanted, nullptr, 10));
    return limit == 0 ? ~std::size_t{0} : limit;
}

/// Returns the position, among `all` items, of item `index` of `wanted` evenly spread items.
inline std::size_t placeOf(std::size_t index, std::size_t wanted, std::size_t all) {
    return wanted == all ? index : index * all / wanted;
}

/// Calls `read(sample, text)` for modified files, evenly spread over all variants of the samples, and checks
/// that none takes too much time or memory.
/// @param usual  number of files if PLUMB_TYPE_SWAPS is not set
template <class Swaps, class Read>
void eachSwap(const std::vector<std::string>& samples, std::size_t usual, Read read) {
    std::size_t all = 0;
    for (const std::string& sample : samples) all += Swaps{sample}.count();
    ASSERT_GT(all, 0u);
    const std::size_t wanted = std::min(typeSwapLimit(usual), all);
    const ReaderCost cost;
    std::size_t first = 0;  // index of this sample's first variant among all variants
    std::size_t next = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        Swaps swaps{samples[i]};
        for (; next < wanted && placeOf(next, wanted, all) < first + swaps.count(); ++next) {
            const std::size_t index = placeOf(next, wanted, all) - first;
            SCOPED_TRACE(format("sample {}: {}", i, swaps.name(index)));
            const std::string text = swaps.text(index);
            cost.expectSmall([&] { read(i, text); });
            if (testing::Test::HasFailure()) return;
        }
        first += swaps.count();
    }
    testing::Test::RecordProperty("files", std::to_string(wanted));
}

/// Calls eachSwap() with all type swaps of JSON files.
template <class Read>
void eachTypeSwap(const std::vector<std::string>& samples, std::size_t usual, Read read) {
    eachSwap<TypeSwaps>(samples, usual, read);
}

/// Expects an error with place, text and remedy, created by the reader itself, not from an exception.
inline void expectReportedWell(const Error& error) {
    EXPECT_FALSE(error.where.empty()) << error.text();
    EXPECT_FALSE(error.what.empty()) << error.text();
    EXPECT_FALSE(error.remedy.empty()) << error.text();
    EXPECT_EQ(error.what.find("the reader of this file failed"), std::string::npos) << error.text();
}
inline void expectReportedWell(const std::vector<Error>& errors) {
    for (const Error& error : errors) expectReportedWell(error);
}

}  // namespace plumb::test
