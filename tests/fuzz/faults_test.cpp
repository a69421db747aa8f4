// SPDX-License-Identifier: GPL-3.0-or-later
// Files of the shape of those that once ended the program, hung it, or were read as what they are not. Each
// is made here, by a change to a good one.
#include <QTest>
#include <chrono>

#include "entries.h"
#include "glisson/core/error.h"

using namespace glisson;

class FaultsTest : public QObject {
  Q_OBJECT
 private slots:
  void GoodFilesAreRead_data() { entries(); }
  void GoodFilesAreRead();
  void FoundFaultsStayMended_data();
  void FoundFaultsStayMended();
  void CutFilesDoNoHarm_data() { entries(); }
  void CutFilesDoNoHarm();

 private:
  static void entries() {
    QTest::addColumn<QString>("entry");
    for (const fuzz::Named& one : fuzz::all_entries()) QTest::newRow(one.name) << one.name;
  }
};

namespace {

fuzz::Entry entry_named(const QString& name) {
  for (const fuzz::Named& one : fuzz::all_entries())
    if (name == one.name) return one.entry;
  throw PreconditionError("no such entry");
}

QByteArray seed(const char* entry, int number = 0) {
  return QByteArray::fromStdString(fuzz::seed_files(entry).at(static_cast<std::size_t>(number)).second);
}

/// The good file with its first `what` replaced.
QByteArray changed(const char* entry, const QByteArray& what, const QByteArray& by, int number = 0) {
  QByteArray bytes = seed(entry, number);
  const auto at = bytes.indexOf(what);
  if (at < 0) throw PreconditionError("the text to be changed is not there");
  return bytes.replace(at, what.size(), by);
}

}  // namespace

void FaultsTest::GoodFilesAreRead() {
  QFETCH(QString, entry);
  for (const auto& [name, bytes] : fuzz::seed_files(entry.toStdString())) entry_named(entry)(bytes);
}

void FaultsTest::FoundFaultsStayMended_data() {
  QTest::addColumn<QString>("entry");
  QTest::addColumn<QByteArray>("bytes");
  const auto row = [](const char* entry, const char* what, const QByteArray& bytes) {
    QTest::addRow("%s: %s", entry, what) << QString(entry) << bytes;
  };
  // Ended the program in VTK's XML readers.
  row("vtk_xml", "a negative count", changed("vtk_xml", "NumberOfPoints=\"5\"", "NumberOfPoints=\"-5\""));
  row("vessels", "a negative count", changed("vessels", "NumberOfPoints=\"6\"", "NumberOfPoints=\"-6\""));
  row("vtk_xml", "a flipped bit in the header's type", changed("vtk_xml", "\"UInt32\"", "\"UInt64\""));
  row("vtk_xml", "a flipped bit in an array's type",
      changed("vtk_xml", "type=\"Float64\"", "type=\"Float32\""));
  row("vtk_xml", "a flipped bit in the order of bytes", changed("vtk_xml", "LittleEndian", "BigEndian"));
  // Hung for minutes.
  row("vtk_xml", "components without end",
      changed("vtk_xml", "NumberOfComponents=\"3\"", "NumberOfComponents=\"99999999999\""));
  // Wrote beyond its vertices.
  row("ply", "a property twice", changed("ply", "property double z", "property double x"));
  row("ply", "an element twice",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nelement vertex 1\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n0 0 0\n");
  // Numbers that nlohmann's parser lets out as another error.
  row("seeds", "a number larger than any", "{\"liver\": [[1e999, 0, 0]]}");
  row("regions", "a number larger than any", "{\"regions\": [{\"polygon\": [[1e999, 0]]}]}");
  row("landmarks", "a place outside the world", "{\"umbilical_notch\": [[1e300, 0, 0]]}");
  // Fields of another kind than they are taken for.
  row("landmarks", "a frame that is a number", "{\"frame\": 7, \"umbilical_notch\": [[1, 0, 0]]}");
  row("tree_edits", "a unit that is a list", "{\"unit\": [], \"edits\": []}");
  // Nested as deep as the file is long.
  for (const char* entry : {"seeds", "regions", "source", "label_codes", "edits", "tree_edits", "landmarks",
                            "moment", "case_json"})
    row(entry, "nested brackets", QByteArray(100000, '['));
  // Closed, and where a value is copied or told.
  const QByteArray closed = QByteArray(300000, '[') + "1" + QByteArray(300000, ']');
  row("case_json", "a deep value", "{\"format\": \"glisson-case\", \"files\": {\"x\": " + closed + "}}");
  row("edits", "a deep value", "{\"edits\": [{\"tool\": \"brush\", \"radius_mm\": " + closed + "}]}");
  row("label_codes", "a deep value", "{\"1\": " + closed + "}");
  row("calibration", "nested brackets", "%YAML:1.0\n---\na: " + QByteArray(50000, '['));
  row("calibration", "nested JSON", "{\"a\": " + QByteArray(50000, '['));
  row("vtk_xml", "nested elements", "<VTKFile type=\"PolyData\">" + QByteArray("<a>").repeated(50000));
}

void FaultsTest::FoundFaultsStayMended() {
  QFETCH(QString, entry);
  QFETCH(QByteArray, bytes);
  const auto begin = std::chrono::steady_clock::now();
  entry_named(entry)(bytes.toStdString());
  QVERIFY(std::chrono::steady_clock::now() - begin < std::chrono::seconds(20));
}

void FaultsTest::CutFilesDoNoHarm() {
  QFETCH(QString, entry);
  for (const auto& [name, bytes] : fuzz::seed_files(entry.toStdString()))
    for (int part = 0; part < 20; ++part)
      entry_named(entry)(bytes.substr(0, bytes.size() * static_cast<std::size_t>(part) / 20));
}

QTEST_APPLESS_MAIN(FaultsTest)
#include "faults_test.moc"
