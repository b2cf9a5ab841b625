#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "editor/model/cost/advice.hpp"
#include "editor/model/cost/cost_words.hpp"

namespace plumb::editor {
namespace {

constexpr float kTick = 1.0f / 60.0f;  // s
constexpr float kHalf = 0.5f;          // an error below this part of the present one is worth a change
constexpr float kSaves = 0.8f;         // a cost below this part of the present one is worth a change
constexpr float kMinSaved = 5.0f;      // µs; smaller savings are noise
constexpr float kSlowMove = 0.25f;     // movement per tick / body radius below which no CCD is needed
constexpr float kFastMove = 2.0f;      // movement per tick / body radius above which walls can be passed
constexpr int kRestTicks = 30;         // ticks at rest after which a body could sleep
constexpr float kManyStays = 100.0f;   // events per tick
constexpr float kDearer = 1.1f;        // a ratio of costs or errors above this is more than noise

const WhatIfPoint* plainAt(const WhatIfResult& result, int quality) {
    return result.find(WhatIfKind::Quality, quality);
}

std::string count(std::size_t number, const char* one, const char* many) {
    return format("{} {}", number, number == 1 ? one : many);
}

std::string speedWords(float speed, PixelScale scale) {
    return format("{} m/s ({} px/s)", fixedText(static_cast<double>(speed), 1),
                  fixedText(static_cast<double>(pixelsOf(speed, scale)), 0));
}

template <class Wanted>
std::vector<ObjectId> objectsThat(const PhysicsTape& tape, Wanted&& wanted, float* topSpeed = nullptr) {
    std::vector<ObjectId> objects;
    for (const WatchedBody& body : tape.watched) {
        if (!body.object || !wanted(body)) continue;
        objects.push_back(body.object);
        if (topSpeed != nullptr) *topSpeed = std::max(*topSpeed, body.topSpeed);
    }
    return objects;
}

CostRemedy sceneRemedy(std::string label, std::string field, FieldValue value) {
    return {std::move(label), "ScenePhysics", std::move(field), std::move(value), {}};
}

/// Describes the larger error: "Bodies overlap by up to …" or "Joints open by up to …".
std::string errorWords(const WhatIfPoint& point, PixelScale scale) {
    return format("{} by up to {}", point.jointError > point.overlap ? "Joints open" : "Bodies overlap",
                  lengthWords(point.error(), scale));
}

std::optional<Advice> judgeTooCoarse(const CostFacts& facts) {
    const WhatIfResult& result = facts.result;
    const WhatIfPoint* now = result.present();
    const WhatIfPoint* enough = enoughQuality(result);
    if (now == nullptr || enough == nullptr || enough->quality <= now->quality) return {};
    if (pixelsOf(now->error(), result.scale) < kSeenPixels || enough->error() > kHalf * now->error())
        return {};
    return Advice{
        {},
        format("{} at quality {}, which may be visible. Quality {} costs {} more per tick, error {}.",
               errorWords(*now, result.scale), now->quality, enough->quality,
               costWords(enough->microseconds - now->microseconds),
               lengthWords(enough->error(), result.scale)),
        qualityRemedy(enough->quality),
        {}};
}

std::optional<Advice> judgeTooFine(const CostFacts& facts) {
    const WhatIfResult& result = facts.result;
    const WhatIfPoint* now = result.present();
    if (now == nullptr) return {};
    // The limit is half of the visible error, as a reserve for more difficult moments of the game.
    const WhatIfPoint* enough = nullptr;
    for (int quality = now->quality - 1; quality >= 0; --quality) {
        const WhatIfPoint* point = plainAt(result, quality);
        if (point == nullptr || pixelsOf(point->error(), result.scale) > kHalf * kSeenPixels) break;
        enough = point;
    }
    if (enough == nullptr) return {};
    if (enough->microseconds > kSaves * now->microseconds ||
        now->microseconds - enough->microseconds < kMinSaved)
        return {};
    return Advice{
        {},
        format("Quality {} is more than this scene needs: quality {} has an error of {}, which is not "
               "visible, and saves {} per tick.",
               now->quality, enough->quality, lengthWords(enough->error(), result.scale),
               costWords(now->microseconds - enough->microseconds)),
        qualityRemedy(enough->quality),
        {}};
}

std::optional<Advice> judgeAutomatic(const CostFacts& facts) {
    const WhatIfResult& result = facts.result;
    const WhatIfPoint* now = result.present();
    const WhatIfPoint* hard = result.find(WhatIfKind::Automatic);
    if (result.settings.automaticQuality || now == nullptr || hard == nullptr) return {};
    if (pixelsOf(now->error(), result.scale) < kSeenPixels || hard->error() > kHalf * now->error()) return {};
    for (int quality = now->quality; quality <= physics::kMaxQuality; ++quality) {
        const WhatIfPoint* point = plainAt(result, quality);
        if (point == nullptr || point->error() > kDearer * hard->error()) continue;
        if (point->microseconds < hard->microseconds) return {};  // a fixed quality costs less
        break;
    }
    return Advice{
        {},
        format("Automatic quality is enough: only hard islands get more substeps. Its error is {}; it costs "
               "{} more per tick.",
               lengthWords(hard->error(), result.scale),
               costWords(std::max(hard->microseconds - now->microseconds, 0.0f))),
        sceneRemedy("Use automatic quality", "automaticQuality", FieldValue::of(true)),
        {}};
}

std::optional<Advice> judgeBullets(const CostFacts& facts) {
    float top = 0.0f;
    const auto isSlow = [](const WatchedBody& body) {
        return body.isBullet && body.topSpeed * kTick < kSlowMove * body.reach;
    };
    std::vector<ObjectId> slow = objectsThat(facts.tape, isSlow, &top);
    if (slow.empty()) return {};
    Advice advice;
    advice.words = format("{} CCD against moving bodies (bullet) and never {} {}.",
                          count(slow.size(), "body uses", "bodies use"),
                          slow.size() == 1 ? "exceeds" : "exceed", speedWords(top, facts.result.scale));
    advice.remedy = {"Turn bullet off", "RigidBody", "bullet", FieldValue::of(false), slow};
    advice.about = std::move(slow);
    return advice;
}

std::optional<Advice> judgeFastWithout(const CostFacts& facts) {
    if (facts.result.settings.continuous) return {};
    float top = 0.0f;
    const auto isFast = [](const WatchedBody& body) {
        return body.topSpeed * kTick > kFastMove * body.reach;
    };
    std::vector<ObjectId> fast = objectsThat(facts.tape, isFast, &top);
    if (fast.empty()) return {};
    Advice advice;
    advice.words = format(
        "{} farther per tick than their own size, at up to {}, and CCD (continuous) is off: "
        "they may pass through walls.",
        count(fast.size(), "body moves", "bodies move"), speedWords(top, facts.result.scale));
    advice.remedy = sceneRemedy("Turn CCD on", "continuous", FieldValue::of(true));
    advice.about = std::move(fast);
    return advice;
}

std::optional<Advice> judgeSleep(const CostFacts& facts) {
    if (facts.result.settings.sleeping) return {};
    std::vector<ObjectId> resting =
        objectsThat(facts.tape, [](const WatchedBody& body) { return body.restTicks >= kRestTicks; });
    if (resting.empty()) return {};
    Advice advice;
    advice.words = format("{} could sleep, but sleeping is off: bodies at rest cost as much as moving ones.",
                          count(resting.size(), "body", "bodies"));
    advice.remedy = sceneRemedy("Turn sleeping on", "sleeping", FieldValue::of(true));
    advice.about = std::move(resting);
    return advice;
}

/// Returns the ratio of the present cost to that with the Verlet integrator.
float timesVerlet(const WhatIfPoint& now, const WhatIfPoint& verlet) {
    return now.microseconds / std::max(verlet.microseconds, 0.01f);
}

std::optional<Advice> judgeRk4(const CostFacts& facts) {
    const WhatIfResult& result = facts.result;
    const WhatIfPoint* now = result.present();
    const WhatIfPoint* verlet = result.find(WhatIfKind::Verlet);
    if (result.settings.integrator != physics::IntegratorKind::Rk4 || now == nullptr || verlet == nullptr)
        return {};
    if (now->away < 0.0f || timesVerlet(*now, *verlet) < kDearer) return {};
    if (pixelsOf(verlet->away, result.scale) > kHalf * kSeenPixels && verlet->away > kDearer * now->away)
        return {};
    return Advice{
        {},
        format("Runge-Kutta 4 costs {} times as much as Verlet and is no better here: with Verlet, bodies "
               "deviate by {} from the reference.",
               fixedText(static_cast<double>(timesVerlet(*now, *verlet)), 1),
               lengthWords(verlet->away, result.scale)),
        sceneRemedy("Use Verlet", "integrator", FieldValue::of(physics::IntegratorKind::Verlet)),
        {}};
}

std::optional<Advice> judgeExplicitEuler(const CostFacts& facts) {
    const WhatIfResult& result = facts.result;
    const WhatIfPoint* now = result.present();
    const WhatIfPoint* verlet = result.find(WhatIfKind::Verlet);
    if (result.settings.integrator != physics::IntegratorKind::ExplicitEuler || now == nullptr ||
        verlet == nullptr)
        return {};
    constexpr float kMuchWorse = 4.0f;
    // The reference uses the scene's integrator too; its steps are so short that all integrators agree.
    if (now->away < kMuchWorse * verlet->away || pixelsOf(now->away, result.scale) < kSeenPixels) return {};
    return Advice{
        {},
        format("Explicit Euler is for teaching only: it adds energy, and bodies deviate by {} from the "
               "reference; with Verlet by {}.",
               lengthWords(now->away, result.scale), lengthWords(verlet->away, result.scale)),
        sceneRemedy("Use Verlet", "integrator", FieldValue::of(physics::IntegratorKind::Verlet)),
        {}};
}

std::optional<Advice> judgeIterations(const CostFacts& facts) {
    const WhatIfResult& result = facts.result;
    const WhatIfPoint* now = result.present();
    const WhatIfPoint* one = result.find(WhatIfKind::OneIteration);
    if (now == nullptr || one == nullptr || one->microseconds > kSaves * now->microseconds) return {};
    if (one->error() > kDearer * now->error() && pixelsOf(one->error(), result.scale) > kHalf * kSeenPixels)
        return {};
    return Advice{
        {},
        format("{} iterations per substep are no better than one here (error {} and {}), and cost {} more.",
               static_cast<int>(result.settings.iterations), lengthWords(now->error(), result.scale),
               lengthWords(one->error(), result.scale), costWords(now->microseconds - one->microseconds)),
        sceneRemedy("Use one iteration", "iterations", FieldValue::of(1)),
        {}};
}

std::optional<Advice> judgeStays(const CostFacts& facts) {
    const auto ticks = static_cast<float>(std::max<std::size_t>(facts.tape.ticks.size(), 1));
    const float stays = static_cast<float>(facts.tape.stays) / ticks;
    if (stays < kManyStays) return {};
    Advice advice;
    advice.words = format(
        "{} Stayed contact events are created per tick, and no component uses them. If your code does "
        "not use them either, set PhysicsSettings::stayEvents to false.",
        static_cast<int>(stays));
    return advice;
}

constexpr std::array kRules{
    AdviceRule{"too coarse", judgeTooCoarse},
    AdviceRule{"automatic quality", judgeAutomatic},
    AdviceRule{"too fine", judgeTooFine},
    AdviceRule{"explicit Euler", judgeExplicitEuler},
    AdviceRule{"fast without CCD", judgeFastWithout},
    AdviceRule{"Runge-Kutta", judgeRk4},
    AdviceRule{"iterations", judgeIterations},
    AdviceRule{"bullets", judgeBullets},
    AdviceRule{"sleep", judgeSleep},
    AdviceRule{"stay events", judgeStays},
};

}  // namespace

std::span<const AdviceRule> adviceRules() { return kRules; }

std::vector<Advice> adviceFor(const CostFacts& facts) {
    std::vector<Advice> all;
    for (const AdviceRule& rule : adviceRules()) {
        std::optional<Advice> advice = rule.judge(facts);
        if (!advice) continue;
        advice->rule = rule.name;
        all.push_back(std::move(*advice));
    }
    return all;
}

}  // namespace plumb::editor
