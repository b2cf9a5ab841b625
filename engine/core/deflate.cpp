#include "core/deflate.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <numeric>
#include <vector>

namespace plumb {
namespace {

// All numbers are those of RFC 1951.
constexpr std::size_t kWordBytes = 4;
constexpr std::size_t kMaxWords = 64;    // of one match: 256 of the 258 bytes that are allowed
constexpr std::size_t kFarthest = 8192;  // words: 32768 bytes
constexpr std::size_t kRow = 128;        // words: the row above in a block of tiles
constexpr std::size_t kLetters = 286;    // literals, end of block, and match lengths
constexpr std::size_t kDistances = 30;
constexpr std::size_t kEnd = 256;
constexpr int kMaxBits = 15;       // of a code
constexpr int kMaxLengthBits = 7;  // of the code that encodes the lengths of the other codes
constexpr std::uint32_t kAdlerPrime = 65521;
constexpr std::size_t kAdlerWords = 1024;  // sums of so many fit into 32 bits

/// Codes of an alphabet, by symbol; symbols with length 0 do not occur.
struct Codes {
    std::vector<std::uint8_t> lengths;
    std::vector<std::uint16_t> bits;  // first bit lowest, as they are written
};

/// Depths of a Huffman tree. Of equally frequent symbols the first
/// one is deeper, so that the tree depends on the counts only.
std::vector<std::uint8_t> depthsOf(const std::vector<std::uint32_t>& counts) {
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0) used.push_back(i);
    }
    std::stable_sort(used.begin(), used.end(),
                     [&](std::size_t a, std::size_t b) { return counts[a] < counts[b]; });
    const std::size_t leaves = used.size();
    std::vector<std::uint64_t> weight(leaves * 2);
    std::vector<std::size_t> above(leaves * 2);
    for (std::size_t i = 0; i < leaves; ++i) weight[i] = counts[used[i]];
    // Leaves and inner nodes are each in ascending order: the two lightest are at the front of the two lists.
    std::size_t leaf = 0;
    std::size_t inner = leaves;
    for (std::size_t made = leaves; made + 1 < leaves * 2; ++made) {
        for (int child = 0; child < 2; ++child) {
            const bool takesLeaf = leaf < leaves && (inner >= made || weight[leaf] <= weight[inner]);
            const std::size_t lightest = takesLeaf ? leaf++ : inner++;
            weight[made] += weight[lightest];
            above[lightest] = made;
        }
    }
    std::vector<std::uint8_t> depth(leaves * 2);
    for (std::size_t node = leaves * 2 - 2; node-- > 0;)
        depth[node] = static_cast<std::uint8_t>(depth[above[node]] + 1);
    std::vector<std::uint8_t> lengths(counts.size());
    for (std::size_t i = 0; i < leaves; ++i) lengths[used[i]] = depth[i];
    return lengths;
}

std::uint16_t reversed(std::uint32_t bits, int count) {
    std::uint32_t turned = 0;
    for (int i = 0; i < count; ++i) turned |= (bits >> i & 1u) << (count - 1 - i);
    return static_cast<std::uint16_t>(turned);
}

Codes codesOf(std::vector<std::uint32_t> counts, int most) {
    // Some readers refuse codes with fewer than two symbols, because these are incomplete trees.
    for (std::size_t i = 0;
         std::count(counts.begin(), counts.end(), 0u) + 2 > static_cast<std::ptrdiff_t>(counts.size()); ++i) {
        if (counts[i] == 0) counts[i] = 1;
    }
    Codes codes;
    codes.lengths = depthsOf(counts);
    while (*std::max_element(codes.lengths.begin(), codes.lengths.end()) > most) {
        for (std::uint32_t& count : counts) count = (count + 1) / 2;  // flatter; no symbol vanishes
        codes.lengths = depthsOf(counts);
    }
    std::array<std::uint32_t, kMaxBits + 2> next{};
    for (const std::uint8_t length : codes.lengths) {
        if (length > 0) ++next[std::size_t{length} + 1];
    }
    for (std::size_t bits = 1; bits < next.size(); ++bits) next[bits] = (next[bits] + next[bits - 1]) << 1;
    codes.bits.resize(codes.lengths.size());
    for (std::size_t i = 0; i < codes.lengths.size(); ++i) {
        const std::uint8_t length = codes.lengths[i];
        if (length > 0) codes.bits[i] = reversed(next[length]++, length);
    }
    return codes;
}

