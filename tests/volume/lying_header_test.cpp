// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cstring>
#include <limits>

#include "complaint.h"
#include "dicom_bytes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/io.h"
#include "phantom.h"

using namespace glisson;
namespace fs = std::filesystem;

/// Headers that say what cannot be: each was read once as if nothing were wrong with it.
class LyingHeaderTest : public QObject {
  Q_OBJECT
 private slots:
  void Nrrd_data();
  void Nrrd();
  void Meta_data();
  void Meta();
  void Nifti_data();
  void Nifti();
  void Dicom_data();
  void Dicom();
  void Vti_data();
  void Vti();
  void PackedMetaImagesTellTheirSize_data();
  void PackedMetaImagesTellTheirSize();
  void NumbersAsTextAreCounted();
  void FilesElsewhereAreNotFollowed();
  void TheLastBytesAreReadWhereTheHeaderSaysSo();
  void BytesPutInAreToldFromPadding_data();
  void BytesPutInAreToldFromPadding();
};

namespace {

/// The field with which a file is refused (see refused_field).
QString field_of(const fs::path& path) {
  return QString::fromStdString(test::refused_field([&] { (void)read_image(path, RunContext()); }));
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw PreconditionError("the text to be changed is not there: " + what);
  return text.replace(at, what.size(), by);
}

template <class T>
void put(std::string& bytes, std::size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

std::string bytes_of(const Image& image) {
  return std::string(reinterpret_cast<const char*>(image.voxels->data()), image.voxels->size() * 2);
}

const std::string kNrrd =
    "NRRD0004\ntype: short\nendian: little\nencoding: raw\ndimension: 3\nsizes: 6 5 4\n"
    "space: left-posterior-superior\nspace directions: (0.8,0,0) (0,1.1,0) (0,0,2.5)\n"
    "space origin: (-31,17,402.5)\n\n";
const std::string kMeta =
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = "
    "False\n"
    "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = -31 17 402.5\nElementSpacing = 0.8 1.1 2.5\n"
    "DimSize = 6 5 4\nElementType = MET_SHORT\nElementDataFile = LOCAL\n";

void change(const char* row, const char* what, const char* by, const char* field) {
  QTest::newRow(row) << QByteArray(what) << QByteArray(by) << QString(field);
}
void columns() {
  QTest::addColumn<QByteArray>("what");
  QTest::addColumn<QByteArray>("by");
  QTest::addColumn<QString>("field");
}

void check(const fs::path& path, const std::string& header) {
  QFETCH(QByteArray, what);
  QFETCH(QByteArray, by);
  QFETCH(QString, field);
  const std::string voxels = bytes_of(test::stored_world(0));
  write_file_atomically(path, header + voxels);
  QVERIFY(test::shows_world(read_image(path, RunContext()).value()));
  write_file_atomically(path, replaced(header + voxels, what.toStdString(), by.toStdString()));
  QCOMPARE(field_of(path), field);
}

}  // namespace

void LyingHeaderTest::Nrrd_data() {
  columns();
  change("a direction that overflows", "(0.8,0,0)", "(1e308,1e308,0)", "space directions");
  change("a direction that is not finite", "(0.8,0,0)", "(nan,0,0)", "space directions");
  change("a tiny direction", "(0.8,0,0)", "(1e-320,0,0)", "space directions");
  change("an origin beyond the hospital", "(-31,17,402.5)", "(1e300,17,402.5)", "origin");
  change("no origin", "space origin: (-31,17,402.5)\n", "", "space origin");
  change("no directions", "space directions: (0.8,0,0) (0,1.1,0) (0,0,2.5)\n", "spacings: 1 1 1\n",
         "space directions");
  change("micrometres", "space origin", "space units: \"um\" \"um\" \"um\"\nspace origin", "space units");
  change("fewer voxels than there are", "sizes: 6 5 4", "sizes: 6 5 3", "size");
  change("more voxels than there are", "sizes: 6 5 4", "sizes: 6 5 5", "voxels");
  change("a size below one", "sizes: 6 5 4", "sizes: 6 5 -4", "sizes");
  change("compressed, it says", "encoding: raw", "encoding: gzip", "encoding");
  change("another number type", "type: short", "type: uchar", "size");
  change("no byte order", "endian: little\n", "", "endian");
  change("a field twice", "dimension: 3", "dimension: 3\ndimension: 3", "dimension");
  change("lines to be skipped", "dimension: 3", "dimension: 3\nline skip: 4000", "line skip");
}
void LyingHeaderTest::Nrrd() {
  const TemporaryFolder folder;
  check(folder.path() / "a.nrrd", kNrrd);
}

void LyingHeaderTest::Meta_data() {
  columns();
  change("compressed, it says", "CompressedData = False", "CompressedData = True", "CompressedData");
  change("text, it says", "BinaryData = True", "BinaryData = False", "BinaryData");
  change("a header without end", "NDims = 3", "NDims = 3\nHeaderSize = 99999999", "HeaderSize");
  change("zero spacing", "0.8 1.1 2.5", "0 1.1 2.5", "ElementSpacing");
  change("no spacing", "ElementSpacing = 0.8 1.1 2.5\n", "", "ElementSpacing");
  change("no offset", "Offset = -31 17 402.5\n", "", "Offset");
  change("an offset that is not finite", "-31 17 402.5", "-31 inf 402.5", "Offset");
  change("no direction at all", "1 0 0 0 1 0 0 0 1", "0 0 0 0 0 0 0 0 0", "TransformMatrix");
  change("parallel axes", "1 0 0 0 1 0 0 0 1", "1 0 0 1 0 0 0 0 1", "TransformMatrix");
  change("fewer voxels than there are", "DimSize = 6 5 4", "DimSize = 6 5 2", "size");
  change("centimetres", "NDims = 3", "NDims = 3\nDistanceUnits = cm", "DistanceUnits");
  change("a byte order that is none", "MSB = False", "MSB = 1.1", "BinaryDataByteOrderMSB");
  change("two byte orders", "NDims = 3", "NDims = 3\nElementByteOrderMSB = True", "ElementByteOrderMSB");
  change("a broken line", "MSB = False", "MSB  False", "BinaryDataByteOrderMSB  False");
  change("another scale", "NDims = 3", "NDims = 3\nElementToIntensityFunctionSlope = 0",
         "ElementToIntensityFunctionSlope");
}
void LyingHeaderTest::Meta() {
  const TemporaryFolder folder;
  check(folder.path() / "a.mha", kMeta);
}

void LyingHeaderTest::Nifti_data() {
  QTest::addColumn<int>("offset");
  QTest::addColumn<double>("value");
  QTest::addColumn<QString>("field");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  // Offsets below 76 and the codes at 252 and 254 are 16-bit integers, others floats.
  QTest::newRow("no dimensions") << 40 << 0.0 << "dim[0]";
  QTest::newRow("a dimension of zero") << 44 << 0.0 << "dim[2]";
  QTest::newRow("a negative dimension") << 46 << -1.0 << "dim[3]";
  QTest::newRow("fewer slices than there are") << 46 << 2.0 << "size";
  QTest::newRow("an unknown number type") << 70 << 5.0 << "datatype";
  QTest::newRow("bits that do not fit") << 72 << 8.0 << "bitpix";
  QTest::newRow("no spacing") << 84 << 0.0 << "pixdim[2]";
  QTest::newRow("negative spacing") << 84 << -1.1 << "pixdim[2]";
  QTest::newRow("spacing of the one, not of the other") << 84 << 2.2 << "pixdim[2]";
  QTest::newRow("data in the header") << 108 << 12.0 << "vox_offset";
  QTest::newRow("data nowhere") << 108 << nan << "vox_offset";
  QTest::newRow("a scale that is none") << 112 << nan << "scl_slope, scl_inter";
  QTest::newRow("an offset without a scale") << 116 << 100.0 << "scl_slope, scl_inter";
  QTest::newRow("a negative scale") << 112 << -1.0 << "scl_slope, scl_inter";
  QTest::newRow("a scale of nothing") << 112 << 1e-30 << "scl_slope, scl_inter";
  QTest::newRow("no rotation") << 256 << 7.0 << "quatern";
  QTest::newRow("a parallel axis") << 284 << 1.1 << "sform";
  QTest::newRow("an axis without length") << 280 << 0.0 << "sform";
  QTest::newRow("an endless axis") << 280 << 1e38 << "sform";
  QTest::newRow("an origin nowhere") << 292 << 1e30 << "sform, qform";
}
void LyingHeaderTest::Nifti() {
  QFETCH(int, offset);
  QFETCH(double, value);
  QFETCH(QString, field);
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.nii";
  write_image(path, test::stored_world(0));
  QVERIFY(test::shows_world(read_image(path, RunContext()).value()));
  std::string bytes = read_file(path);
  if (offset == 116) put(bytes, 112, 0.0F);
  if (offset < 76)
    put(bytes, static_cast<std::size_t>(offset), static_cast<std::int16_t>(value));
  else
    put(bytes, static_cast<std::size_t>(offset), static_cast<float>(value));
  write_file_atomically(path, bytes);
  QCOMPARE(field_of(path), field);
}

void LyingHeaderTest::Dicom_data() {
  QTest::addColumn<QString>("tag");
  QTest::addColumn<QByteArray>("value");
  QTest::addColumn<QString>("word");
  const QByteArray three = QByteArray::fromStdString(test::short_of(3)),
                   four = QByteArray::fromStdString(test::short_of(4));
  QTest::newRow("pixels without size") << "0028|0030" << QByteArray("0\\0") << "PixelSpacing";
  QTest::newRow("pixels of one number") << "0028|0030" << QByteArray("0.8") << "PixelSpacing";
  QTest::newRow("pixels of no number") << "0028|0030" << QByteArray("a\\b") << "PixelSpacing";
  QTest::newRow("negative pixels") << "0028|0030" << QByteArray("-1.1\\0.8") << "PixelSpacing";
  QTest::newRow("a place of two numbers") << "0020|0032" << QByteArray("1\\2") << "ImagePositionPatient";
  QTest::newRow("axes without length")
      << "0020|0037" << QByteArray("0\\0\\0\\0\\0\\0") << "ImageOrientationPatient";
  QTest::newRow("parallel axes") << "0020|0037" << QByteArray("1\\0\\0\\1\\0\\0") << "";
  QTest::newRow("skewed axes") << "0020|0037" << QByteArray("1\\0\\0\\0.6\\0.8\\0") << "right angles";
  QTest::newRow("three samples") << "0028|0002" << three << "colour picture";
  QTest::newRow("four samples") << "0028|0002" << four << "colour picture";
  QTest::newRow("a palette") << "0028|0004" << QByteArray("PALETTE COLOR") << "";
  QTest::newRow("a slope of zero") << "0028|1053" << QByteArray("0") << "RescaleSlope";
  QTest::newRow("a negative slope") << "0028|1053" << QByteArray("-1") << "RescaleSlope";
  QTest::newRow("a slope that is no number") << "0028|1053" << QByteArray("nan") << "RescaleSlope";
  QTest::newRow("an endless intercept") << "0028|1052" << QByteArray("1e300") << "RescaleIntercept";
}
void LyingHeaderTest::Dicom() {
  QFETCH(QString, tag);
  QFETCH(QByteArray, value);
  QFETCH(QString, word);
  const TemporaryFolder folder;
  test::HandSlice slice;
  slice.other[tag.toStdString()] = value.toStdString();
  for (int k = 0; k < 4; ++k)
    write_file_atomically(folder.path() / ("slice" + std::to_string(k) + ".dcm"), test::dicom_of(k, slice));
  const std::string told = test::complaint([&] { (void)read_image(folder.path(), RunContext()); });
  QVERIFY2(!told.empty() && QString::fromStdString(told).contains(word), told.c_str());
}

void LyingHeaderTest::Vti_data() {
  columns();
  change("no spacing", "Spacing=\"1 1 2\"", "", "Spacing");
  change("no origin", "Origin=\"0 0 0\"", "", "Origin");
  change("zero spacing", "Spacing=\"1 1 2\"", "Spacing=\"0 1 2\"", "spacing");
  change("endless spacing", "Spacing=\"1 1 2\"", "Spacing=\"1e400 1 2\"", "Spacing");
  change("two numbers", "Spacing=\"1 1 2\"", "Spacing=\"1 1\"", "Spacing");
  change("too many values", "7 8<", "7 8 9<", "DataArray");
  change("too few values", "7 8<", "7<", "DataArray");
  change("a type that is too narrow", "type=\"Int16\" Name=\"s\" format=\"ascii\">1",
         "type=\"UInt8\" Name=\"s\" format=\"ascii\">-500", "DataArray");
  change("too large a value", "7 8<", "7 40000<", "DataArray");
}
void LyingHeaderTest::Vti() {
  QFETCH(QByteArray, what);
  QFETCH(QByteArray, by);
  QFETCH(QString, field);
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.vti";
  const std::string good =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<ImageData WholeExtent=\"0 1 0 1 0 1\" Origin=\"0 0 0\" Spacing=\"1 1 2\">\n<Piece Extent=\"0 1 0 1 0 "
      "1\">\n"
      "<PointData Scalars=\"s\"><DataArray type=\"Int16\" Name=\"s\" format=\"ascii\">1 2 3 4 5 6 7 "
      "8</DataArray>"
      "</PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
  write_file_atomically(path, good);
  QCOMPARE(field_of(path), QString("none"));
  write_file_atomically(path, replaced(good, what.toStdString(), by.toStdString()));
  QCOMPARE(field_of(path), field);
}

void LyingHeaderTest::PackedMetaImagesTellTheirSize_data() {
  QTest::addColumn<QByteArray>("size");
  for (const char* size : {"", "0", "10", "less", "more"}) QTest::newRow(size) << QByteArray(size);
}

void LyingHeaderTest::PackedMetaImagesTellTheirSize() {
  QFETCH(QByteArray, size);
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.mha";
  const std::string voxels = bytes_of(test::stored_world(0));
  const QByteArray packed = qCompress(QByteArray::fromStdString(voxels)).mid(4);  // without Qt's own length
  const auto write = [&](const std::string& said) {
    const std::string field = said.empty() ? "" : "\nCompressedDataSize = " + said;
    write_file_atomically(path, replaced(kMeta, "CompressedData = False", "CompressedData = True" + field) +
                                    packed.toStdString());
  };
  write(std::to_string(packed.size()));
  QVERIFY(test::shows_world(read_image(path, RunContext()).value()));
  write(size == "less"   ? std::to_string(packed.size() - 30)
        : size == "more" ? std::to_string(packed.size() + 1)
                         : size.toStdString());
  QCOMPARE(field_of(path), QString("CompressedDataSize"));
}

void LyingHeaderTest::NumbersAsTextAreCounted() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.nrrd";
  const std::string header = replaced(kNrrd, "encoding: raw", "encoding: ascii");
  const Image world = test::stored_world(0);
  std::string text;
  for (const std::int16_t value : *world.voxels) text += std::to_string(value) + " ";
  write_file_atomically(path, header + text);
  QVERIFY(test::shows_world(read_image(path, RunContext()).value()));
  for (const std::string& bad :
       {header + text + "7", header + text.substr(0, text.rfind(' ', text.size() - 2)), header + "a" + text,
        header + "70000" + text.substr(text.find(' ')),
        replaced(header, "sizes: 6 5 4", "sizes: 6 5 3") + text,
        replaced(header, "short", "uchar") + "-500" + text.substr(text.find(' '))}) {
    write_file_atomically(path, bad);
    QCOMPARE(field_of(path), QString("voxels"));
  }
}

