// SPDX-License-Identifier: GPL-3.0-or-later
// Every saved part compares itself: what reads back differently is never taken for saved.
#include <QTest>

#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/engine/parts/source.h"
#include "glisson/engine/parts/video.h"

using namespace glisson;
using namespace glisson::engine;

namespace {

Picture picture(int channels, std::uint8_t first) {
  const auto bytes =
      std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(48 * 32 * channels));
  for (std::size_t i = 0; i < bytes->size(); ++i) (*bytes)[i] = static_cast<std::uint8_t>(first + 7 * i);
  return {48, 32, channels, bytes};
}

StereoRig rig() {
  StereoRig rig;
  rig.left.width = rig.right.width = 48;
  rig.left.height = rig.right.height = 32;
  rig.left.matrix << 50.123456789, 0, 24.1, 0, 51.7, 15.9, 0, 0, 1;
  rig.right.matrix << 50.3, 0, 23.7, 0, 51.2, 16.4, 0, 0, 1;
  rig.left.distortion << -0.21, 0.13, 1e-4, -2e-4, 0.01;
  rig.right_from_left.translation = {-4.6e-3, 1e-5, 3e-5};
  return rig;
}

stereo::Regions regions() {
  stereo::Regions regions;
  regions.frame = 7;
  stereo::Region polygon;
  polygon.polygon = {{1.5, 2.25}, {30.1, 3.0}, {20.0, 25.7}};
  stereo::Region curve = polygon;
  curve.closed = false;
  curve.feature = Feature::anterior_margin;
  curve.half_width_px = 4.5;
  regions.regions = {polygon, curve};
  return regions;
}

segmentation::Seeds seeds() {
  segmentation::Seeds seeds;
  seeds.liver = Points::Constant(2, 3, 0.0123456);
  seeds.lesions = {Points::Constant(1, 3, 0.05), Points()};
  seeds.lesion_diameters_mm = {12.5, 0.0};
  return seeds;
}

StereoInput frame() {
  StereoInput input;
  input.frame = {picture(3, 1), picture(3, 9), 7, 7.0 / 30.0};
  input.mask = picture(1, 0);
  return input;
}

VideoSource video(std::filesystem::path left, std::filesystem::path right = {}) {
  return {std::move(left), std::move(right)};
}

DicomSource source() {
  return {"Doe Jane", "4711", "1960-01-31", "1.2", "1.2.3", "1.2.4", "1.2.5", {"1.2.6", "1.2.7"}};
}

template <class T>
void put(CaseState& state, const PartOf<T>& part, T value) {
  state[part] = std::make_shared<const T>(std::move(value));
}

CaseState stereo_case(const std::filesystem::path& film) {
  CaseState state;
  put(state, part::rig, rig());
  put(state, part::regions, regions());
  put(state, part::seeds, seeds());
  put(state, part::frame, frame());
  put(state, part::video, video(film));
  put(state, part::source, source());
  std::uint64_t revision = 0;
  for (const Part part : all_parts())
    if (state.has(part)) state.stamp(part).revision = ++revision;
  return state;
}

}  // namespace

class PartSameTest : public QObject {
  Q_OBJECT
 private slots:
  void EverySavedPartComparesItself();
  void WhatIsReadBackIsTheSame();
  void WhatDiffersIsSeen();
};

void PartSameTest::EverySavedPartComparesItself() {
  int saved = 0;
  for (const Part part : all_parts()) {
    if (!part.type().is_saved()) continue;
    ++saved;
    QVERIFY2(part.type().spec().same, part.code().data());
  }
  QVERIFY(saved >= 12);
}

