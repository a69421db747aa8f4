// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs as others publish them, what is done to pictures before and after they are measured, and the proof of
// clouds on one scene of the theatre.
#include <QTest>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/stereo/picture_io.h"
#include "known_pair.h"
#include "real_pairs.h"
#include "stereo_proof.h"
#include "stereo_theatre.h"
#include "text_calibration.h"

using namespace glisson;
using namespace glisson::experiments;
namespace fs = std::filesystem;

namespace {

constexpr int kWidth = 64, kHeight = 48;

/// Grey `level`; with stripes, every other column is lighter by `contrast`, the rest darker.
Picture plain(int level, int channels = 1, int contrast = 0) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int c = 0; c < channels; ++c)
        bytes->push_back(static_cast<std::uint8_t>(level + (x % 2 == 0 ? contrast : -contrast)));
  return {kWidth, kHeight, channels, std::move(bytes)};
}

int byte_at(const Picture& picture, int x, int y, int channel = 0) {
  return (*picture.bytes)[static_cast<std::size_t>((y * picture.width + x) * picture.channels + channel)];
}

/// Mean and standard deviation of all bytes.
std::pair<double, double> spread_of(const Picture& picture) {
  double sum = 0.0, squares = 0.0;
  for (const std::uint8_t byte : *picture.bytes) sum += byte, squares += 1.0 * byte * byte;
  const auto n = static_cast<double>(picture.bytes->size());
  return {sum / n, std::sqrt(squares / n - sum / n * sum / n)};
}

/// Zero but for its left half.
Picture left_half() {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (int i = 0; i < kWidth * kHeight; ++i) bytes->push_back(i % kWidth < kWidth / 2 ? 255 : 0);
  return {kWidth, kHeight, 1, std::move(bytes)};
}

StereoRig small_rig() {
  StereoRig rig;
  for (Camera* camera : {&rig.left, &rig.right}) {
    camera->width = kWidth;
    camera->height = kHeight;
    camera->matrix << 60, 0, 32, 0, 60, 24, 0, 0, 1;
  }
  rig.right_from_left.translation = {-0.005, 0.0, 0.0};
  return rig;
}

/// What a depth map shows, of every fourth pixel.
TriangleMesh surface_of(const std::vector<float>& depth, const Camera& camera) {
  constexpr int kStep = 4;
  const int columns = camera.width / kStep, rows = camera.height / kStep;
  const auto depth_at = [&](int i, int j) {
    return depth[static_cast<std::size_t>(kStep * (j * camera.width + i))];
  };
  TriangleMesh mesh;
  mesh.vertices.resize(columns * rows, 3);
  std::vector<Eigen::RowVector3i> faces;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const Eigen::Vector3d pixel(kStep * i, kStep * j, 1.0);
      mesh.vertices.row(j * columns + i) = depth_at(i, j) * (camera.matrix.inverse() * pixel).transpose();
      if (i + 1 == columns || j + 1 == rows) continue;
      const int a = j * columns + i, b = a + 1, c = a + columns, d = c + 1;
      if (std::min({depth_at(i, j), depth_at(i + 1, j), depth_at(i, j + 1), depth_at(i + 1, j + 1)}) <= 0.0F)
        continue;
      faces.emplace_back(a, b, c);
      faces.emplace_back(b, d, c);
    }
  mesh.triangles.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) mesh.triangles.row(static_cast<Eigen::Index>(f)) = faces[f];
  return mesh;
}

}  // namespace

class PicturesOfOthersTest : public QObject {
  Q_OBJECT
 private slots:
  void TheSetsMaskLeavesOutWhatItMarks();
  void TheHeartsMaskSaysWhatIsHeart();
  void ASetThatLacksAFileIsRefused();
  void NoiseHasItsDeviation();
  void FineContrastFades();
  void HighlightsAreElsewhereForAnotherSeed();
  void DotsLieOverTheGreyPicture();
  void ASetIsMeasuredAgainstItsSurface();
  void WhatTheTheatreShowsIsMeasured();
};

