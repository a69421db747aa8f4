// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror_control.h"

#include <algorithm>

#include "examine.h"
#include "rigid.h"
#include "shape_fits.h"

namespace glisson::registration {
namespace {

Cancellable<double> mirrored_cost(const PatientModel& model, const LabelledCloud& cloud,
                                  const RegisterOptions& options, const ElasticOptions& elastic,
                                  const RunContext& context) {
  constexpr std::size_t kOthers = 1;
  constexpr int kIterations = 40;
  const LabelledCloud image = mirrored(cloud);
  auto start = align_rigid(model, image, options.rigid, context.part(0.0, 0.6));
  if (!start) return {};
  start->alternatives.resize(std::min(start->alternatives.size(), kOthers));
  ShapeFitOptions control = elastic.shape;
  control.max_iterations = std::min(control.max_iterations, kIterations);
  const auto shapes =
      fit_shapes(model, *elastic.prior, image, starts_of(start->camera_from_ct, start->alternatives), control,
                 context.part(0.6, 1.0));
  if (!shapes) return {};
  return shapes->best().cost;
}

}  // namespace

void MirrorControl::begin_beside(const PatientModel& model, const LabelledCloud& cloud,
                                 const RegisterOptions& options, const ElasticOptions& elastic,
                                 const RunContext& context) {
  RegisterOptions own = options;
  ElasticOptions own_elastic = elastic;
  own.rigid.threads = own_elastic.shape.threads = 1;
  cost_ = std::async(std::launch::async, [&model, cloud, own, own_elastic, context = context.quiet()] {
    return mirrored_cost(model, cloud, own, own_elastic, context);
  });
}

Cancellable<double> MirrorControl::cost(const PatientModel& model, const LabelledCloud& cloud,
                                        const RegisterOptions& options, const ElasticOptions& elastic,
                                        const RunContext& context) {
  return has_begun() ? cost_.get() : mirrored_cost(model, cloud, options, elastic, context);
}

}  // namespace glisson::registration
