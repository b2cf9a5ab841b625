#include "input/binding.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

constexpr BindingKind kKinds[] = {BindingKind::Key,     BindingKind::MouseButton, BindingKind::PadButton,
                                  BindingKind::PadAxis, BindingKind::PadAxisPlus, BindingKind::PadAxisMinus};

bool isOfPad(BindingKind kind) { return kind != BindingKind::Key && kind != BindingKind::MouseButton; }

std::size_t codesOf(BindingKind kind) {
    if (kind == BindingKind::Key) return kKeyCount;
    if (kind == BindingKind::MouseButton) return kMouseButtonCount;
    return kind == BindingKind::PadButton ? kPadButtonCount : kPadAxisCount;
}

/// Calls `f` for every binding that exists.
template <class F>
void forEachBinding(F&& f) {
    for (const BindingKind kind : kKinds) {
        for (std::size_t code = kind == BindingKind::Key ? 1 : 0; code < codesOf(kind); ++code) {
            f(Binding{kind, static_cast<std::uint8_t>(code)});
            for (std::int8_t pad = 0; isOfPad(kind) && pad < kPadCount; ++pad)
                f(Binding{kind, static_cast<std::uint8_t>(code), pad});
        }
    }
}

TEST(Binding, hasTheTextOfItsDeviceItsPartAndItsHalf) {
    const struct {
        Binding binding;
        const char* text;
    } cases[] = {
        {{BindingKind::Key, static_cast<std::uint8_t>(Key::Space)}, "Space"},
        {{BindingKind::Key, static_cast<std::uint8_t>(Key::Digit7)}, "7"},
        {{BindingKind::Key, static_cast<std::uint8_t>(Key::Pad1)}, "Pad1"},
        {{BindingKind::MouseButton, static_cast<std::uint8_t>(MouseButton::X2)}, "Mouse X2"},
        {{BindingKind::PadButton, static_cast<std::uint8_t>(PadButton::LeftShoulder)}, "Pad LeftShoulder"},
        {{BindingKind::PadButton, static_cast<std::uint8_t>(PadButton::A), 0}, "Pad1 A"},
        {{BindingKind::PadAxis, static_cast<std::uint8_t>(PadAxis::RightY), 3}, "Pad4 RightY"},
        {{BindingKind::PadAxisPlus, static_cast<std::uint8_t>(PadAxis::LeftX)}, "Pad LeftX+"},
        {{BindingKind::PadAxisMinus, static_cast<std::uint8_t>(PadAxis::LeftTrigger), 1},
         "Pad2 LeftTrigger-"},
    };
    for (const auto& test : cases) {
        EXPECT_EQ(toText(test.binding), test.text);
        EXPECT_EQ(bindingFromText(test.text), test.binding) << test.text;
    }
}

TEST(BindingProperty, everyBindingReadsBackFromItsText) {
    forEachBinding(
        [](Binding binding) { ASSERT_EQ(bindingFromText(toText(binding)), binding) << toText(binding); });
    for (const BindingKind kind : kKinds) {
        for (std::size_t code = codesOf(kind); code < 256; ++code) {
            const Binding none{kind, static_cast<std::uint8_t>(code)};
            ASSERT_EQ(bindingFromText(toText(none)), std::nullopt) << toText(none);
        }
    }
}

TEST(Binding, otherTextsAreNone) {
    for (const char* text :
         {"",         "space",  "Space ",     " Space",      "Mouse",      "Mouse ",     "MouseLeft",
          "Mouse Up", "Pad",    "Pad ",       "PadA",        "Pad  A",     "Pad Q",      "Pad A+",
          "Pad A-",   "Pad0 A", "Pad5 A",     "Pad9 A",      "Pad12 A",    "Pad1A",      "Pad1 ",
          "Pad +",    "Pad -",  "Pad LeftX*", "Pad LeftX++", "Pad LeftQ-", "Pad LeftX ", "Key A",
          "+",        "-"}) {
        EXPECT_EQ(bindingFromText(text), std::nullopt) << "\"" << text << "\"";
    }
    for (int pad = 1; pad <= kPadCount; ++pad)
        EXPECT_EQ(bindingFromText(format("Pad{} A", pad))->pad, pad - 1);
}