void PicturesOfOthersTest::TheSetsMaskLeavesOutWhatItMarks() {
  const TemporaryFolder folder;
  const std::string start = "Stereo_SD_d_complete_22_";
  stereo::write_picture(folder.path() / (start + "IMG_left.bmp"), plain(90, 3));
  stereo::write_picture(folder.path() / (start + "IMG_right.bmp"), plain(110, 3));
  stereo::write_picture(folder.path() / (start + "MASK_left.png"), left_half());
  stereo::write_picture(folder.path() / (start + "MASK_eval.png"), plain(0));
  glisson::test::write_text_calibration(folder.path(), small_rig());
  const RealPair tissue = opencas(folder.path(), OpencasPart::tissue);
  QCOMPARE(byte_at(tissue.left, 5, 5), 90);
  QCOMPARE(byte_at(tissue.right, 5, 5), 110);
  QCOMPARE(tissue.mask.channels, 1);
  QCOMPARE(byte_at(tissue.mask, 5, 5), 0);  // marked
  QCOMPARE(byte_at(tissue.mask, kWidth - 5, 5), 255);
  QVERIFY(std::abs(tissue.rig.baseline() - 5e-3) < 1e-9);
  QCOMPARE(tissue.rig.left.width, kWidth);
  QCOMPARE(byte_at(opencas(folder.path(), OpencasPart::with_truth).mask, 5, 5), 255);
}

void PicturesOfOthersTest::TheHeartsMaskSaysWhatIsHeart() {
  const TemporaryFolder folder;
  stereo::write_picture(folder.path() / "f7_dynamic_deint_L_0100.png", plain(90, 3));
  stereo::write_picture(folder.path() / "f7_dynamic_deint_R_0100.png", plain(110, 3));
  stereo::write_picture(folder.path() / "f7_dynamic_deint_mask_0100.png", left_half());
  glisson::test::write_text_calibration(folder.path(), small_rig());
  const RealPair pair = heart(folder.path());
  QCOMPARE(byte_at(pair.mask, 5, 5), 255);
  QCOMPARE(byte_at(pair.mask, kWidth - 5, 5), 0);
  QCOMPARE(byte_at(pair.right, 5, 5), 110);
}

void PicturesOfOthersTest::ASetThatLacksAFileIsRefused() {
  const TemporaryFolder folder;
  glisson::test::write_text_calibration(folder.path(), small_rig());
  QVERIFY_THROWS_EXCEPTION(Error, heart(folder.path()));
  QVERIFY_THROWS_EXCEPTION(Error, opencas(folder.path(), OpencasPart::tissue));
}

void PicturesOfOthersTest::NoiseHasItsDeviation() {
  const Picture grey = plain(120);
  const Picture same = hardened(grey, {}, 1);
  QCOMPARE(*same.bytes, *grey.bytes);
  const Picture noisy = hardened(grey, {8.0, 1.0, 0}, 1);
  const auto [mean, deviation] = spread_of(noisy);
  QVERIFY(std::abs(mean - 120.0) < 0.6);
  QVERIFY2(std::abs(deviation - 8.0) < 0.4, qPrintable(QString::number(deviation)));
  QCOMPARE(*hardened(grey, {8.0, 1.0, 0}, 1).bytes, *noisy.bytes);
  QVERIFY(*hardened(grey, {8.0, 1.0, 0}, 2).bytes != *noisy.bytes);
}

/// Stripes of one pixel are finer than eight; the picture's level stays.
void PicturesOfOthersTest::FineContrastFades() {
  const auto [mean, deviation] = spread_of(hardened(plain(120, 3, 40), {0.0, 0.25, 0}, 1));
  QVERIFY(std::abs(mean - 120.0) < 1.0);
  QVERIFY2(std::abs(deviation - 10.0) < 1.5, qPrintable(QString::number(deviation)));
}

void PicturesOfOthersTest::HighlightsAreElsewhereForAnotherSeed() {
  const auto white = [](const Picture& picture) { return std::ranges::count(*picture.bytes, 252); };
  const Picture one = hardened(plain(120), {0.0, 1.0, 3}, 1), other = hardened(plain(120), {0.0, 1.0, 3}, 2);
  QVERIFY(white(one) > 20 && white(one) < kWidth * kHeight / 2);
  QVERIFY(*one.bytes != *other.bytes);
}

void PicturesOfOthersTest::DotsLieOverTheGreyPicture() {
  Picture coloured = plain(0, 3);
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(*coloured.bytes);
  for (std::size_t i = 1; i < bytes->size(); i += 3) (*bytes)[i] = 200;  // green
  coloured.bytes = bytes;
  for (const Picture& under : {coloured, plain(120)}) {
    const Picture drawn = with_dots(under, {{20.0, 10.0, 255, 0, 40}});
    QCOMPARE(drawn.channels, 3);
    QCOMPARE(byte_at(drawn, 20, 10, 0), 255);
    QCOMPARE(byte_at(drawn, 20, 10, 1), 0);
    QCOMPARE(byte_at(drawn, 20, 10, 2), 40);
    const int grey = byte_at(drawn, 50, 40, 0);
    QVERIFY(grey > 60 && grey == byte_at(drawn, 50, 40, 1) && grey == byte_at(drawn, 50, 40, 2));
  }
}

