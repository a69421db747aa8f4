// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <QTest>
#include <cstring>
#include <fstream>
#include <map>

#include "dicom_bytes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/io.h"
#include "phantom.h"

using namespace glisson;
namespace fs = std::filesystem;

namespace {

template <class Read>
QString refusal_by(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    return QString::fromStdString(error.what());
  }
  return "";
}
/// The sentence with which a file is refused, or "" when it is not.
QString refusal_of(const fs::path& path) {
  return refusal_by([&] { (void)read_image(path, RunContext()); });
}
QString refusal_of_labels(const fs::path& path) {
  return refusal_by([&] { (void)read_labels(path); });
}

void put_text(const fs::path& path, const std::string& text) { write_file_atomically(path, text); }

std::string nrrd_of(const std::string& fields, const std::string& data) {
  return "NRRD0004\ntype: uchar\nencoding: raw\n" + fields + "\n\n" + data;
}

/// A plain NIfTI file whose header bytes can be changed.
std::string plain_nifti(const fs::path& folder) {
  write_image(folder / "plain.nii", test::stored_world(0));
  return read_file(folder / "plain.nii");
}
template <class T>
void put(std::string& bytes, std::size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

std::string vti_of(const std::string& attributes, const std::string& arrays) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" "
         "byte_order=\"LittleEndian\">\n<ImageData "
         "WholeExtent=\"0 1 0 1 0 1\" " +
         attributes + ">\n<Piece Extent=\"0 1 0 1 0 1\">\n<PointData Scalars=\"s\">" + arrays +
         "</PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
}
const std::string kEight =
    "<DataArray type=\"Int16\" Name=\"s\" format=\"ascii\">1 2 3 4 5 6 7 8</DataArray>";

}  // namespace

class RefusalTest : public QObject {
  Q_OBJECT
 private slots:
  void MissingFilesAndEmptyFolders();
  void FilesOfAnotherKind();
  void FilesThatAreNoLabels();
  void GeometryThatIsNoPatients_data();
  void GeometryThatIsNoPatients();
  void NiftiWithoutOneOrientation();
  void VolumesThatAreNotScalar();
  void NumbersThatAreNoIntensities();
  void LabelsThatAreNoLabels();
  void VtiKeepsOriginExtentAndDirection();
  void LayersOfASegmentationAreFlattened();
  void WhatNoSegmentNamesIsThereWithoutAName();
  void TheModalityIsKnownWhateverItsCase();
  void TheReaderCanBeMissing();
  void WritersRefuseWhatTheyCannotWrite();
  void DamagedFilesNeverTakeTheProcessDown_data();
  void DamagedFilesNeverTakeTheProcessDown();
};

void RefusalTest::MissingFilesAndEmptyFolders() {
  const TemporaryFolder folder;
  QVERIFY_THROWS_EXCEPTION(FileError, read_image(folder.path() / "absent.nrrd", RunContext()));
  QVERIFY_THROWS_EXCEPTION(FileError, read_labels(folder.path() / "absent.nrrd"));
  QVERIFY(refusal_of(folder.path()).contains("is an empty folder"));
  // What is in it is no file, wherever.
  fs::create_directory(folder.path() / "disc");
  QVERIFY(refusal_of(folder.path()).contains("is an empty folder"));
  fs::create_symlink("nowhere", folder.path() / "slices");
  QVERIFY2(refusal_of(folder.path()).contains("holds no file: slices is a pipe"),
           qPrintable(refusal_of(folder.path())));
  QCOMPARE(::mkfifo((folder.path() / "disc/camera").c_str(), 0600), 0);
  QVERIFY2(refusal_of(folder.path()).contains("holds no file: disc/camera is a pipe"),
           qPrintable(refusal_of(folder.path())));
  put_text(folder.path() / "notes.txt", "no picture");
  QVERIFY(refusal_of(folder.path()).contains("holds no DICOM image"));
}