class BitWriter {
public:
    explicit BitWriter(std::string& out) : out_{out} {}

    void put(std::uint64_t bits, int count) {
        bits_ |= bits << held_;
        held_ += count;
        for (; held_ >= 8; held_ -= 8, bits_ >>= 8) out_ += static_cast<char>(bits_);
    }
    void put(const Codes& codes, std::size_t letter) { put(codes.bits[letter], codes.lengths[letter]); }
    void fillByte() {
        if (held_ > 0) put(0, 8 - held_);
    }

private:
    std::string& out_;
    std::uint64_t bits_ = 0;
    int held_ = 0;
};

/// A length or a distance as encoded: a symbol and its extra bits.
struct Spelling {
    std::size_t letter = 0;
    std::uint32_t rest = 0;
    int restBits = 0;
};

/// @param bytes  4 .. 256
Spelling spellLength(std::size_t bytes) {
    const auto from = static_cast<std::uint32_t>(bytes - 3);
    if (from < 8) return {257 + from, 0, 0};
    const int high = std::bit_width(from) - 1;
    const int bits = high - 2;
    return {257u + 4u * static_cast<std::uint32_t>(high - 1) + (from >> bits & 3u),
            from & ((1u << bits) - 1u), bits};
}

/// @param bytes  4 .. 32768
Spelling spellDistance(std::size_t bytes) {
    const auto from = static_cast<std::uint32_t>(bytes - 1);
    if (from < 4) return {from, 0, 0};
    const int high = std::bit_width(from) - 1;
    const int bits = high - 1;
    return {2u * static_cast<std::uint32_t>(high) + (from >> bits & 1u), from & ((1u << bits) - 1u), bits};
}

/// A literal word, or a match of words `distance` words before.
struct Token {
    std::uint16_t words = 0;  ///< 0: a literal word
    std::uint16_t distance = 0;
};

/// Finds matches: at the last occurrence of each word, right before, and one row above.
class Matcher {
public:
    explicit Matcher(std::span<const std::uint32_t> words) : words_{words} { last_.fill(kNowhere); }

    void find(std::vector<Token>& tokens) {
        for (std::size_t at = 0; at < words_.size();) {
            std::uint32_t& last = last_[slotOf(words_[at])];
            Token best;
            consider(at, 1, best);
            if (best.words < kMaxWords) consider(at, kRow, best);
            if (best.words < kMaxWords && last != kNowhere) consider(at, at - last, best);
            last = static_cast<std::uint32_t>(at);
            tokens.push_back(best);
            const std::size_t step = std::max<std::size_t>(best.words, 1);
            // New content begins at the end of a match: the next search should find that.
            if (step > 1) last_[slotOf(words_[at + step - 1])] = static_cast<std::uint32_t>(at + step - 1);
            at += step;
        }
    }

private:
    static constexpr int kSlotBits = 12;
    static constexpr std::uint32_t kNowhere = ~0u;

    static std::size_t slotOf(std::uint32_t word) { return word * 2654435761u >> (32 - kSlotBits); }

    void consider(std::size_t at, std::size_t distance, Token& best) const {
        if (distance > at || distance > kFarthest) return;
        const std::uint32_t* here = words_.data() + at;
        const std::uint32_t* before = here - distance;
        const std::size_t most = std::min(words_.size() - at, kMaxWords);
        if (best.words > 0 && (best.words >= most || here[best.words] != before[best.words])) return;
        std::size_t count = 0;
        while (count < most && here[count] == before[count]) ++count;
        if (count > best.words)
            best = {static_cast<std::uint16_t>(count), static_cast<std::uint16_t>(distance)};
    }

    std::span<const std::uint32_t> words_;
    std::array<std::uint32_t, std::size_t{1} << kSlotBits> last_{};
};

/// Adler-32 checksum over all bytes, stored at the end.
std::uint32_t adlerOf(std::span<const std::uint32_t> words) {
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    while (!words.empty()) {
        const auto part = words.first(std::min(words.size(), kAdlerWords));
        for (const std::uint32_t word : part) {
            const std::uint32_t first = word & 255u, second = word >> 8 & 255u, third = word >> 16 & 255u;
            const std::uint32_t fourth = word >> 24;
            b += 4 * a + 4 * first + 3 * second + 2 * third + fourth;
            a += first + second + third + fourth;
        }
        a %= kAdlerPrime, b %= kAdlerPrime;
        words = words.subspan(part.size());
    }
    return b << 16 | a;
}