void LyingHeaderTest::TheLastBytesAreReadWhereTheHeaderSaysSo() {
  const TemporaryFolder folder;
  const std::string voxels = bytes_of(test::stored_world(0)), before(25, 'h');
  write_file_atomically(folder.path() / "long.raw", before + voxels);
  write_file_atomically(folder.path() / "short.raw", voxels.substr(1));
  const auto nrrd = [&](const std::string& file) {
    const fs::path path = folder.path() / "a.nhdr";
    write_file_atomically(path, replaced(kNrrd, "\n\n", "\nbyte skip: -1\ndata file: " + file + "\n\n"));
    return path;
  };
  const auto meta = [&](const std::string& file) {
    const fs::path path = folder.path() / "a.mhd";
    write_file_atomically(path, replaced(replaced(kMeta, "LOCAL", file), "NDims", "HeaderSize = -1\nNDims"));
    return path;
  };
  QVERIFY(test::shows_world(read_image(nrrd("long.raw"), RunContext()).value()));
  QVERIFY(test::shows_world(read_image(meta("long.raw"), RunContext()).value()));
  QCOMPARE(field_of(nrrd("short.raw")), QString("voxels"));
  QCOMPARE(field_of(meta("short.raw")), QString("voxels"));
}

void LyingHeaderTest::FilesElsewhereAreNotFollowed() {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "case");
  const std::string voxels = bytes_of(test::stored_world(0));
  write_file_atomically(folder.path() / "secret.raw", voxels);
  write_file_atomically(folder.path() / "case/own.raw", voxels);
  const auto nrrd = [&](const std::string& file) {
    const fs::path path = folder.path() / "case/a.nhdr";
    write_file_atomically(path, replaced(kNrrd, "\n\n", "\ndata file: " + file + "\n\n"));
    return path;
  };
  const auto meta = [&](const std::string& file) {
    const fs::path path = folder.path() / "case/a.mhd";
    write_file_atomically(path, replaced(kMeta, "LOCAL", file));
    return path;
  };
  QVERIFY(test::shows_world(read_image(nrrd("own.raw"), RunContext()).value()));
  QVERIFY(test::shows_world(read_image(meta("own.raw"), RunContext()).value()));
  const std::string absolute = (folder.path() / "secret.raw").string();
  for (const std::string& file : {std::string("../secret.raw"), absolute}) {
    QCOMPARE(field_of(nrrd(file)), QString("data file"));
    QCOMPARE(field_of(meta(file)), QString("ElementDataFile"));
  }
}

void LyingHeaderTest::BytesPutInAreToldFromPadding_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"a.nii", "a.nrrd", "a.mha"}) QTest::newRow(name) << name;
}
void LyingHeaderTest::BytesPutInAreToldFromPadding() {
  QFETCH(QString, name);
  const TemporaryFolder folder;
  const fs::path path = folder.path() / name.toStdString();
  const std::string voxels = bytes_of(test::stored_world(0));
  write_image(path, test::stored_world(0));
  const std::string header = name == "a.nii"    ? read_file(path).substr(0, 352)
                             : name == "a.nrrd" ? kNrrd
                                                : kMeta;
  write_file_atomically(path, header + voxels + std::string(3, '\0'));
  QVERIFY(test::shows_world(read_image(path, RunContext()).value()));
  write_file_atomically(path, header + std::string(voxels).insert(voxels.size() / 2, 3, '7'));
  QCOMPARE(field_of(path), QString("size"));
}

QTEST_APPLESS_MAIN(LyingHeaderTest)
#include "lying_header_test.moc"