void RefusalTest::FilesOfAnotherKind() {
  const TemporaryFolder folder;
  put_text(folder.path() / "a.txt", "text");
  QVERIFY(refusal_of(folder.path() / "a.txt").contains("extension"));
  for (const char* text :
       {"x", "The patient was seen on Monday; the pictures are on the other disc.\n", ""}) {
    put_text(folder.path() / "letter.dcm", text);
    const QString refusal = refusal_of(folder.path() / "letter.dcm");
    QVERIFY2(refusal.contains("is named as DICOM, but is none"), qPrintable(refusal));
  }
  write_file_atomically(folder.path() / "slice.dcm", test::dicom_of(0, {}));
  QVERIFY(refusal_of(folder.path() / "slice.dcm").contains("single DICOM slice"));
  put_text(folder.path() / "a.tar.gz", "no archive");
  QVERIFY(refusal_of(folder.path() / "a.tar.gz").contains("cannot be unpacked"));
  for (const char* name : {"a.nrrd", "a.nii", "a.nii.gz", "a.mha", "a.vti"}) {
    put_text(folder.path() / name, "this is no volume at all, whatever its name says");
    QVERIFY2(!refusal_of(folder.path() / name).isEmpty(), name);
  }
}

/// What to do is another thing with labels: no archive of them is read, and no folder of slices.
void RefusalTest::FilesThatAreNoLabels() {
  const TemporaryFolder folder;
  for (const char* name : {"a.zip", "A.ZIP", "a.tar", "a.tar.gz", "a.tgz"}) {
    put_text(folder.path() / name, "whatever it holds");
    const QString refusal = refusal_of_labels(folder.path() / name);
    QVERIFY2(refusal.contains("is an archive") && refusal.contains("name the file of labels in it"),
             qPrintable(refusal));
  }
  put_text(folder.path() / "a.txt", "text");
  const QString refusal = refusal_of_labels(folder.path() / "a.txt");
  QVERIFY2(refusal.contains("extension") && refusal.contains(".seg.nrrd") && !refusal.contains(".zip"),
           qPrintable(refusal));
  QVERIFY(refusal_of(folder.path() / "a.txt").contains(".zip"));
}

void RefusalTest::GeometryThatIsNoPatients_data() {
  QTest::addColumn<QByteArray>("fields");
  QTest::addColumn<QString>("word");
  const QByteArray size = "dimension: 3\nsizes: 2 2 2\n", lps = "space: left-posterior-superior\n",
                   origin = "\nspace origin: (0,0,0)";
  QTest::newRow("zero spacing") << QByteArray(size + lps + "space directions: (0,0,0) (0,1,0) (0,0,1)" +
                                              origin)
                                << QString();
  QTest::newRow("metres") << QByteArray(size + lps +
                                        "space directions: (0.0008,0,0) (0,0.0008,0) (0,0,0.0025)" + origin)
                          << QString("spacing");
  QTest::newRow("a giant") << QByteArray(size + lps + "space directions: (500,0,0) (0,500,0) (0,0,500)" +
                                         origin)
                           << QString("spacing");
  QTest::newRow("sheared") << QByteArray(size + lps + "space directions: (1,0,0) (0,1,0) (0,0.4,1)" + origin)
                           << QString("right angles");
  QTest::newRow("no space") << QByteArray(size + "spacings: 1 1 1") << QString("space");
  QTest::newRow("flat") << QByteArray("dimension: 2\nsizes: 4 2\nspacings: 1 1") << QString();
}

void RefusalTest::GeometryThatIsNoPatients() {
  QFETCH(QByteArray, fields);
  QFETCH(QString, word);
  const TemporaryFolder folder;
  put_text(folder.path() / "a.nrrd", nrrd_of(fields.toStdString(), "12345678"));
  const QString refusal = refusal_of(folder.path() / "a.nrrd");
  QVERIFY2(!refusal.isEmpty() && refusal.contains(word), qPrintable(refusal));
}

void RefusalTest::NiftiWithoutOneOrientation() {
  const TemporaryFolder folder;
  const std::string good = plain_nifti(folder.path());
  const fs::path path = folder.path() / "changed.nii";
  put_text(path, good);
  QCOMPARE(refusal_of(path), QString());

  std::string none = good;
  put<std::int16_t>(none, 252, 0);
  put<std::int16_t>(none, 254, 0);
  put_text(path, none);
  QVERIFY2(refusal_of(path).contains("which way the patient lies"), qPrintable(refusal_of(path)));

  std::string flipped = good;  // the sform says the other way round along i
  float x = 0.0F;
  std::memcpy(&x, good.data() + 280, sizeof x);
  put(flipped, 280, -x);
  put_text(path, flipped);
  QVERIFY2(refusal_of(path).contains("place the volume differently"), qPrintable(refusal_of(path)));

  std::string sheared = good;
  put<std::int16_t>(sheared, 252, 0);
  put(sheared, 284, 0.5F);
  put_text(path, sheared);
  QVERIFY2(refusal_of(path).contains("right angles"), qPrintable(refusal_of(path)));
}

