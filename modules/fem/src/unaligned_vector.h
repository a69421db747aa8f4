// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#define GLISSON_INLINE inline __attribute__((always_inline))

namespace glisson::fem {

/// `Bytes` / 8 numbers that are worked on at once, and how they lie in memory: like numbers, at any multiple
/// of 8 bytes. A type that is a vector of its own with this alignment would do for GCC; Clang forgets the
/// alignment of a name.
template <int Bytes>
struct Vector {
  typedef double type __attribute__((vector_size(Bytes), may_alias));
  struct __attribute__((packed, aligned(8), may_alias)) Unaligned {
    type v;
  };
};

template <int Bytes>
GLISSON_INLINE const typename Vector<Bytes>::Unaligned& at(const double* p) {
  return *reinterpret_cast<const typename Vector<Bytes>::Unaligned*>(p);
}
template <int Bytes>
GLISSON_INLINE typename Vector<Bytes>::Unaligned& at(double* p) {
  return *reinterpret_cast<typename Vector<Bytes>::Unaligned*>(p);
}

}  // namespace glisson::fem