/// A pair whose depth is known, laid down as the two sets lie.
void PicturesOfOthersTest::ASetIsMeasuredAgainstItsSurface() {
  const TemporaryFolder data, pictures;
  const experiments::test::KnownPair known = experiments::test::known_pair();
  const fs::path liver = data.path() / "stereo_opencas", silicone = data.path() / "stereo_heart";
  for (const fs::path& folder : {liver, silicone}) {
    fs::create_directory(folder);
    glisson::test::write_text_calibration(folder, known.pair.rig);
  }
  Picture marked = known.pair.mask;
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(*marked.bytes);
  for (std::uint8_t& byte : *bytes) byte = byte == 0 ? 255 : 0;
  marked.bytes = bytes;
  const std::string start = "Stereo_SD_d_complete_22_";
  stereo::write_picture(liver / (start + "IMG_left.bmp"), known.pair.left);
  stereo::write_picture(liver / (start + "IMG_right.bmp"), known.pair.right);
  stereo::write_picture(liver / (start + "MASK_eval.png"), marked);
  write_triangle_mesh(liver / (start + "CT_cut.stl"), surface_of(known.depth, known.pair.rig.left),
                      LengthUnit::millimetre);
  stereo::write_picture(silicone / "f7_dynamic_deint_L_0100.png", known.pair.left);
  stereo::write_picture(silicone / "f7_dynamic_deint_R_0100.png", known.pair.right);
  stereo::write_picture(silicone / "f7_dynamic_deint_mask_0100.png", known.pair.mask);
  StereoProofOptions options;
  options.data = data.path();
  options.theatre = false;
  const auto proof = prove_stereo(options, pictures.path(), RunContext());
  QVERIFY(proof);
  QCOMPARE(proof->absent, std::vector<std::string>{"stereo_chessboard"});
  const Figures& figures = proof->figures;
  for (const char* way : {"sparse", "dense"}) {
    const std::string key = std::string("opencas_") + way + "_";
    QVERIFY(figures.at(key + "points") > 100.0);
    QVERIFY2(figures.at(key + "median_mm") < 0.4, qPrintable(QString::number(figures.at(key + "median_mm"))));
    QVERIFY(figures.at(key + "within_3mm_share") > 0.95);
    QVERIFY(figures.at(key + "without_offset_median_mm") < 0.4);
    QCOMPARE(figures.at(std::string("heart_") + way + "_points"), figures.at(key + "points"));
    for (const char* what : {"errors.png", "density.png"})
      QCOMPARE(stereo::read_picture(pictures.path() / (key + what)).width, known.pair.left.width);
  }
  QVERIFY(std::abs(figures.at("opencas_common_offset_mm")) < 0.2);
  QVERIFY(figures.at("heart_sparse_epipolar_rms_px") < 0.8);
  QCOMPARE(figures.at("heart_faults"), 0.0);
}

void PicturesOfOthersTest::WhatTheTheatreShowsIsMeasured() {
  const TemporaryFolder folder;
  StereoProofOptions options;
  options.only = "near";
  const auto proof = prove_stereo(options, folder.path(), RunContext());
  QVERIFY(proof);
  for (const Aim& aim : stereo_aims())
    if (aim.evidence == Evidence::in_silico)
      QVERIFY2(verdict(aim, proof->figures) != Verdict::not_measured, aim.key.c_str());
  QCOMPARE(proof->absent.size(), std::size_t{3});
  QCOMPARE(proof->table.size(), std::size_t{3});  // heads, features, dense
  for (const char* method : {"sparse", "dense"})
    QVERIFY(proof->figures.at(std::string("theatre_near_") + method + "_points") > 100.0);
  QVERIFY(proof->figures.at("theatre_near_sparse_median_mm") < 0.5);
  QCOMPARE(std::ranges::count(read_file(folder.path() / "theatre.csv"), '\n'), 3);
}

QTEST_GUILESS_MAIN(PicturesOfOthersTest)
#include "pictures_of_others_test.moc"