void RefusalTest::VolumesThatAreNotScalar() {
  const TemporaryFolder folder;
  put_text(
      folder.path() / "rgb.nrrd",
      nrrd_of("dimension: 4\nsizes: 3 2 2 2\nspace: left-posterior-superior\nkinds: RGB-color domain domain "
              "domain\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)",
              std::string(24, 'a')));
  QVERIFY2(refusal_of(folder.path() / "rgb.nrrd").contains("3 values each"),
           qPrintable(refusal_of(folder.path() / "rgb.nrrd")));
  std::string series = plain_nifti(folder.path());
  put<std::int16_t>(series, 40, 4);
  put<std::int16_t>(series, 48, 2);
  series.append(series.substr(352));
  put_text(folder.path() / "series.nii", series);
  QVERIFY2(refusal_of(folder.path() / "series.nii").contains("series of 2 volumes"),
           qPrintable(refusal_of(folder.path() / "series.nii")));
}

void RefusalTest::NumbersThatAreNoIntensities() {
  const TemporaryFolder folder;
  const auto floats = [](float a, float b) {
    std::string data;
    for (int i = 0; i < 8; ++i) {
      const float value = i % 2 == 0 ? a : b;
      data.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    return "NRRD0004\ntype: float\nendian: little\nencoding: raw\ndimension: 3\nsizes: 2 2 2\nspace: "
           "LPS\nspace "
           "directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n\n" +
           data;
  };
  put_text(folder.path() / "a.nrrd", floats(0.0F, 0.7F));
  QVERIFY(refusal_of(folder.path() / "a.nrrd").contains("too few grey levels"));
  put_text(folder.path() / "a.nrrd", floats(100.0F, std::nanf("")));
  QVERIFY(refusal_of(folder.path() / "a.nrrd").contains("not a number"));
  put_text(folder.path() / "a.nrrd", floats(0.0F, 1e7F));
  QVERIFY(refusal_of(folder.path() / "a.nrrd").contains("beyond 16-bit"));
  put_text(folder.path() / "a.nrrd", floats(-1000.25F, 412.75F));
  const Image image = read_image(folder.path() / "a.nrrd", RunContext()).value();
  QCOMPARE(int(image.at({0, 0, 0})), -1000);
  QCOMPARE(int(image.at({1, 0, 0})), 413);
}

void RefusalTest::LabelsThatAreNoLabels() {
  const TemporaryFolder folder;
  write_image(folder.path() / "ct.nrrd", test::stored_world(0));
  QVERIFY_THROWS_EXCEPTION(InputError, read_labels(folder.path() / "ct.nrrd"));
}

void RefusalTest::VtiKeepsOriginExtentAndDirection() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.vti";
  put_text(path, vti_of("Origin=\"1 2 3\" Spacing=\"1 2 4\" Direction=\"0 -1 0 1 0 0 0 0 1\"", kEight));
  const Image image = read_image(path, RunContext()).value();
  QCOMPARE(image.grid.origin_mm, Eigen::Vector3d(1, 2, 3));
  QCOMPARE(image.grid.spacing_mm, Eigen::Vector3d(1, 2, 4));
  // One step along i is +y, one along j is -x (VTK lists the matrix by rows).
  QVERIFY((image.grid.p_in_ct({1, 0, 0}).xyz - Eigen::Vector3d(1e-3, 3e-3, 3e-3)).norm() < 1e-12);
  QVERIFY((image.grid.p_in_ct({0, 1, 0}).xyz - Eigen::Vector3d(-1e-3, 2e-3, 3e-3)).norm() < 1e-12);
  QCOMPARE(int(image.at({1, 1, 0})), 4);

  std::string shifted = vti_of("Origin=\"0 0 0\" Spacing=\"1 2 4\"", kEight);
  for (std::size_t at = 0; (at = shifted.find("0 1 0 1 0 1", at)) != std::string::npos;)
    shifted.replace(at, 11, "5 6 0 1 0 1");
  put_text(path, shifted);
  QCOMPARE(read_image(path, RunContext()).value().grid.origin_mm, Eigen::Vector3d(5, 0, 0));

  put_text(
      path,
      vti_of("Origin=\"0 0 0\" Spacing=\"1 1 1\"",
             "<DataArray type=\"Int16\" Name=\"s\" NumberOfComponents=\"2\" format=\"ascii\">1 2 3 4 5 6 7 8 "
             "9 10 11 12 13 14 15 16</DataArray>"));
  QVERIFY(refusal_of(path).contains("2 values each"));
  put_text(path, vti_of("Origin=\"0 0 0\" Spacing=\"1 1 1\"", ""));
  QVERIFY(!refusal_of(path).isEmpty());
}