void PartSameTest::WhatIsReadBackIsTheSame() {
  const TemporaryFolder folder;
  // Beside the case, which says so relative to where it will stand, and far from it.
  for (const std::filesystem::path& film :
       {folder.path() / "film.mkv", std::filesystem::path("/far/film.mkv")}) {
    const CaseState state = stereo_case(film);
    QVERIFY(save_case(folder.path() / "a.glisson", state, RunContext()));
    const auto read = open_case(folder.path() / "a.glisson", RunContext());
    for (const Part part : all_parts())
      if (state.has(part)) QVERIFY2(part.type().spec().same(state, *read), part.code().data());
    QVERIFY((*read)[part::video]->left == film);
  }
}

void PartSameTest::WhatDiffersIsSeen() {
  const CaseState good = stereo_case("/far/film.mkv");
  const auto differs = [&](Part part, const std::function<void(CaseState&)>& change) {
    CaseState other = good;
    change(other);
    return part.type().spec().same(good, good) && !part.type().spec().same(good, other);
  };
  QVERIFY(differs(part::source, [](CaseState& state) {
    DicomSource other = source();
    other.patient_id = "4712";
    put(state, part::source, other);
  }));
  const auto rig_differs = [&](const std::function<void(StereoRig&)>& change) {
    return differs(part::rig, [&](CaseState& state) {
      StereoRig changed = rig();
      change(changed);
      put(state, part::rig, changed);
    });
  };
  QVERIFY(rig_differs([](StereoRig& r) { r.left.matrix(0, 0) += 0.01; }));
  QVERIFY(rig_differs([](StereoRig& r) { r.left.distortion[2] = 0.0; }));
  QVERIFY(rig_differs([](StereoRig& r) { r.right_from_left.translation.x() *= 1.001; }));
  QVERIFY(rig_differs([](StereoRig& r) { r.right.height = 31; }));
  const auto regions_differ = [&](const std::function<void(stereo::Regions&)>& change) {
    return differs(part::regions, [&](CaseState& state) {
      stereo::Regions changed = regions();
      change(changed);
      put(state, part::regions, changed);
    });
  };
  QVERIFY(regions_differ([](stereo::Regions& r) { r.regions.pop_back(); }));
  QVERIFY(regions_differ([](stereo::Regions& r) { r.regions[0].polygon[1].x() += 0.01; }));
  QVERIFY(regions_differ([](stereo::Regions& r) { r.regions[1].half_width_px = 5.0; }));
  QVERIFY(regions_differ([](stereo::Regions& r) { r.frame = 8; }));
  QVERIFY(regions_differ([](stereo::Regions& r) { r.identity.push_back('x'); }));
  const auto seeds_differ = [&](const std::function<void(segmentation::Seeds&)>& change) {
    return differs(part::seeds, [&](CaseState& state) {
      segmentation::Seeds changed = seeds();
      change(changed);
      put(state, part::seeds, changed);
    });
  };
  QVERIFY(seeds_differ([](segmentation::Seeds& s) { s.liver(1, 2) += 1e-4; }));
  QVERIFY(seeds_differ([](segmentation::Seeds& s) { s.background = s.liver; }));
  QVERIFY(seeds_differ([](segmentation::Seeds& s) { s.lesions.pop_back(); }));
  QVERIFY(seeds_differ([](segmentation::Seeds& s) { s.lesion_diameters_mm = {12.0, 0.0}; }));
  const auto frame_differs = [&](const std::function<void(StereoInput&)>& change) {
    return differs(part::frame, [&](CaseState& state) {
      StereoInput changed = frame();
      change(changed);
      put(state, part::frame, changed);
    });
  };
  QVERIFY(frame_differs([](StereoInput& f) { f.frame.left = picture(3, 2); }));
  QVERIFY(frame_differs([](StereoInput& f) { f.mask = {}; }));
  QVERIFY(frame_differs([](StereoInput& f) { f.frame.index = 8; }));
  QVERIFY(differs(part::video, [](CaseState& s) { put(s, part::video, video("/far/other.mkv")); }));
  QVERIFY(differs(part::video, [](CaseState& s) { put(s, part::video, video("/far/film.mkv", "/r.mkv")); }));
}

QTEST_GUILESS_MAIN(PartSameTest)
#include "part_same_test.moc"
