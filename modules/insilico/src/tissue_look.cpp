// SPDX-License-Identifier: GPL-3.0-or-later
#include "tissue_look.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "glisson/core/random.h"
#include "tissue_noise.h"

namespace glisson::insilico {
namespace {

float smooth_step(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

/// A line where the noise crosses zero, `width` noise units wide.
float line(float noise, float width) {
  const float r = noise * noise / (width * width);
  return 1.0F / (1.0F + r * r);
}

}  // namespace

Tissue::Tissue(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  // Not std's distributions: their results may differ between standard libraries.
  const auto uniform = [&] { return static_cast<float>(uniform01(random)); };
  for (std::size_t i = 0; i < kOctaves; ++i) {
    const float a = uniform() - 0.5F, b = uniform() - 0.5F, c = uniform() - 0.5F, d = uniform() + 0.1F;
    const Eigen::Matrix<float, 3, 3, Eigen::RowMajor> turn =
        Eigen::Quaternionf(d, a, b, c).normalized().toRotationMatrix();
    std::copy_n(turn.data(), 9, lattice_[i].turn);
    for (float& shift : lattice_[i].shift) shift = 200.0F * uniform();
    lattice_[i].seed = static_cast<std::uint32_t>(random());
  }
}

Tissue::Values Tissue::octave(std::size_t number, const TissuePoints& points, float size_mm,
                              const std::array<const Values*, 3>& bend, float bend_mm) const {
  const auto n = static_cast<std::size_t>(points.size());
  Values out(n);
  Lattice lattice = lattice_[number];
  for (float& t : lattice.turn) t /= size_mm;
  if (bend[0] == nullptr) {
    gradient_noise(points.size(), points.x.data(), points.y.data(), points.z.data(), lattice, out.data());
  } else {
    Values x = points.x, y = points.y, z = points.z;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += bend_mm * (*bend[0])[i];
      y[i] += bend_mm * (*bend[1])[i];
      z[i] += bend_mm * (*bend[2])[i];
    }
    gradient_noise(points.size(), x.data(), y.data(), z.data(), lattice, out.data());
  }
  for (std::size_t i = 0; i < n; ++i) out[i] *= smooth_step(1.5F, 3.0F, size_mm / points.footprint[i]);
  return out;
}

void Tissue::liver(const TissuePoints& points, std::vector<Look>& looks) const {
  const Values broad = octave(0, points, 28.0F), patch = octave(1, points, 8.0F);
  const Values mottle = octave(2, points, 3.2F), lobule = octave(3, points, 1.6F);
  const Values grain = octave(4, points, 0.8F);
  // Vessels of the capsule: zero lines of noise whose domain the mottle bends, dense in some patches only.
  const Values vessel = octave(5, points, 12.0F, {&mottle, &patch, &lobule}, 0.9F);
  const Values twig = octave(6, points, 5.0F, {&lobule, &mottle, &patch}, 0.7F);
  const Values lean_a = octave(7, points, 5.0F), lean_b = octave(8, points, 5.0F),
               lean_c = octave(9, points, 5.0F);
  looks.resize(broad.size());
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const float vessels = line(vessel[i], 0.045F) * smooth_step(-0.2F, 0.5F, broad[i] + 0.4F * patch[i]);
    const float twigs = line(twig[i], 0.05F) * smooth_step(-0.1F, 0.6F, patch[i] - 0.3F * broad[i]);
    const float spots = smooth_step(0.50F, 0.75F, mottle[i] + 0.4F * lobule[i]);
    const float pits = smooth_step(0.45F, 0.70F, -lobule[i] - 0.3F * mottle[i]);
    Look& look = looks[i];
    const float tone =
        1.0F + 0.14F * broad[i] + 0.20F * patch[i] + 0.36F * mottle[i] + 0.52F * lobule[i] + 0.40F * grain[i];
    look.albedo = Eigen::Array3f(0.300F, 0.066F, 0.042F) * std::max(0.2F, tone);
    look.albedo *= Eigen::Array3f(1.0F, 1.0F + 0.20F * patch[i] - 0.15F * broad[i], 1.0F + 0.15F * broad[i]);
    look.albedo *= 1.0F - Eigen::Array3f(0.30F, 0.50F, 0.40F) * std::max(vessels, 0.7F * twigs);
    look.albedo *= 1.0F - 0.25F * pits;
    look.albedo += spots * Eigen::Array3f(0.085F, 0.050F, 0.032F);
    look.bump = 0.060F * Eigen::Vector3f(lean_a[i], lean_b[i], lean_c[i]);
    look.gloss = std::max(0.1F, 0.7F + 0.4F * patch[i] + 0.5F * lobule[i]);
  }
}

void Tissue::wall(const TissuePoints& points, std::vector<Look>& looks) const {
  const Values broad = octave(0, points, 38.0F), lobes = octave(1, points, 13.0F);
  const Values small = octave(2, points, 5.5F), grain = octave(3, points, 2.2F);
  const Values vessel = octave(5, points, 26.0F, {&lobes, &small, &grain}, 2.5F);
  const Values lean_a = octave(7, points, 9.0F), lean_b = octave(8, points, 9.0F),
               lean_c = octave(9, points, 9.0F);
  const Eigen::Array3f yellow(0.36F, 0.16F, 0.055F), red(0.20F, 0.060F, 0.035F);
  looks.resize(broad.size());
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const float fat = smooth_step(-0.8F, 0.9F, broad[i] + 0.5F * lobes[i] + 0.2F * small[i]);
    const float tone = 1.0F + 0.22F * lobes[i] + 0.25F * small[i] + 0.20F * grain[i];
    Look& look = looks[i];
    look.albedo = (red + fat * (yellow - red)) * std::max(0.3F, tone);
    look.albedo *= 1.0F - 0.5F * line(vessel[i], 0.02F) * Eigen::Array3f(0.5F, 1.0F, 0.9F);
    look.bump = 0.10F * Eigen::Vector3f(lean_a[i], lean_b[i], lean_c[i]);
    look.gloss = 0.15F;
  }
}

void Tissue::steel(const TissuePoints& points, std::vector<Look>& looks) {
  looks.assign(static_cast<std::size_t>(points.size()), Look());
  for (Look& look : looks) look.albedo.setConstant(0.16F), look.gloss = 2.5F;
}

}  // namespace glisson::insilico