void RefusalTest::LayersOfASegmentationAreFlattened() {
  const TemporaryFolder folder;
  // Two layers over 2 x 2 x 2 voxels: the liver (label 1, layer 1) everywhere, a tumour (label 1, layer 0) in
  // two.
  std::string data;
  for (int voxel = 0; voxel < 8; ++voxel) data += {static_cast<char>(voxel < 2 ? 1 : 0), 1};
  const auto file = [&](const std::string& layer) {
    return nrrd_of(
        "dimension: 4\nsizes: 2 2 2 2\nspace: left-posterior-superior\nkinds: list domain domain domain\n"
        "space directions: none (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n"
        "Segment0_ID:=a\nSegment0_Name:=tumour\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
        "Segment0_Color:=1 0 0\nSegment1_ID:=b\nSegment1_Name:=liver\nSegment1_LabelValue:=1\n"
        "Segment1_Tags:=TerminologyEntry:t~u|\nSegment1_Layer:=" +
            layer,
        data);
  };
  put_text(folder.path() / "a.seg.nrrd", file("1"));
  const LabelFile labels = read_labels(folder.path() / "a.seg.nrrd");
  QCOMPARE(labels.infos.size(), std::size_t(2));
  QCOMPARE(labels.infos[0].name, std::string("tumour"));
  QCOMPARE(labels.infos[1].terminology, std::string("t~u"));
  const std::vector<long> counts = labels.voxels.histogram();
  QCOMPARE(counts[labels.infos[0].code], 2L);  // the smaller lies above the larger
  QCOMPARE(counts[labels.infos[1].code], 6L);
  put_text(folder.path() / "a.seg.nrrd", file("7"));
  QVERIFY_THROWS_EXCEPTION(InputError, read_labels(folder.path() / "a.seg.nrrd"));
}

void RefusalTest::WhatNoSegmentNamesIsThereWithoutAName() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.seg.nrrd";
  const std::string space = "space: left-posterior-superior\nspace origin: (0,0,0)\nspace directions: ",
                    keys =
                        "\nSegment0_ID:=a\nSegment0_Name:=liver\nSegment0_LabelValue:=3\n"
                        "Segment0_Layer:=0";
  const auto found = [&] {
    const LabelFile file = read_labels(path);
    const std::vector<long> counts = file.voxels.histogram();
    std::map<std::string, std::vector<long>> voxels;  // of the labels with each name
    for (const LabelInfo& info : file.infos)
      voxels[info.name].push_back(info.code < counts.size() ? counts[info.code] : 0);
    return voxels;
  };
  // One layer: the liver, and two voxels of a segment whose keys were lost.
  const std::string one = "dimension: 3\nsizes: 2 2 2\n" + space + "(1,0,0) (0,1,0) (0,0,1)" + keys;
  put_text(path, nrrd_of(one, std::string("\3\3\3\3\3\0\7\7", 8)));
  const std::map<std::string, std::vector<long>> expected = {{"liver", {5}}, {"", {2}}};
  QVERIFY(found() == expected);
  // A key that is missing hides those after it.
  put_text(path, nrrd_of(one + "\nSegment2_ID:=b\nSegment2_Name:=tumour\nSegment2_LabelValue:=7",
                         std::string("\3\3\3\3\3\0\7\7", 8)));
  QVERIFY(found() == expected);
  // Two layers: the same value in the other one is something else, and was left out without a word.
  const std::string two = "dimension: 4\nsizes: 2 2 2 2\nkinds: list domain domain domain\n" + space +
                          "none (1,0,0) (0,1,0) (0,0,1)" + keys;
  for (const char other : {'\7', '\3'}) {
    std::string data;
    for (int voxel = 0; voxel < 8; ++voxel) data += {'\3', voxel < 2 ? other : '\0'};
    put_text(path, nrrd_of(two, data));
    QVERIFY((found() == std::map<std::string, std::vector<long>>{{"liver", {6}}, {"", {2}}}));
  }
}

