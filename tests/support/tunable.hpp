#pragma once

// Included first in every file of a build with PLUMB_TUNABLE, in which the constants of physics/tuning.hpp
// are variables that register themselves in a list. In other builds the list is empty.

namespace plumb::tuning {

/// A registered constant; values of all types are stored as double.
struct Constant {
    const char* name = nullptr;
    const char* unit = nullptr;
    const char* derivation = nullptr;
    int line = 0;        ///< line in physics/tuning.hpp
    double value = 0.0;  ///< value in physics/tuning.hpp
    void* place = nullptr;
    void (*assign)(void* at, double to) = nullptr;
    const Constant* next = nullptr;

    void set(double to) const { assign(place, to); }
};

/// Head of the linked list of registered constants, in no particular order.
inline const Constant* constants = nullptr;

template <class T>
struct Listed : Constant {
    Listed(T& variable, const Constant& row) : Constant{row} {
        value = static_cast<double>(variable);
        place = &variable;
        assign = [](void* at, double to) { *static_cast<T*>(at) = static_cast<T>(to); };
        next = constants;
        constants = this;
    }
};

}  // namespace plumb::tuning

#ifdef PLUMB_TUNABLE
#define PLUMB_TUNING(name, value, unit, derivation)     \
    inline auto name = value;                           \
    inline const ::plumb::tuning::Listed name##Listed { \
        name, { #name, unit, derivation, __LINE__ }     \
    }
#endif