void writeCodes(BitWriter& out, const Codes& letters, const Codes& distances) {
    // In the order of RFC 1951: lengths that are often 0 come last.
    constexpr std::array<std::uint8_t, 19> kOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                  11, 4,  12, 3, 13, 2, 14, 1, 15};
    std::vector<std::uint8_t> lengths = letters.lengths;
    lengths.insert(lengths.end(), distances.lengths.begin(), distances.lengths.end());
    struct Part {
        std::uint8_t letter;
        std::uint8_t rest;
        int restBits;
    };
    std::vector<Part> parts;
    for (std::size_t at = 0; at < lengths.size();) {
        const auto same = static_cast<std::size_t>(
                              std::find_if(lengths.begin() + static_cast<std::ptrdiff_t>(at), lengths.end(),
                                           [&](std::uint8_t length) { return length != lengths[at]; }) -
                              lengths.begin()) -
                          at;
        if (lengths[at] == 0 && same >= 11) {
            const std::size_t run = std::min<std::size_t>(same, 138);
            parts.push_back({18, static_cast<std::uint8_t>(run - 11), 7});
            at += run;
        } else if (lengths[at] == 0 && same >= 3) {
            parts.push_back({17, static_cast<std::uint8_t>(same - 3), 3});
            at += same;
        } else {
            parts.push_back({lengths[at], 0, 0});
            ++at;
        }
    }
    std::vector<std::uint32_t> counts(19);
    for (const Part& part : parts) ++counts[part.letter];
    const Codes codes = codesOf(counts, kMaxLengthBits);
    std::size_t stored = kOrder.size();
    while (stored > 4 && codes.lengths[kOrder[stored - 1]] == 0) --stored;
    out.put(letters.lengths.size() - 257, 5);
    out.put(distances.lengths.size() - 1, 5);
    out.put(stored - 4, 4);
    for (std::size_t i = 0; i < stored; ++i) out.put(codes.lengths[kOrder[i]], 3);
    for (const Part& part : parts) {
        out.put(codes, part.letter);
        out.put(part.rest, part.restBits);
    }
}

}  // namespace

std::string packZlib(std::span<const std::uint32_t> words) {
    std::vector<Token> tokens;
    tokens.reserve(words.size() / 8);
    Matcher{words}.find(tokens);

    std::vector<std::uint32_t> letterCounts(kLetters);
    std::vector<std::uint32_t> distanceCounts(kDistances);
    std::size_t at = 0;
    for (const Token& token : tokens) {
        if (token.words == 0) {
            for (int byte = 0; byte < 32; byte += 8) ++letterCounts[words[at] >> byte & 255u];
            ++at;
        } else {
            ++letterCounts[spellLength(token.words * kWordBytes).letter];
            ++distanceCounts[spellDistance(token.distance * kWordBytes).letter];
            at += token.words;
        }
    }
    letterCounts[kEnd] = 1;
    const Codes letters = codesOf(std::move(letterCounts), kMaxBits);
    const Codes distances = codesOf(std::move(distanceCounts), kMaxBits);

    std::string packed;
    packed.reserve(tokens.size() * 3 + 256);
    packed += '\x78';  // deflate with a window of 32 KiB
    packed += '\x01';  // fastest compression; makes the first two bytes a multiple of 31
    BitWriter out{packed};
    out.put(1, 1);  // the last block
    out.put(2, 2);  // with codes of its own
    writeCodes(out, letters, distances);
    at = 0;
    for (const Token& token : tokens) {
        if (token.words == 0) {
            for (int byte = 0; byte < 32; byte += 8) out.put(letters, words[at] >> byte & 255u);
            ++at;
            continue;
        }
        const Spelling length = spellLength(token.words * kWordBytes);
        out.put(letters, length.letter);
        out.put(length.rest, length.restBits);
        const Spelling distance = spellDistance(token.distance * kWordBytes);
        out.put(distances, distance.letter);
        out.put(distance.rest, distance.restBits);
        at += token.words;
    }
    out.put(letters, kEnd);
    out.fillByte();
    const std::uint32_t sum = adlerOf(words);
    for (int shift = 24; shift >= 0; shift -= 8) packed += static_cast<char>(sum >> shift & 255u);
    return packed;
}

}  // namespace plumb
