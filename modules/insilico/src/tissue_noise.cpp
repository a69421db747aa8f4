// SPDX-License-Identifier: GPL-3.0-or-later
#include "tissue_noise.h"

namespace glisson::insilico {
namespace {

[[gnu::always_inline]] inline std::int32_t floor_of(float x) {
  const auto whole = static_cast<std::int32_t>(x);
  return whole - static_cast<std::int32_t>(static_cast<float>(whole) > x);
}

/// The gradient of a lattice point, ten bits a component, times the way from it.
[[gnu::always_inline]] inline float corner(std::uint32_t lattice, float x, float y, float z) {
  std::uint32_t h = lattice;
  h ^= h >> 15;
  h *= 0x2C1B3C6DU;
  h ^= h >> 12;
  h *= 0x297A2D39U;
  h ^= h >> 15;
  const auto component = [](std::uint32_t bits) {
    return static_cast<float>(static_cast<std::int32_t>(bits & 1023U) - 512);
  };
  return component(h) * x + component(h >> 10) * y + component(h >> 20) * z;
}

[[gnu::always_inline]] inline float fade(float t) { return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F); }

[[gnu::always_inline]] inline float mix(float a, float b, float t) { return a + t * (b - a); }

}  // namespace

#if defined(__GNUC__) && defined(__x86_64__)
[[gnu::target_clones("avx2", "default")]]
#endif
void gradient_noise(int n, const float* __restrict px, const float* __restrict py, const float* __restrict pz,
                    const Lattice& lattice, float* __restrict out) {
  constexpr float kScale = 1.7F / 512.0F;
  const Lattice a = lattice;  // a copy: nothing that out could overwrite
  for (int i = 0; i < n; ++i) {
    const float x = a.turn[0] * px[i] + a.turn[1] * py[i] + a.turn[2] * pz[i] + a.shift[0];
    const float y = a.turn[3] * px[i] + a.turn[4] * py[i] + a.turn[5] * pz[i] + a.shift[1];
    const float z = a.turn[6] * px[i] + a.turn[7] * py[i] + a.turn[8] * pz[i] + a.shift[2];
    const std::int32_t ix = floor_of(x), iy = floor_of(y), iz = floor_of(z);
    const float fx = x - static_cast<float>(ix), fy = y - static_cast<float>(iy),
                fz = z - static_cast<float>(iz);
    const std::uint32_t x0 = static_cast<std::uint32_t>(ix) * 0x8DA6B343U ^ a.seed,
                        x1 = (static_cast<std::uint32_t>(ix) + 1U) * 0x8DA6B343U ^ a.seed;
    const std::uint32_t y0 = static_cast<std::uint32_t>(iy) * 0xD8163841U,
                        y1 = (static_cast<std::uint32_t>(iy) + 1U) * 0xD8163841U;
    const std::uint32_t z0 = static_cast<std::uint32_t>(iz) * 0xCB1AB31FU,
                        z1 = (static_cast<std::uint32_t>(iz) + 1U) * 0xCB1AB31FU;
    const float gx = fx - 1.0F, gy = fy - 1.0F, gz = fz - 1.0F;
    const float u = fade(fx), v = fade(fy), w = fade(fz);
    const float bottom = mix(mix(corner(x0 ^ y0 ^ z0, fx, fy, fz), corner(x1 ^ y0 ^ z0, gx, fy, fz), u),
                             mix(corner(x0 ^ y1 ^ z0, fx, gy, fz), corner(x1 ^ y1 ^ z0, gx, gy, fz), u), v);
    const float top = mix(mix(corner(x0 ^ y0 ^ z1, fx, fy, gz), corner(x1 ^ y0 ^ z1, gx, fy, gz), u),
                          mix(corner(x0 ^ y1 ^ z1, fx, gy, gz), corner(x1 ^ y1 ^ z1, gx, gy, gz), u), v);
    out[i] = kScale * mix(bottom, top, w);
  }
}

}  // namespace glisson::insilico
