#pragma once

// Included first in every file of a build with PLUMB_TUNABLE, in which the constants of physics/tuning.hpp
// are variables that register themselves in a list. In other builds the list is empty.

namespace plumb::tuning {

/// A registered constant; values of all types are stored as double.
struct Constant {
    const char* name = nullptr;                     ///< name in physics/tuning.hpp
    const char* unit = nullptr;                     ///< unit of the value
    const char* derivation = nullptr;               ///< origin of the value
    int line = 0;                                   ///< line in physics/tuning.hpp
    double value = 0.0;                             ///< value in physics/tuning.hpp
    void* place = nullptr;                          ///< address of the variable
    void (*assign)(void* at, double to) = nullptr;  ///< writes a value to `place`, in its type
    const Constant* next = nullptr;                 ///< next constant of the list

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
