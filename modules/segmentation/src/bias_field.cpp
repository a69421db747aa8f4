// SPDX-License-Identifier: GPL-3.0-or-later
#include "bias_field.h"

#include <itkCommand.h>
#include <itkImage.h>
#include <itkMultiThreaderBase.h>
#include <itkN4BiasFieldCorrectionImageFilter.h>

#include <algorithm>

namespace glisson::segmentation {
namespace {

/// Meshes of four, five and seven control points an axis: on a trunk the finest are a decimetre apart, less
/// than coils vary over and more than an organ's edge.
constexpr unsigned kLevels = 3, kRounds = 30;

using Picture = itk::Image<float, 3>;
using Region = itk::Image<std::uint8_t, 3>;
using N4 = itk::N4BiasFieldCorrectionImageFilter<Picture, Region, Picture>;

template <class Volume, class Values>
typename Volume::Pointer itk_of(const Field& grid, const Values& values) {
  auto volume = Volume::New();
  typename Volume::SizeType size;
  typename Volume::SpacingType spacing;
  for (unsigned axis = 0; axis < 3; ++axis) {
    size[axis] = static_cast<itk::SizeValueType>(grid.size[axis]);
    spacing[axis] = grid.spacing_mm[axis];
  }
  volume->SetRegions(size);
  volume->SetSpacing(spacing);
  volume->Allocate();
  std::copy(values.begin(), values.end(), volume->GetBufferPointer());
  return volume;
}

/// Thrown through the filter; never leaves bias_field().
struct Stopped {};

/// One thread for all of ITK's filters while it lives: sums are made a thread, so that with one every machine
/// gives the same bits. N4 hands no count of its own to the filters inside it.
class OneThread {
 public:
  OneThread() { itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(1); }
  ~OneThread() { itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(before_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  itk::ThreadIdType before_ = itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads();
};

/// Tells each round, and ends them on request.
class Watch : public itk::Command {
 public:
  using Pointer = itk::SmartPointer<Watch>;
  static Pointer of(const RunContext& context) {
    Pointer watch = new Watch(context);
    watch->UnRegister();
    return watch;
  }
  void Execute(itk::Object* caller, const itk::EventObject& event) override {
    Execute(static_cast<const itk::Object*>(caller), event);
  }
  void Execute(const itk::Object*, const itk::EventObject&) override {
    if (context_.cancelled()) throw Stopped();
    context_.progress(std::min(1.0, ++rounds_ / (kLevels * kRounds)), "segmentation.bias");
  }

 private:
  explicit Watch(const RunContext& context) : context_(context) {}
  const RunContext& context_;
  double rounds_ = 0.0;
};

}  // namespace

Cancellable<Field> bias_field(const Field& coarse, const Mask& tissue, const RunContext& context) {
  Field field = coarse.filled(1.0F);
  float least = 0.0F, most = 0.0F;
  for (std::size_t i = 0; i < tissue.voxels.size(); ++i) {
    if (tissue.voxels[i] == 0) continue;
    const float value = coarse.values[i];
    least = most == 0.0F ? value : std::min(least, value);
    most = std::max(most, value);
  }
  if (!(most > least)) return field;
  const OneThread one_thread;
  const auto n4 = N4::New();
  n4->SetInput(itk_of<Picture>(coarse, coarse.values));
  n4->SetMaskImage(itk_of<Region>(coarse, tissue.voxels));
  N4::ArrayType levels;
  levels.Fill(kLevels);
  n4->SetNumberOfFittingLevels(levels);
  N4::VariableSizeArrayType rounds(kLevels);
  rounds.Fill(kRounds);
  n4->SetMaximumNumberOfIterations(rounds);
  n4->AddObserver(itk::IterationEvent(), Watch::of(context));
  try {
    n4->Update();
  } catch (const Stopped&) {
    return std::nullopt;
  }
  const float* corrected = n4->GetOutput()->GetBufferPointer();
  for (std::size_t i = 0; i < field.values.size(); ++i) field.values[i] = coarse.values[i] / corrected[i];
  return field;
}

}  // namespace glisson::segmentation
