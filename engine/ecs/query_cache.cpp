#include "ecs/query_cache.hpp"

#include <algorithm>
#include <utility>

#include "ecs/pool.hpp"
#include "ecs/storage.hpp"

namespace plumb {

namespace {

/// Returns the length of the common prefix of two arrays, as fast as memcmp.
std::uint32_t commonPrefix(const std::uint32_t* a, const std::uint32_t* b, std::uint32_t n) {
    constexpr std::uint32_t kStep = 32;
    std::uint32_t i = 0;
    for (; i + kStep <= n; i += kStep) {
        std::uint32_t differs = 0;
        for (std::uint32_t j = 0; j < kStep; ++j) differs |= a[i + j] ^ b[i + j];
        if (differs != 0) break;
    }
    while (i < n && a[i] == b[i]) ++i;
    return i;
}

}  // namespace

void QueryCache::prepare() {
    prepared = true;
    version_ = 0;
    need_ = care_ = 0;
    for (const Pool* pool : included) need_ |= pool->bit;
    care_ = need_;
    for (const Pool* pool : excluded) care_ |= pool->bit;
    masked_ = (care_ & Storage::kOverflowBit) == 0;
    if (spare_ != nullptr) spare_->prepare();
}

QueryCache& QueryCache::spare() {
    if (spare_ == nullptr) {
        spare_ = std::make_unique<QueryCache>();
        spare_->included = included;
        spare_->excluded = excluded;
        spare_->columns = columns;
        spare_->prepare();
    }
    return *spare_;
}

bool QueryCache::anyHoles() const {
    return std::any_of(included.begin(), included.end(),
                       [](const Pool* pool) { return !pool->holes.empty(); });
}

void QueryCache::rebuild(const EntityRecord* records) {
    const Pool* lead = included[0];
    for (const Pool* pool : included) {
        if (pool->count < lead->count) lead = pool;
    }
    version_ = poolChanges();
    if (indexed && masked_) {  // it was fragmented the last time, so it probably still is
        bool still = false;
        switch (columns) {
            case 1: still = buildIndex<1>(records, *lead); break;
            case 2: still = buildIndex<2>(records, *lead); break;
            case 3: still = buildIndex<3>(records, *lead); break;
            case 4: still = buildIndex<4>(records, *lead); break;
            default: break;
        }
        if (still) return;
    }
    buildRuns(records, *lead);
    const std::size_t runCount = runs.size() / (columns + 1);
    if (runCount * 4 > total) expandRuns();
}

void QueryCache::buildRuns(const EntityRecord* records, const Pool& lead) {
    indexed = false;
    runs.clear();
    total = 0;
    const bool careful =
        anyHoles() || !masked_ ||
        std::any_of(excluded.begin(), excluded.end(), [](const Pool* pool) { return pool->count != 0; });
    for (std::uint32_t k = 0; k < lead.count;) {
        const std::uint32_t index = lead.dense[k];
        if (!matches(records, index)) {
            ++k;
            continue;
        }
        std::uint32_t length = lead.count - k;
        for (std::uint32_t i = 0; i < included.size(); ++i) {
            const Pool& pool = *included[i];
            const std::uint32_t position = pool.sparse[index].position;
            if (i < columns) runs.push_back(position);
            if (&pool == &lead) continue;
            length =
                commonPrefix(lead.dense + k, pool.dense + position, std::min(length, pool.count - position));
        }
        for (std::uint32_t j = 1; careful && j < length; ++j) {
            if (!matches(records, lead.dense[k + j])) length = j;
        }
        runs.push_back(length);
        total += length;
        k += length;
    }
}

/// Writes one tuple of positions per match, without branches.
/// @return false if most matches are consecutive: then runs are faster
template <std::uint32_t N>
bool QueryCache::buildIndex(const EntityRecord* records, const Pool& lead) {
    const std::uint32_t* dense = lead.dense;
    const Slot* sparse[N];
    for (std::uint32_t i = 0; i < N; ++i) sparse[i] = included[i]->sparse;
    runs.resize((std::size_t{lead.count} + 1) * N);
    std::uint32_t* out = runs.data();
    std::uint32_t found = 0;
    std::uint32_t following = 0;
    std::uint32_t before = 0;  // sum of the positions of the previous match
    for (std::uint32_t k = 0; k < lead.count; ++k) {
        const std::uint32_t index = dense[k];
        const std::uint32_t hit = ((records[index].mask ^ need_) & care_) == 0 ? 1u : 0u;
        std::uint32_t sum = 0;
        for (std::uint32_t i = 0; i < N; ++i) {
            const std::uint32_t position = sparse[i][index].position;
            out[i] = position;
            sum += position;
        }
        following += hit & (sum == before + N ? 1u : 0u);
        before = hit != 0 ? sum : before;
        found += hit;
        out += hit * N;
    }
    total = found;
    runs.resize(std::size_t{found} * N);
    return following * std::uint64_t{4} < found * std::uint64_t{3};
}

void QueryCache::expandRuns() {
    std::swap(runs, scratch_);
    runs.clear();
    runs.reserve(std::size_t{total} * columns);
    for (std::size_t at = 0; at < scratch_.size(); at += columns + 1) {
        const std::uint32_t* run = scratch_.data() + at;
        for (std::uint32_t i = 0; i < run[columns]; ++i) {
            for (std::uint32_t k = 0; k < columns; ++k) runs.push_back(run[k] + i);
        }
    }
    indexed = true;
}

}  // namespace plumb
