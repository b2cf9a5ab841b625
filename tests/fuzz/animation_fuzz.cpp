#include <cstdlib>

#include "assets/animation.hpp"
#include "assets/clip_cursor.hpp"
#include "tests/fuzz/fuzz_input.hpp"

/// Input that is accepted must be written to a text that reads back to the same text, and every clip must
/// play.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t count) {
    std::vector<plumb::Error> problems;
    const plumb::Result<plumb::AnimationSet> set =
        plumb::parseAnimationSet(plumb::test::textOf(bytes, count), "fuzz", problems);
    if (!set) return 0;
    for (const plumb::Animation& clip : set->clips) {
        plumb::ClipCursor cursor;
        plumb::advanceClip(clip, clip.loop, cursor, 12.3f, [](int) {});
    }
    const std::string text = plumb::writeAnimationSet(*set);
    const plumb::Result<plumb::AnimationSet> again = plumb::parseAnimationSet(text, "again", problems);
    if (!again || plumb::writeAnimationSet(*again) != text) std::abort();
    return 0;
}
