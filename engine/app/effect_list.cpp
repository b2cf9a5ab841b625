#include "app/effect_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/game.hpp"
#include "core/clock.hpp"
#include "core/profile.hpp"
#include "core/text.hpp"
#include "physics/simulation.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics_bridge.hpp"

namespace plumb {
namespace {

constexpr double kMicro = 1e6;
constexpr int kRounds = 3;        // repetitions; the fastest is used, as other programs can only slow it down
constexpr int kWarmUpTicks = 20;  // ticks until all memory is allocated
constexpr double kLongRound = 0.03;  // s: longer runs are shortened to fewer ticks
constexpr int kFewestTicks = 20;     // minimum number of measured ticks

bool isOfPhysics(const EffectRow& row) { return row.physics != physics::Effect::Count; }

double microsecondsOf(const Profile& profile, std::string_view zone, int ticks, double overhead) {
    for (const Profile::Zone& measured : profile.zones()) {
        if (measured.name != zone) continue;
        return std::max(measured.seconds - overhead * measured.calls, 0.0) * kMicro / ticks;
    }
    return 0.0;
}

/// Plays ticks and returns the mean time of one, µs. @param from  snapshot that is restored afterwards
double play(Game& game, const Snapshot& from, int ticks) {
    const double start = threadSeconds();
    for (int i = 0; i < ticks; ++i) tickGame(game, InputFrame{});
    const double seconds = threadSeconds() - start;
    game.world.restore(from);
    game.onLateUpdate(0.0f);  // updates state outside the restored world, e.g. the list of assets in use
    return seconds * kMicro / ticks;
}

// Text table.

struct Column {
    std::string_view title;
    std::size_t width;
    bool right = false;
};
constexpr Column kColumns[] = {{"effect", 21},        {"runs", 6},        {"pinned", 8},
                               {"us/tick", 11, true}, {"share", 8, true}, {"saves us", 10, true},
                               {"  requested by", 0}};

void cell(std::string& line, const Column& column, std::string_view text) {
    const std::size_t blank = column.width > text.size() ? column.width - text.size() : 0;
    if (column.right) line.append(blank, ' ');
    line.append(text);
    if (!column.right) line.append(blank, ' ');
}

std::string requestersText(const EffectRow& row, const EffectLine& line) {
    std::string text;
    for (const EffectCount& requester : line.requesters)
        text += format("{}{} ({})", text.empty() ? "" : ", ", requester.type->name, requester.count);
    if (!text.empty()) return line.isRequired ? text : text + ", none of which requests it now";
    if (line.isRequired) return "tiles or game code";
    return "none of: " + missingRequesters(row);
}

std::string lineText(const EffectReport& report, const EffectLine& line) {
    const EffectRow& row = report.table->rows()[line.row];
    std::string text = "  ";
    const auto number = [](double value, int digits) { return fixedText(value, digits); };
    cell(text, kColumns[0], row.name);
    cell(text, kColumns[1], line.runs ? "yes" : "no");
    cell(text, kColumns[2], line.pin == Pin::Auto ? std::string_view{"-"} : nameOf(line.pin));
    const bool measured = report.ticks > 0 && line.runs;
    const bool own = measured && !line.zones.own.empty();
    cell(text, kColumns[3],
         own                            ? number(line.microseconds, 2)
         : measured && isOfPhysics(row) ? "shared"
                                        : "-");
    cell(text, kColumns[4],
         own && report.microseconds > 0.0 ? number(100.0 * line.microseconds / report.microseconds, 1) + " %"
                                          : "-");
    const bool saves = measured && (own || isOfPhysics(row));
    cell(text, kColumns[5], saves ? number(std::max(line.saves, 0.0), 1) : "-");
    text += "  " + requestersText(row, line);
    if (!line.pinnedBy.empty()) text += format("; pinned by {}", line.pinnedBy);
    return text;
}

}  // namespace

double zoneOverhead() {
    constexpr int kScopes = 200;
    double best = 1.0;
    for (int round = 0; round < kRounds; ++round) {
        Profile profile;
        for (int i = 0; i < kScopes; ++i) const ProfileScope scope{&profile, "nothing"};
        best = std::min(best, profile.zones().front().seconds / kScopes);
    }
    return best;
}

std::string missingRequesters(const EffectRow& row) {
    constexpr std::size_t kMost = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(row.requesters.size(), kMost); ++i)
        text += format("{}{}", i == 0 ? "" : ", ", row.requesters[i].type().name);
    if (row.requesters.size() > kMost) text += format(" and {} more", row.requesters.size() - kMost);
    return text.empty() ? "game code" : text;
}

