// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/labelled_cloud.h"

#include <QTest>
#include <cstring>
#include <fstream>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "mutant.h"

using namespace glisson;

namespace {

LabelledCloud example() {
  LabelledCloud cloud;
  cloud.points.resize(4, 3);
  cloud.points << 0.01, 0.02, 0.1, -0.03, 0.0, 0.12, 1.0 / 3000.0, -0.005, 0.09, 0.0, 0.0, 0.1;
  cloud.normals.resize(4, 3);
  cloud.normals << 0, 0, -1, 0, 1, 0, 0.6, 0, -0.8, 1, 0, 0;
  cloud.features = {Feature::surface, Feature::anterior_margin, Feature::umbilical_notch, Feature::surface};
  cloud.sigma = {0.001, 0.0005, 0.0, 0.002};
  return cloud;
}

template <class T>
void put(std::string& text, T value, bool big_endian) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  if (big_endian) std::reverse(bytes, bytes + sizeof(T));  // the tests run on little-endian machines
  text.append(bytes, sizeof(T));
}

/// Two points among elements, lists and properties that a cloud has no use for.
std::string crowded_binary(bool big_endian) {
  std::string text = std::string("ply\r\nformat binary_") + (big_endian ? "big" : "little") +
                     "_endian 1.0\ncomment x\nobj_info y\nelement thing 2\nproperty list uchar short items\n"
                     "property double weight\nelement vertex 2\nproperty uchar red\nproperty float x\n"
                     "property double y\nproperty list ushort int ids\nproperty short z\nproperty int label\n"
                     "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (int thing = 0; thing < 2; ++thing) {
    put<std::uint8_t>(text, static_cast<std::uint8_t>(thing + 1), big_endian);
    for (int k = 0; k <= thing; ++k) put<std::int16_t>(text, 7, big_endian);
    put<double>(text, 0.5, big_endian);
  }
  for (int i = 0; i < 2; ++i) {
    put<std::uint8_t>(text, 255, big_endian);
    put<float>(text, 1.5F + static_cast<float>(i), big_endian);
    put<double>(text, -2.25, big_endian);
    put<std::uint16_t>(text, 2, big_endian);
    put<std::int32_t>(text, 1, big_endian);
    put<std::int32_t>(text, 2, big_endian);
    put<std::int16_t>(text, 100, big_endian);
    put<std::int32_t>(text, i + 2, big_endian);
  }
  put<std::uint8_t>(text, 3, big_endian);
  for (int k = 0; k < 3; ++k) put<std::int32_t>(text, 0, big_endian);
  return text;
}

std::string ascii(const std::string& properties, const std::string& rows, int count) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) + "\n" + properties +
         "end_header\n" + rows;
}

/// The coordinates' properties between others.
std::string xyz(const char* after = "", const char* before = "") {
  std::string text = before;
  text += "property float x\nproperty float y\nproperty float z\n";
  text += after;
  return text;
}

}  // namespace

class LabelledCloudTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;

  std::filesystem::path file(const std::string& content) {
    std::ofstream(folder_.path() / "cloud.ply", std::ios::binary) << content;
    return folder_.path() / "cloud.ply";
  }

  std::string refusal(const std::string& content) {
    return test::refused_field([&] { read_cloud(file(content)); });
  }

 private slots:
  void WhatIsWrittenIsRead_data() {
    QTest::addColumn<int>("unit");
    QTest::newRow("mm") << static_cast<int>(LengthUnit::millimetre);
    QTest::newRow("cm") << static_cast<int>(LengthUnit::centimetre);
    QTest::newRow("m") << static_cast<int>(LengthUnit::metre);
  }
  void WhatIsWrittenIsRead() {
    QFETCH(int, unit);
    const LabelledCloud cloud = example();
    const auto path = folder_.path() / "round.ply";
    write_cloud(path, cloud, static_cast<LengthUnit>(unit));
    const LabelledCloud back = read_cloud(path, static_cast<LengthUnit>(unit));
    QVERIFY((back.points - cloud.points).cwiseAbs().maxCoeff() < 1e-15);
    QVERIFY((back.normals - cloud.normals).cwiseAbs().maxCoeff() < 1e-7);
    QVERIFY(back.features == cloud.features);
    for (std::size_t i = 0; i < 4; ++i) QVERIFY(std::abs(back.sigma[i] - cloud.sigma[i]) < 1e-9);
  }

  void UnitsScaleThePoints() {
    const auto path = file(ascii(xyz(), "1 2 3\n", 1));
    QCOMPARE(read_cloud(path).points(0, 2), 0.003);
    QCOMPARE(read_cloud(path, LengthUnit::centimetre).points(0, 2), 0.03);
    QCOMPARE(read_cloud(path, LengthUnit::metre).points(0, 2), 3.0);
  }

  void EveryFormatGivesTheSamePoints() {
    for (const bool big_endian : {false, true}) {
      const LabelledCloud cloud = read_cloud(file(crowded_binary(big_endian)), LengthUnit::metre);
      QCOMPARE(cloud.size(), 2);
      QCOMPARE(cloud.points(1, 0), 2.5);
      QCOMPARE(cloud.points(1, 1), -2.25);
      QCOMPARE(cloud.points(1, 2), 100.0);
      QVERIFY(cloud.feature(0) == Feature::anterior_margin && cloud.feature(1) == Feature::umbilical_notch);
      QVERIFY(cloud.normals.rows() == 0 && cloud.sigma.empty());
    }
    const LabelledCloud text =
        read_cloud(file(ascii(xyz("property float label\n", "property list uchar int ids\n"),
                              "2 5 6 +1.5 -2.25e0 1e2 2\r\n0 2.5 -2.25 100 3.0\n\n", 2)),
                   LengthUnit::metre);
    QCOMPARE(text.points(0, 0), 1.5);
    QCOMPARE(read_cloud(file(ascii(xyz(), "1e-400 2 3\n", 1))).points(0, 0), 0.0);  // below what doubles hold
    QCOMPARE(text.points(1, 2), 100.0);
    QVERIFY(text.feature(0) == Feature::anterior_margin && text.feature(1) == Feature::umbilical_notch);
  }

  void NormalsBecomeUnit() {
    const auto path =
        file(ascii(xyz("property float nx\nproperty float ny\nproperty float nz\n"), "1 2 3 0 3 4\n", 1));
    QVERIFY((read_cloud(path).normals.row(0) - Eigen::RowVector3d(0, 0.6, 0.8)).norm() < 1e-12);
  }

  void ColumnsAreKnownAsOtherProgramsSpellThem() {
    const auto path = file(ascii(xyz("property float scalar_Label\nproperty float scalar_sigma\n"),
                                 "1 2 3 2 0.5\n4 5 6 3 0.25\n", 2));
    const LabelledCloud cloud = read_cloud(path);  // as CloudCompare saves it
    QVERIFY(cloud.feature(0) == Feature::anterior_margin && cloud.feature(1) == Feature::umbilical_notch);
    QCOMPARE(cloud.sigma.size(), 2U);
    QCOMPARE(cloud.sigma[1], 0.25e-3);
    const LabelledCloud capitals = read_cloud(file(ascii(
        "property float X\nproperty float Y\nproperty float Z\nproperty uchar LABEL\n", "1 2 3 2\n", 1)));
    QCOMPARE(capitals.points(0, 2), 0.003);
    QVERIFY(capitals.feature(0) == Feature::anterior_margin);
  }

  void PointsWithoutALabelAreSurface() {
    const LabelledCloud cloud = read_cloud(file(ascii(xyz(), "1 2 3\n", 1)));
    QVERIFY(cloud.features.empty() && cloud.feature(0) == Feature::surface);
  }

  void BadInputIsRefusedAndNamed_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QByteArray>("field");
    const auto row = [](const char* name, const std::string& content, const char* field) {
      QTest::newRow(name) << QByteArray(content.data(), static_cast<qsizetype>(content.size()))
                          << QByteArray(field);
    };
    row("empty", "", "");
    row("not a PLY", "solid\n", "");
    row("NaN", ascii(xyz(), "1 2 3\n1 nan 3\n", 2), "vertex 1");
    row("infinite", ascii(xyz(), "1 2 1e400\n", 1), "vertex 0");
    row("truncated text", ascii(xyz(), "1 2 3\n1 2\n", 2), "vertex 1");
    row("words", ascii(xyz(), "1 2 3\n1 two 3\n", 2), "vertex 1");
    row("numbers with tails", ascii(xyz(), "1 2 3mm\n", 1), "vertex 0");
    row("truncated binary", crowded_binary(false).substr(0, crowded_binary(false).size() - 30), "vertex 1");
    row("bad label", ascii(xyz("property int label\n"), "1 2 3 4\n", 1), "vertex 0");
    row("zero label", ascii(xyz("property int label\n"), "1 2 3 0\n", 1), "vertex 0");
    row("two labels", ascii(xyz("property int label\nproperty float scalar_label\n"), "1 2 3 1 2\n", 1),
        "vertex");
    row("negative sigma", ascii(xyz("property float sigma\n"), "1 2 3 -1\n", 1), "vertex 0");
    row("no points", ascii(xyz(), "", 0), "vertex");
    row("no vertices", "ply\nformat ascii 1.0\nend_header\n", "vertex");
    row("no z", ascii("property float x\nproperty float y\n", "1 2\n", 1), "vertex");
    row("count beyond the file", ascii(xyz(), "1 2 3\n", 4000000), "vertex 2");
    row("count beyond any organ", ascii(xyz(), "1 2 3\n", 2000000000), "vertex");
    row("huge count", "ply\nformat ascii 1.0\nelement vertex 99999999999999999999999\n", "header, line 3");
    row("property twice", ascii(xyz("property float x\n"), "1 2 3 4\n", 1), "header, line 7");
    row("unknown entry", "ply\nformat ascii 1.0\nvertices 3\n", "header, line 3");
    row("no properties", "ply\nformat ascii 1.0\nelement vertex 3\nend_header\n1 2 3\n", "vertex");
    row("no format", "ply\nelement vertex 1\nproperty float x\nend_header\n", "header, line 4");
    row("odd format", "ply\nformat utf8 1.0\nend_header\n", "header, line 2");
    row("odd type", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n", "header, line 4");
    row("odd list", "ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\n", "header, line 4");
    row("property first", "ply\nformat ascii 1.0\nproperty float x\n", "header, line 3");
    row("no end", "ply\nformat ascii 1.0\n", "header, line 3");
    row("list longer than the file", ascii(xyz("", "property list int int ids\n"), "1000000 1 2 3\n", 1),
        "vertex 0");
    row("negative list", ascii(xyz("", "property list int int ids\n"), "-1 1 2 3\n", 1), "vertex 0");
    row("two of three coordinates of normals",
        ascii(xyz("property float nx\nproperty float nz\n"), "1 2 3 0 -1\n", 1), "vertex");
    row("flat normal",
        ascii(xyz("property float nx\nproperty float ny\nproperty float nz\n"), "1 2 3 0 0 0\n", 1),
        "vertex 0");
  }
  void BadInputIsRefusedAndNamed() {
    QFETCH(QByteArray, content);
    QFETCH(QByteArray, field);
    QCOMPARE(QByteArray::fromStdString(refusal(content.toStdString())), field);
  }

  void MissingFileIsAFileError() {
    QVERIFY_THROWS_EXCEPTION(FileError, read_cloud(folder_.path() / "absent.ply"));
  }

  void MutantsNeverCrash() {
    const auto path = folder_.path() / "seed.ply";
    write_cloud(path, example());
    const std::string sources[] = {read_file(path), crowded_binary(false), crowded_binary(true),
                                   ascii(xyz("property int label\n"), "1 2 3 1\n4 5 6 2\n", 2)};
    std::mt19937 random(7);  // NOLINT: the same mutants on every run
    int refused = 0, read = 0;
    for (int mutant = 0; mutant < 800; ++mutant) {
      const std::string text = test::mutant_of(sources[mutant % 4], random, 8);
      const std::string result = refusal(text);
      QVERIFY2(!result.starts_with("other") && result != "no remedy", result.c_str());
      ++(result == "none" ? read : refused);
    }
    QVERIFY(refused > 200 && read > 20);  // the mutants do hit both
  }

  void ACloudOfNoLiversSizeIsRefusedWithTheUnitToReadItIn() {
    LabelledCloud cloud;
    cloud.points.resize(27, 3);  // 60 mm a side
    for (int i = 0; i < 27; ++i) cloud.points.row(i) = 0.03 * Eigen::RowVector3d(i % 3, i / 3 % 3, i / 9);
    require_liver_sized(cloud, LengthUnit::millimetre, "c.ply");
    cloud.points.row(0) << 40.0, 0.0, 0.0;  // an outlier
    require_liver_sized(cloud, LengthUnit::millimetre, "c.ply");
    const auto complaint_of = [](const LabelledCloud& wrong, LengthUnit unit) -> std::string {
      try {
        require_liver_sized(wrong, unit, "c.ply");
        return {};
      } catch (const InputError& error) {
        return error.what();
      }
    };
    LabelledCloud large = cloud, small = cloud;
    large.points *= 1e3;
    small.points *= 1e-3;
    QVERIFY(complaint_of(large, LengthUnit::metre).find("millimetre") != std::string::npos ||
            complaint_of(large, LengthUnit::metre).find("mm") != std::string::npos);
    QVERIFY(complaint_of(small, LengthUnit::millimetre).starts_with("c.ply: size"));
    small.points.conservativeResize(5, 3);  // a few points may lie together
    require_liver_sized(small, LengthUnit::millimetre, "c.ply");
    require_liver_sized(LabelledCloud(), LengthUnit::millimetre, "c.ply");
  }

  void WriterRefusesWhatNoCloudIs() {
    const auto path = folder_.path() / "never.ply";
    LabelledCloud cloud = example();
    cloud.features.pop_back();
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_cloud(path, cloud));
    cloud = example();
    cloud.sigma.pop_back();
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_cloud(path, cloud));
    cloud = example();
    cloud.normals.conservativeResize(2, 3);
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_cloud(path, cloud));
    cloud = example();
    cloud.points(0, 0) = std::nan("");
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_cloud(path, cloud));
    QVERIFY(!std::filesystem::exists(path));
  }
};

QTEST_APPLESS_MAIN(LabelledCloudTest)
#include "labelled_cloud_test.moc"