void RefusalTest::TheModalityIsKnownWhateverItsCase() {
  const TemporaryFolder folder;
  for (const auto& [word, modality] :
       {std::pair("CT", Modality::ct), {"ct", Modality::ct}, {"MR", Modality::mr}, {"US", Modality::other}}) {
    put_text(folder.path() / "a.nrrd",
             nrrd_of("dimension: 3\nsizes: 2 2 2\nspace: left-posterior-superior\nspace origin: (0,0,0)\n"
                     "space directions: (1,0,0) (0,1,0) (0,0,1)\nmodality:=" +
                         std::string(word),
                     "12345678"));
    QCOMPARE(read_image(folder.path() / "a.nrrd", RunContext())->modality, modality);
  }
}

void RefusalTest::TheReaderCanBeMissing() {
  // A wrong place in the environment is passed over: the one beside the program is used.
  const TemporaryFolder folder;
  write_image(folder.path() / "a.nrrd", test::stored_world(0));
  qputenv("GLISSON_READ_VOLUME", "/nowhere/at/all");
  QCOMPARE(refusal_of(folder.path() / "a.nrrd"), QString());
  // One that cannot do its work is an error, not a crash.
  qputenv("GLISSON_READ_VOLUME", "/bin/false");
  QVERIFY(refusal_of(folder.path() / "a.nrrd").contains("broke down"));
  qunsetenv("GLISSON_READ_VOLUME");
}

void RefusalTest::WritersRefuseWhatTheyCannotWrite() {
  const TemporaryFolder folder;
  const Image image = test::stored_world(0);
  QVERIFY_THROWS_EXCEPTION(InputError, write_image(folder.path() / "a.png", image));
  QVERIFY_THROWS_EXCEPTION(FileError, write_image(folder.path() / "absent" / "a.nrrd", image));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, write_image(folder.path() / "a.nrrd", Image()));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, write_labels(folder.path() / "a.nrrd", LabelVolume(), {}));
  // Nothing is left behind.
  QVERIFY(fs::is_empty(folder.path()));
}

void RefusalTest::DamagedFilesNeverTakeTheProcessDown_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"a.nrrd", "a.nii", "a.nii.gz", "a.mha", "a.vti"}) QTest::newRow(name) << name;
}

void RefusalTest::DamagedFilesNeverTakeTheProcessDown() {
  QFETCH(QString, name);
  const TemporaryFolder folder;
  const fs::path path = folder.path() / name.toStdString();
  if (name == "a.vti")
    put_text(path, vti_of("Origin=\"0 0 0\" Spacing=\"1 1 1\"", kEight));
  else
    write_image(path, test::stored_world(11));
  const std::string good = read_file(path);
  std::mt19937 random(17);
  int refused = 0;
  for (int mutant = 0; mutant < 14; ++mutant) {
    std::string bytes = good;
    if (mutant % 3 == 0) {
      bytes.resize(random() % bytes.size());
    } else {
      // Mostly in the header, where the harm is done.
      const std::size_t reach = std::min<std::size_t>(bytes.size(), mutant % 3 == 1 ? 348 : bytes.size());
      for (int flips = 0; flips < 6; ++flips)
        bytes[random() % reach] ^= static_cast<char>(1u << (random() % 8));
    }
    const fs::path damaged = folder.path() / ("damaged" + path.extension().string());
    std::ofstream(damaged, std::ios::binary) << bytes;
    const QString refusal = refusal_of(name == "a.nii.gz" ? [&] {
      const fs::path packed = folder.path() / "damaged.nii.gz";
      fs::rename(damaged, packed);
      return packed;
    }() : damaged);
    refused += refusal.isEmpty() ? 0 : 1;
    // A file cut in the middle is never taken for a whole one.
    if (mutant % 3 == 0) QVERIFY2(!refusal.isEmpty(), qPrintable(QString("cut at %1").arg(bytes.size())));
  }
  QVERIFY(refused >= 5);
}

QTEST_APPLESS_MAIN(RefusalTest)
#include "refusal_test.moc"
