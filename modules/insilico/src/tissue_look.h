// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "tissue_noise.h"

namespace glisson::insilico {

/// Points of tissue to be looked at together.
struct TissuePoints {
  std::vector<float> x, y, z;    ///< rest position, mm
  std::vector<float> footprint;  ///< side of a pixel there, mm

  int size() const { return static_cast<int>(x.size()); }
  void clear() {
    x.clear();
    y.clear();
    z.clear();
    footprint.clear();
  }
  void add(const Eigen::Vector3f& rest_mm, float footprint_mm) {
    x.push_back(rest_mm.x());
    y.push_back(rest_mm.y());
    z.push_back(rest_mm.z());
    footprint.push_back(footprint_mm);
  }
};

/// How a point of tissue looks.
struct Look {
  Eigen::Array3f albedo = Eigen::Array3f::Zero();  ///< red, green, blue, linear light
  Eigen::Vector3f bump = Eigen::Vector3f::Zero();  ///< how the wet film on top leans, axes of the rest
  float gloss = 1.0F;
};

/// Colour as a function of the material point: evaluated at rest (CT) coordinates it sticks to the tissue
/// whatever the deformation. Octaves finer than the pixel's footprint fade out, so that nothing aliases.
class Tissue {
 public:
  explicit Tissue(std::uint64_t seed);
  /// Capsule of a liver: reddish brown, lobules of about a millimetre, patches, fine vessels.
  void liver(const TissuePoints& points, std::vector<Look>& looks) const;
  /// What lies behind: fat lobules with dark red between them.
  void wall(const TissuePoints& points, std::vector<Look>& looks) const;
  /// A tool: smooth, grey, shining.
  static void steel(const TissuePoints& points, std::vector<Look>& looks);

 private:
  static constexpr std::size_t kOctaves = 10;
  using Values = std::vector<float>;
  /// Noise of one size, each octave turned its own way so that no lattice shows.
  /// @param bend if given, three arrays in mm added to the points.
  Values octave(std::size_t number, const TissuePoints& points, float size_mm,
                const std::array<const Values*, 3>& bend = {}, float bend_mm = 0.0F) const;

  std::array<Lattice, kOctaves> lattice_;
};

}  // namespace glisson::insilico