EffectZones zonesOf(const EffectTable& table, std::size_t row) {
    EffectZones zones;
    const EffectRow& effect = table.rows()[row];
    for (const EffectSystem& system : table.systems()) {
        if (system.effect == effect.name) zones.own.push_back(system.name);
    }
    if (!isOfPhysics(effect)) return zones;
    const std::uint32_t bit = physics::Manifest::bit(effect.physics);
    for (const physics::StageInfo& stage : physics::stages()) {
        if ((stage.effects & bit) == 0) continue;
        (stage.effects == bit ? zones.own : zones.shared).push_back(stage.name);
    }
    if (zones.own.empty() && zones.shared.empty()) zones.shared.push_back("solve");
    return zones;
}

std::vector<EffectCount> requestersOf(const World& world, const EffectRow& row) {
    std::vector<EffectCount> counts;
    for (const EffectRequester& requester : row.requesters) {
        if (const std::size_t count = requester.requesters(world); count > 0)
            counts.push_back({&requester.type(), count});
    }
    return counts;
}

EffectReport reportEffects(const World& world, const Effects& effects, const Profile* profile, int ticks) {
    EffectReport report{&effects.table(), profile == nullptr ? 0 : ticks, 0.0, {}};
    const double overhead = profile == nullptr ? 0.0 : zoneOverhead();
    for (std::size_t i = 0; i < effects.table().rows().size(); ++i) {
        EffectLine line;
        line.row = i;
        line.isRequired = effects.isRequired(world, i);
        line.runs = effects.runs(world, i);
        line.pin = effects.pinOf(i);
        line.pinnedBy = effects.pinnedBy(i);
        line.requesters = requestersOf(world, effects.table().rows()[i]);
        line.zones = zonesOf(effects.table(), i);
        for (const std::string_view zone : line.zones.own) {
            if (profile != nullptr) line.microseconds += microsecondsOf(*profile, zone, ticks, overhead);
        }
        report.lines.push_back(std::move(line));
    }
    return report;
}

EffectReport measureEffects(Game& game, Profile& profile, int ticks) {
    for (int i = 0; i < kWarmUpTicks; ++i) tickGame(game, InputFrame{});
    const Snapshot start = game.world.save();
    const double first = play(game, start, ticks);
    if (first * ticks > kLongRound * kMicro)
        ticks = std::max(kFewestTicks, static_cast<int>(kLongRound * kMicro / first));
    game.world.provide(profile);
    profile.reset();
    profile.on = true;
    play(game, start, ticks);
    profile.on = false;
    EffectReport report = reportEffects(game.world, game.effects, &profile, ticks);

    report.microseconds = std::numeric_limits<double>::infinity();
    for (EffectLine& line : report.lines) {
        if (!line.runs || (line.zones.own.empty() && line.zones.shared.empty())) continue;
        double with = std::numeric_limits<double>::infinity(), without = with;
        for (int round = 0; round < kRounds;
             ++round) {  // alternately, so that other load on the machine affects both
            with = std::min(with, play(game, start, ticks));
            game.effects.setMeasuredPin(line.row, Pin::Off);
            without = std::min(without, play(game, start, ticks));
            game.effects.setMeasuredPin(line.row, Pin::Auto);
        }
        line.saves = with - without;
        report.microseconds = std::min(report.microseconds, with);
    }
    if (std::isinf(report.microseconds)) report.microseconds = first;  // no effect runs
    return report;
}

std::string effectText(const EffectReport& report) {
    std::string text = "  ";
    for (const Column& column : kColumns) cell(text, column, column.title);
    bool wasOfPhysics = false;
    for (const EffectLine& line : report.lines) {
        const bool ofPhysics = isOfPhysics(report.table->rows()[line.row]);
        if (line.row == 0 || ofPhysics != wasOfPhysics)
            text += ofPhysics ? "\nphysics\n" : "\nsystems and devices\n";
        if (line.row != 0 && ofPhysics == wasOfPhysics) text += '\n';
        wasOfPhysics = ofPhysics;
        text += lineText(report, line);
    }
    return text + '\n';
}

}  // namespace plumb
