// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/mr_patient.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "glisson/core/error.h"
#include "mr_signal.h"
#include "tissue.h"

namespace glisson::insilico {
namespace {

constexpr double kLiverShown = 300.0;  // scanner units

/// Slices so thin that a whole number of them makes one of the MRI.
constexpr int kThin = 2;

/// What the coils receive from a place: three long waves, within 1 -+ `variation`.
class CoilField {
 public:
  CoilField(double variation, std::uint64_t seed) : variation_(variation) {
    Dice dice(RunContext({}, nullptr, seed).random("insilico.coils"));
    for (Wave& wave : waves_) {
      const double z = dice.between(-1, 1), y = dice.between(-1, 1), x = dice.between(-1, 1);
      const Vec way(x, y, z);
      constexpr double kShortest = 320.0, kLongest = 640.0;  // mm
      wave.way = 2.0 * std::numbers::pi / dice.between(kShortest, kLongest) * way.normalized();
      wave.phase = dice.between(0.0, 2.0 * std::numbers::pi);
    }
  }
  double operator()(const Vec& p) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += std::sin(wave.way.dot(p) + wave.phase);
    return 1.0 + variation_ * sum / static_cast<double>(waves_.size());
  }

 private:
  struct Wave {
    Vec way;
    double phase = 0.0;
  };
  double variation_;
  std::array<Wave, 3> waves_;
};

/// A standard normal number for each voxel and channel (Box and Muller).
double noise(std::uint64_t seed, std::uint64_t voxel, std::uint64_t channel) {
  const std::uint64_t h = hash_of(seed * 0x9e3779b97f4a7c15ULL + 2 * voxel + channel);
  const double a = (static_cast<double>(h >> 32) + 0.5) * 0x1.0p-32,
               b = static_cast<double>(h & 0xffffffffU) * 0x1.0p-32;
  return std::sqrt(-2.0 * std::log(a)) * std::cos(2.0 * std::numbers::pi * b);
}

/// Each slice is the mean of its thin ones.
VolumeGrid thickened(const VolumeGrid& thin, const std::vector<std::int16_t>& signals,
                     std::vector<float>& thick) {
  VolumeGrid grid = thin;
  grid.size.z() /= kThin;
  grid.spacing_mm.z() *= kThin;
  grid.origin_mm.z() += 0.5 * (kThin - 1) * thin.spacing_mm.z();
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        float sum = 0.0F;
        for (int n = 0; n < kThin; ++n)
          sum += signals[static_cast<std::size_t>(thin.offset({i, j, kThin * k + n}))];
        thick.push_back(sum / kThin);
      }
  return grid;
}

std::vector<std::int16_t> received(const VolumeGrid& grid, const std::vector<float>& signals,
                                   const MrOptions& options) {
  const CoilField coils(options.coil_variation, options.shape_seed);
  const double sigma = kLiverShown / options.liver_snr;
  std::vector<std::int16_t> voxels;
  voxels.reserve(signals.size());
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const std::size_t at = voxels.size();
        const Vec p = grid.origin_mm + Vec(i, j, k).cwiseProduct(grid.spacing_mm);
        const double real = coils(p) * signals[at] + sigma * noise(options.shape_seed, at, 0),
                     imaginary = sigma * noise(options.shape_seed, at, 1);
        voxels.push_back(static_cast<std::int16_t>(std::lround(std::hypot(real, imaginary))));
      }
  return voxels;
}

}  // namespace

void MrOptions::validate() const {
  const OptionCheck demand("MrOptions");
  for (int a = 0; a < 3; ++a)
    demand(spacing_mm[a] >= 0.8 && spacing_mm[a] <= 12.0, "spacing_mm", spacing_mm[a], "Choose 0.8 to 12 mm");
  demand(coil_variation >= 0.0 && coil_variation <= 0.9, "coil_variation", coil_variation, "Choose 0 to 0.9");
  demand(liver_snr >= 1.0 && liver_snr <= 1000.0, "liver_snr", liver_snr, "Choose 1 to 1000");
}

Cancellable<MrPatient> make_mr_patient(const MrOptions& options, const RunContext& context) {
  options.validate();
  context.progress(0.0, "patient.shape");
  const auto anatomy = draw_anatomy(options.shape_seed, context.part(0.05, 0.2));
  if (!anatomy) return {};
  const SignalOf signals = signals_of(options.sequence);
  const double unit = kLiverShown / signals(tissue::kLiver, false);
  const Vec thin(options.spacing_mm.x(), options.spacing_mm.y(), options.spacing_mm.z() / kThin);
  Canvas canvas(ct_grid(thin), tissue::kAir,
                [&](double hounsfield, bool bone) { return unit * signals(hounsfield, bone); });
  std::vector<Label> of_thin;  // none of their slices lies in the middle of one of the MRI's
  if (!paint_trunk(canvas, anatomy->shape, context.part(0.2, 0.5))) return {};
  if (!paint_organs(canvas, anatomy->shape, context.part(0.5, 0.7))) return {};
  if (!paint_liver(canvas, *anatomy, of_thin, context.part(0.7, 0.85))) return {};
  context.progress(0.85, "patient.scan");
  // A Fourier image's point spread is about a voxel wide (1.2 between the halves of its height).
  const std::vector<std::int16_t> sharp = scan(canvas, 0.5 * options.spacing_mm.x(), 0.0, options.shape_seed);
  std::vector<float> thick;
  MrPatient patient;
  patient.mr.grid = thickened(canvas.grid(), sharp, thick);
  patient.mr.modality = Modality::mr;
  patient.mr.description = "Synthetic patient " + std::to_string(options.shape_seed) + ", MRI";
  patient.mr.voxels =
      std::make_shared<const std::vector<std::int16_t>>(received(patient.mr.grid, thick, options));
  // The truth at the middles of its voxels, as a CT's.
  Canvas plain(patient.mr.grid, tissue::kAir);
  std::vector<Label> labels;
  if (!paint_liver(plain, *anatomy, labels, context.part(0.9, 1.0))) return {};
  patient.truth = {LabelVolume(patient.mr.grid, labels), label_infos(anatomy->lesions.size())};
  context.progress(1.0, "patient.scan");
  return patient;
}

}  // namespace glisson::insilico
