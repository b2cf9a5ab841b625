#include "editor/model/debug/line_watch.hpp"

#include <utility>

#include "ecs/world.hpp"

namespace plumb::editor {

std::vector<std::byte> WatchedField::read(const World& world) const {
    const void* component = type == nullptr ? nullptr : world.find(*type, entity);
    if (component == nullptr) return {};
    const auto* from = static_cast<const std::byte*>(field->in(component));
    return {from, from + field->size};
}

void LineWatch::begin(World& world, std::int64_t tick, const LineGoal& goal, int quiet) {
    goal_ = goal;
    tick_ = tick;
    quiet_ = quiet;
    lines_ = handlers_ = 0;
    halt_.reset();
    change_.reset();
    value_ = goal.field.read(world);
    world_ = &world;
    if (world.service<ScriptObserver>() != this) world.provide(static_cast<ScriptObserver&>(*this));
    log_.emplace(quiet > 0);
}

void LineWatch::end() {
    if (!halt_) noteChange(0);
    world_ = nullptr;
    log_.reset();
}

void LineWatch::handlerBegins(EntityId entity, TypeKey script) {
    noteChange(0);
    ++handlers_;
    entity_ = entity;
    script_ = script;
}

bool LineWatch::onLine(lua_State* coroutine, const char* file, int line, int depth) {
    if (halt_) return false;
    noteChange(lines_);
    ++lines_;
    log_->set(lines_ < quiet_);
    problem_.clear();
    if (!isGoal(depth) && !isBreakpoint(coroutine, file, line)) return true;
    stop(coroutine, file, line, depth);
    log_->set(true);  // what else happens in this tick happens again
    return false;
}

bool LineWatch::isGoal(int depth) const {
    if (goal_.kind == LineGoal::Kind::Line) return lines_ == goal_.line;
    if (Moment{tick_, lines_} <= goal_.after) return false;
    const bool isOther = tick_ != goal_.after.tick || handlers_ != goal_.handler;
    switch (goal_.kind) {
        case LineGoal::Kind::Into: return true;
        case LineGoal::Kind::Over: return isOther || depth <= goal_.depth;
        case LineGoal::Kind::Out: return isOther || depth < goal_.depth;
        default: return false;
    }
}

bool LineWatch::isBreakpoint(lua_State* coroutine, const char* file, int line) {
    const bool counts = goal_.kind == LineGoal::Kind::Breakpoints || goal_.kind == LineGoal::Kind::Over ||
                        goal_.kind == LineGoal::Kind::Out;
    if (!counts || Moment{tick_, lines_} <= goal_.after) return false;
    const Breakpoint* breakpoint = breakpoints_.find(file, line);
    if (breakpoint == nullptr || !breakpoint->enabled) return false;
    if (breakpoint->condition.empty()) return true;
    script::Evaluation found = script::evaluate(coroutine, breakpoint->condition);
    problem_ = std::move(found.problem);
    return found.holds || !problem_.empty();
}

void LineWatch::stop(lua_State* coroutine, const char* file, int line, int depth) {
    halt_ = Halt{{tick_, lines_}, file, line, depth, handlers_, entity_, script_, script::framesOf(coroutine),
                 problem_};
    middle_ = Snapshot{};  // one of another world at the same address would keep its texts
    world_->save(middle_);
}

void LineWatch::noteChange(int madeBy) {
    if (goal_.field.type == nullptr) return;
    std::vector<std::byte> now = goal_.field.read(*world_);
    if (now == value_) return;
    value_ = std::move(now);
    change_ = Change{madeBy};
}

}  // namespace plumb::editor