TEST(Binding, theClosestOneToAMistypedTextIsOneThatExists) {
    EXPECT_EQ(closestBinding("Spacee"), "Space");
    EXPECT_EQ(closestBinding("Mouse Lft"), "Mouse Left");
    EXPECT_EQ(closestBinding("Pad LeftSholder"), "Pad LeftShoulder");
    EXPECT_EQ(closestBinding("Pad RightXX"), "Pad RightX");
    EXPECT_EQ(closestBinding("Manu"), "Menu");
    EXPECT_EQ(closestBinding("nothing like any of these names"), "");
    const auto check = [](const std::string& text) {
        const std::string closest = closestBinding(text);
        EXPECT_TRUE(closest.empty() || bindingFromText(closest)) << text << ": " << closest;
    };
    for (const char* text : {"Mouse", "Mouse ", "Pad", "Pad ", "Pad +"}) check(text);
    forEachBinding([&](Binding binding) {
        const bool isListed = binding.pad == Binding::kAnyPad && binding.kind != BindingKind::PadAxisPlus &&
                              binding.kind != BindingKind::PadAxisMinus;
        const std::string text = toText(binding);
        if (isListed) {
            EXPECT_EQ(closestBinding(text), text);
            check(text.substr(0, text.size() - 1));
        }
    });
}

InputFrame withAxes(Random& random) {
    InputFrame frame;
    for (PadFrame& pad : frame.pads) {
        pad.buttons = static_cast<std::uint16_t>(random.below(1u << kPadButtonCount));
        for (std::int16_t& axis : pad.axes) {
            // Small, large and extreme values.
            const int whole = static_cast<int>(random.below(65'535)) - 32'767;
            const std::uint32_t size = random.below(4);
            axis = static_cast<std::int16_t>(size == 0   ? whole / 16
                                             : size == 1 ? (whole < 0 ? -32'767 : 32'767)
                                                         : whole);
        }
    }
    for (std::uint32_t n = random.below(20); n > 0; --n)
        frame.set(static_cast<Key>(1 + random.below(kKeyCount - 1)), true);
    frame.mouseButtons = static_cast<std::uint16_t>(random.below(1u << kMouseButtonCount));
    return frame;
}

/// The value of an axis by the definition in binding.hpp, in double precision.
double expectedAxis(const PadFrame& pad, std::size_t axis, double deadZone) {
    const auto at = [&](std::size_t which) { return pad.axes[which] / 32767.0; };
    const bool isStick = axis < 4;  // LeftX, LeftY, RightX, RightY; then triggers
    const std::size_t x = axis / 2 * 2;
    const double reach = isStick ? std::hypot(at(x), at(x + 1)) : std::abs(at(axis));
    if (reach <= deadZone || deadZone >= 1.0) return 0.0;
    return at(axis) / reach * (std::min(reach, 1.0) - deadZone) / (1.0 - deadZone);
}

double expectedOn(Binding binding, const PadFrame& pad, double deadZone) {
    if (binding.kind == BindingKind::PadButton) return pad.buttons >> binding.code & 1;
    const double axis = expectedAxis(pad, binding.code, deadZone);
    if (binding.kind == BindingKind::PadAxisPlus) return std::max(axis, 0.0);
    return binding.kind == BindingKind::PadAxisMinus ? std::max(-axis, 0.0) : axis;
}

double expectedStrength(Binding binding, const InputFrame& frame, double deadZone) {
    if (binding.kind == BindingKind::Key) return frame.keys[binding.code / 32] >> binding.code % 32 & 1;
    if (binding.kind == BindingKind::MouseButton) return frame.mouseButtons >> binding.code & 1;
    if (binding.pad != Binding::kAnyPad)
        return expectedOn(binding, frame.pads[static_cast<std::size_t>(binding.pad)], deadZone);
    double strongest = 0.0;
    for (const PadFrame& pad : frame.pads) {
        const double strength = expectedOn(binding, pad, deadZone);
        if (std::abs(strength) > std::abs(strongest)) strongest = strength;
    }
    return strongest;
}

TEST(BindingProperty, theStrengthIsThatOfItsDefinition) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const InputFrame frame = withAxes(random);
        for (const float deadZone : {0.0f, 0.2f, 0.3f + 0.01f * static_cast<float>(seed), 0.95f, 1.0f}) {
            forEachBinding([&](Binding binding) {
                const double expected = expectedStrength(binding, frame, double{deadZone});
                const float strength = strengthOf(binding, frame, deadZone);
                ASSERT_NEAR(double{strength}, expected, 1e-4)
                    << toText(binding) << ", dead zone " << deadZone;
                ASSERT_LE(std::abs(strength), 1.0f);
                if (std::abs(std::abs(expected) - 0.5) > 1e-4) {
                    ASSERT_EQ(isHeld(binding, frame, deadZone), std::abs(expected) > 0.5) << toText(binding);
                }
            });
        }
    }
}

