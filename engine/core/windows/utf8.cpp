#include <cstdint>
#include <cstring>
#include <cwchar>

// All texts of Plumb are UTF-8, and so are the paths that it converts to and from std::string. libstdc++
// writes UTF-8, but reads such paths by mbrtowc(), which knows the code page of the system alone: this one
// replaces it in the program. core/windows/os.cpp refers to it, so that it is linked.
namespace plumb::os {

extern const bool kPathsAreUtf8;
const bool kPathsAreUtf8 = true;

namespace {

/// Number of bytes after the first byte of a sequence; -1 if none starts with it.
int continuationBytes(unsigned char lead) {
    if (lead < 0x80) return 0;
    if (lead >= 0xc2 && lead < 0xe0) return 1;
    if (lead >= 0xe0 && lead < 0xf0) return 2;
    return lead >= 0xf0 && lead < 0xf5 ? 3 : -1;
}

constexpr std::size_t kInvalid = static_cast<std::size_t>(-1), kIncomplete = static_cast<std::size_t>(-2);
constexpr int kPending = 16;  // flag in the state: the high surrogate of a pair was returned

}  // namespace
}  // namespace plumb::os

/// A character beyond 16 bits is returned in two calls, as the pair of surrogates that Windows uses: the
/// first one takes three bytes of it, the second one the last byte. The state has the four bits that both
/// need.
extern "C" std::size_t mbrtowc(wchar_t* out, const char* text, std::size_t count, std::mbstate_t* state) {
    using namespace plumb::os;
    static std::mbstate_t own;
    if (state == nullptr) state = &own;
    if (text == nullptr) return 0;
    if (count == 0) return kIncomplete;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const auto isContinuation = [&](std::size_t i) { return (byte(i) & 0xc0) == 0x80; };
    wchar_t value = 0;
    std::size_t used = 0;
    if ((*state & kPending) != 0) {
        if (!isContinuation(0)) return kInvalid;
        value = static_cast<wchar_t>(0xdc00 | (*state & 15) << 6 | (byte(0) & 0x3f));
        *state = 0;
        used = 1;
    } else {
        const int more = continuationBytes(byte(0));
        if (more < 0) return kInvalid;
        used = static_cast<std::size_t>(more == 3 ? 3 : more + 1);
        if (count < used) return kIncomplete;
        std::uint32_t code = more == 0 ? byte(0) : byte(0) & (0x3f >> more);
        for (std::size_t i = 1; i < used; ++i) {
            if (!isContinuation(i)) return kInvalid;
            code = code << 6 | (byte(i) & 0x3f);
        }
        if (more == 3) {  // all but the last six bits
            if (code < 0x400 || code >= 0x4400) return kInvalid;
            *state = kPending | static_cast<int>(code & 15);
            code = 0xd800 | (code - 0x400) >> 4;
        }
        value = static_cast<wchar_t>(code);
    }
    if (out != nullptr) *out = value;
    return value == 0 ? 0 : used;
}

// The other two functions of the object file that they replace.

extern "C" std::size_t mbrlen(const char* text, std::size_t count, std::mbstate_t* state) {
    static std::mbstate_t own;
    return mbrtowc(nullptr, text, count, state != nullptr ? state : &own);
}

extern "C" std::size_t mbsrtowcs(wchar_t* out, const char** text, std::size_t count, std::mbstate_t* state) {
    std::mbstate_t own = 0;
    if (state == nullptr) state = &own;
    const char* at = *text;
    for (std::size_t written = 0;; ++written) {
        if (out != nullptr && written == count) {
            *text = at;
            return written;
        }
        wchar_t value = 0;
        const std::size_t used = mbrtowc(&value, at, std::strlen(at) + 1, state);
        if (used == plumb::os::kInvalid || used == plumb::os::kIncomplete) return plumb::os::kInvalid;
        if (out != nullptr) out[written] = value;
        if (value == 0) {
            if (out != nullptr) *text = nullptr;
            return written;
        }
        at += used;
    }
}
