// SPDX-License-Identifier: Apache-2.0
// Put in front of every file of the checker when many mutants are compiled into one program: which mutant is in force, and operators that
// behave as written unless theirs is. `a < mutant::Less{7} < b` is `a < b`, or `a <= b` when mutant 7 is in force: the same precedence,
// the same conversions. A mutant that would not compile on its own ends the program with the code 99.
#pragma once

#include <gmpxx.h>

#include <type_traits>
#include <utility>

#include <unistd.h>

namespace mutant {

inline int active = -1;
[[gnu::always_inline]] inline int on(int number) { return active == number ? 1 : 0; }
[[noreturn]] inline void noSuchMutant() { ::_exit(99); }

template <int Kind> struct Place { int number; };
template <int Kind, class Left> struct Half {
    const Left& left;
    int number;
};

// Expressions of gmpxx refer to temporaries: they are evaluated at once.
template <class T> [[gnu::always_inline]] inline auto evaluated(T&& value) {
    if constexpr (std::is_convertible_v<T, mpz_class> && std::is_class_v<std::remove_cvref_t<T>>) return mpz_class(value);
    else if constexpr (std::is_convertible_v<T, mpq_class> && std::is_class_v<std::remove_cvref_t<T>>) return mpq_class(value);
    else return std::forward<T>(value);
}

#define MUTANT_OPERATOR(KIND, OPERATOR, OTHER)                                                                                     \
    template <class Left> Half<KIND, Left> operator OPERATOR(const Left& left, Place<KIND> place) { return {left, place.number}; } \
    template <class Left, class Right> auto operator OPERATOR(const Half<KIND, Left>& half, const Right& right) {                  \
        if (on(half.number)) {                                                                                                     \
            if constexpr (requires { evaluated(half.left OTHER right); }) return static_cast<decltype(evaluated(half.left OPERATOR right))>(evaluated(half.left OTHER right)); \
            else noSuchMutant();                                                                                                   \
        }                                                                                                                          \
        return evaluated(half.left OPERATOR right);                                                                                \
    }

MUTANT_OPERATOR(0, <, <=)
MUTANT_OPERATOR(1, <=, <)
MUTANT_OPERATOR(2, >, >=)
MUTANT_OPERATOR(3, >=, >)
MUTANT_OPERATOR(4, ==, !=)
MUTANT_OPERATOR(5, !=, ==)
MUTANT_OPERATOR(6, +, -)
MUTANT_OPERATOR(7, -, +)
#undef MUTANT_OPERATOR

}  // namespace mutant