InputFrame axisAt(std::size_t pad, PadAxis axis, int value) {
    InputFrame frame;
    frame.pads[pad].axes[static_cast<std::size_t>(axis)] = static_cast<std::int16_t>(value);
    return frame;
}

TEST(Binding, aCenteredAxisIsZeroWithoutADeadZoneToo) {
    for (std::size_t axis = 0; axis < kPadAxisCount; ++axis)
        EXPECT_EQ(strengthOf({BindingKind::PadAxis, static_cast<std::uint8_t>(axis), 0}, {}, 0.0f), 0.0f);
}

TEST(Binding, aDeadZoneOfTheWholeRangeLeavesNothing) {
    InputFrame corner;
    corner.pads[0].axes.fill(32'767);
    for (const float deadZone : {1.0f, 1.2f}) {
        for (std::size_t axis = 0; axis < kPadAxisCount; ++axis) {
            const Binding binding{BindingKind::PadAxis, static_cast<std::uint8_t>(axis), 0};
            EXPECT_EQ(strengthOf(binding, corner, deadZone), 0.0f);
        }
    }
}

TEST(Binding, anAxisIsHeldBeyondHalfOfItsRange) {
    constexpr Binding kTrigger{BindingKind::PadAxisPlus, static_cast<std::uint8_t>(PadAxis::LeftTrigger)};
    for (const int value : {16'500, 20'000, 24'576, 32'000}) {
        SCOPED_TRACE(value);
        const InputFrame frame = axisAt(0, PadAxis::LeftTrigger, value);
        // With this dead zone the axis is exactly in the middle of the rest.
        const float deadZone = 2.0f * frame.pads[0].axis(PadAxis::LeftTrigger) - 1.0f;
        ASSERT_EQ(strengthOf(kTrigger, frame, deadZone), 0.5f);
        EXPECT_FALSE(isHeld(kTrigger, frame, deadZone));
        EXPECT_TRUE(isHeld(kTrigger, axisAt(0, PadAxis::LeftTrigger, value + 1), deadZone));
    }
    constexpr Binding kLeft{BindingKind::PadAxisMinus, static_cast<std::uint8_t>(PadAxis::LeftX)};
    constexpr Binding kWhole{BindingKind::PadAxis, static_cast<std::uint8_t>(PadAxis::LeftX)};
    const InputFrame left = axisAt(2, PadAxis::LeftX, -32'767);
    EXPECT_TRUE(isHeld(kLeft, left, 0.2f));
    EXPECT_TRUE(isHeld(kWhole, left, 0.2f)) << "in both directions";
    EXPECT_FALSE(isHeld(kLeft, axisAt(2, PadAxis::LeftX, 32'767), 0.2f));
}

TEST(Binding, ofGamepadsPushedEquallyFarTheFirstCounts) {
    constexpr Binding kBinding{BindingKind::PadAxis, static_cast<std::uint8_t>(PadAxis::RightX)};
    for (const int value : {32'767, -32'767, 20'000, -20'000}) {
        InputFrame frame = axisAt(1, PadAxis::RightX, value);
        frame.pads[3].axes[2] = static_cast<std::int16_t>(-value);
        EXPECT_EQ(strengthOf(kBinding, frame, 0.0f), frame.pads[1].axis(PadAxis::RightX));
        frame.pads[3].axes[2] = static_cast<std::int16_t>(value > 0 ? -32'767 : 32'767);
        if (std::abs(value) < 32'767) {
            EXPECT_EQ(strengthOf(kBinding, frame, 0.0f), value > 0 ? -1.0f : 1.0f);
        }
    }
}

TEST(InputFrameTest, theMouseIsRoundedDownAndStaysInTheRange) {
    const struct {
        float position;
        int expected;
    } cases[] = {{0.0f, 0},
                 {0.9f, 0},
                 {-0.1f, -1},
                 {-1.0f, -1},
                 {12.5f, 12},
                 {32'767.5f, 32'767},
                 {32'768.0f, 32'767},
                 {1e9f, 32'767},
                 {-32'767.5f, -32'768},
                 {-32'768.0f, -32'768},
                 {-1e9f, -32'768},
                 {std::numeric_limits<float>::quiet_NaN(), -32'768}};
    for (const auto& test : cases) {
        InputFrame frame;
        frame.setMouse({test.position, 7.0f});
        EXPECT_EQ(frame.mouseX, test.expected) << test.position;
        EXPECT_EQ(frame.mouse(), (Vec2{static_cast<float>(test.expected), 7.0f}));
        frame.setMouse({-7.0f, test.position});
        EXPECT_EQ(frame.mouse(), (Vec2{-7.0f, static_cast<float>(test.expected)}));
    }
}

}  // namespace
}  // namespace plumb
