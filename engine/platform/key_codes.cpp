#include "platform/key_codes.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace plumb {
namespace {

// Source: USB HID Usage Tables 1.12, page 0x07. A Run is a range with the same order of codes and keys.
struct Run {
    int usage;
    Key first;
    int count;
};

constexpr std::array kRuns{
    Run{4, Key::A, 26},           Run{30, Key::Digit1, 9},
    Run{39, Key::Digit0, 1},      Run{40, Key::Enter, 5},
    Run{45, Key::Minus, 5},       Run{51, Key::Semicolon, 6},
    Run{57, Key::CapsLock, 1},    Run{58, Key::F1, 12},
    Run{70, Key::PrintScreen, 9}, Run{79, Key::Right, 4},
    Run{83, Key::NumLock, 6},     Run{89, Key::Pad1, 9},
    Run{98, Key::Pad0, 1},        Run{99, Key::PadPeriod, 1},
    Run{101, Key::Menu, 1},       Run{224, Key::LeftControl, 8},
};

constexpr int kUsageCount = 256;

constexpr std::array<Key, kUsageCount> makeTable() {
    std::array<Key, kUsageCount> table{};
    for (const Run& run : kRuns) {
        for (int i = 0; i < run.count; ++i) {
            table[static_cast<std::size_t>(run.usage + i)] =
                static_cast<Key>(static_cast<int>(run.first) + i);
        }
    }
    return table;
}

constexpr std::array<Key, kUsageCount> kTable = makeTable();

}  // namespace

Key keyFromUsage(int usage) {
    return usage >= 0 && usage < kUsageCount ? kTable[static_cast<std::size_t>(usage)] : Key::None;
}

int usageOf(Key key) {
    if (key == Key::None) return 0;
    return static_cast<int>(std::find(kTable.begin(), kTable.end(), key) - kTable.begin());
}

}  // namespace plumb
