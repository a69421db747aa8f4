// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's XML files by our own parser: every dialect that VTK writes, by VTK itself, and what no file may do to
// us.
#include "glisson/geometry/vtk_xml_file.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <QTest>
#include <random>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "mutant.h"

using namespace glisson;

class VtkXmlTest : public QObject {
  Q_OBJECT
 private slots:
  void EveryDialectOfVtkIsRead_data();
  void EveryDialectOfVtkIsRead();
  void CellsOfPolygonsKeepTheirData();
  void PiecesAreJoined();
  void WhatCannotBeIsRefused_data();
  void WhatCannotBeIsRefused();
  void SmallFilesDoNotBecomeLarge();
  void ZerosDoNotBecomeCells();
  void MutantsAreReadOrRefused_data();
  void MutantsAreReadOrRefused();
};

namespace {

/// Two tetrahedra and a triangle, arrays of several widths and types.
vtkNew<vtkUnstructuredGrid> grid() {
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::mt19937 random(3);
  for (int n = 0; n < 500; ++n) points->InsertNextPoint(1e-3 * (random() % 100000), n, -0.1234567890123 * n);
  grid->SetPoints(points);
  for (vtkIdType n = 0; n + 3 < 500; ++n) {
    const vtkIdType corners[] = {n, n + 1, n + 2, n + 3};
    grid->InsertNextCell(n % 5 == 0 ? VTK_TRIANGLE : VTK_TETRA, n % 5 == 0 ? 3 : 4, corners);
  }
  vtkNew<vtkFloatArray> shift;
  shift->SetName("shift_mm");
  shift->SetNumberOfComponents(3);
  for (int n = 0; n < 1500; ++n) shift->InsertNextValue(0.25F * static_cast<float>(n));
  grid->GetPointData()->AddArray(shift);
  vtkNew<vtkIntArray> label;
  label->SetName("label");
  for (int n = 0; n < 497; ++n) label->InsertNextValue(n % 17 - 3);
  grid->GetCellData()->AddArray(label);
  vtkNew<vtkDoubleArray> matrix;
  matrix->SetName("matrix");
  matrix->SetNumberOfComponents(4);
  for (int n = 0; n < 16; ++n) matrix->InsertNextValue(n / 3.0);
  grid->GetFieldData()->AddArray(matrix);
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->InsertNextValue("left out");
  grid->GetFieldData()->AddArray(words);
  return grid;
}

const std::string kTwo =
    "<?xml version=\"1.0\"?>\n<!-- made by hand -->\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
    "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n<Points><DataArray type=\"Float64\" "
    "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>\n"
    "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3</DataArray>"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4</DataArray>"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10</DataArray></Cells>\n"
    "<CellData><DataArray type=\"Int32\" Name=\"label\" format=\"ascii\">7<InformationKey name=\"a\">x"
    "</InformationKey></DataArray></CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw PreconditionError("the text to be changed is not there: " + what);
  return text.replace(at, what.size(), by);
}

}  // namespace

void VtkXmlTest::EveryDialectOfVtkIsRead_data() {
  QTest::addColumn<int>("mode");
  QTest::addColumn<bool>("packed");
  QTest::addColumn<bool>("big");
  QTest::addColumn<bool>("wide");
  QTest::addColumn<bool>("raw");
  for (const bool packed : {false, true})
    for (const bool big : {false, true})
      for (const bool wide : {false, true})
        for (const bool raw : {false, true})
          for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
            QTest::addRow("mode %d packed %d big %d wide %d raw %d", mode, packed, big, wide, raw)
                << mode << packed << big << wide << raw;
}
void VtkXmlTest::EveryDialectOfVtkIsRead() {
  QFETCH(int, mode);
  QFETCH(bool, packed);
  QFETCH(bool, big);
  QFETCH(bool, wide);
  QFETCH(bool, raw);
  const vtkNew<vtkUnstructuredGrid> truth = grid();
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(truth);
  writer->SetDataMode(mode);
  writer->SetCompressorType(packed ? vtkXMLWriter::ZLIB : vtkXMLWriter::NONE);
  if (packed) writer->SetBlockSize(1024);
  writer->SetByteOrder(big ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
  writer->SetHeaderType(wide ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
  writer->SetEncodeAppendedData(!raw);
  writer->WriteToOutputStringOn();
  QCOMPARE(writer->Write(), 1);

  const VtkXmlFile file = parse_vtk_xml(writer->GetOutputString(), "grid.vtu");
  QCOMPARE(file.points.rows(), Eigen::Index(500));
  for (vtkIdType n = 0; n < 500; ++n) {
    const Eigen::Vector3d point(truth->GetPoint(n));
    QVERIFY((file.points.row(n).transpose() - point).norm() <= (mode == vtkXMLWriter::Ascii ? 1e-9 : 0.0));
  }
  QCOMPARE(file.cells.size(), std::size_t(497));
  for (std::size_t c = 0; c < 497; ++c) {
    QCOMPARE(file.cell_types[c], truth->GetCellType(static_cast<vtkIdType>(c)));
    QCOMPARE(file.cells[c].size(), std::size_t(c % 5 == 0 ? 3 : 4));
    QCOMPARE(file.cells[c][2], static_cast<long>(c) + 2);
  }
  QCOMPARE(file.point_data.at("shift_mm").cols(), Eigen::Index(3));
  QCOMPARE(file.point_data.at("shift_mm")(499, 2), 0.25 * 1499);
  QCOMPARE(file.cell_data.at("label")(496, 0), 496 % 17 - 3.0);
  QCOMPARE(file.field_data.at("matrix").rows(), Eigen::Index(4));
  QVERIFY(std::abs(file.field_data.at("matrix")(3, 2) - 14 / 3.0) < 1e-9);
  QVERIFY(!file.field_data.contains("words"));
}

void VtkXmlTest::CellsOfPolygonsKeepTheirData() {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  for (int n = 0; n < 6; ++n) points->InsertNextPoint(n, n % 2, 0);
  data->SetPoints(points);
  const vtkIdType corners[] = {0, 1, 2, 3, 4};
  vtkNew<vtkCellArray> verts, lines, polys, strips;
  verts->InsertNextCell(1, corners);
  lines->InsertNextCell(2, corners);
  lines->InsertNextCell(3, corners);
  polys->InsertNextCell(5, corners);
  strips->InsertNextCell(4, corners);
  data->SetVerts(verts);
  data->SetLines(lines);
  data->SetPolys(polys);
  data->SetStrips(strips);
  vtkNew<vtkIntArray> number;
  number->SetName("number");
  for (int n = 0; n < 5; ++n) number->InsertNextValue(n);
  data->GetCellData()->AddArray(number);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  QCOMPARE(writer->Write(), 1);
  const VtkXmlFile file = parse_vtk_xml(writer->GetOutputString(), "a.vtp");
  QCOMPARE(file.cells.size(), std::size_t(5));
  const std::vector<std::size_t> sizes = {1, 2, 3, 5, 4};
  for (std::size_t c = 0; c < 5; ++c) {
    QCOMPARE(file.cells[c].size(), sizes[c]);
    QCOMPARE(file.cell_data.at("number")(static_cast<Eigen::Index>(c), 0), static_cast<double>(c));
  }
}

void VtkXmlTest::PiecesAreJoined() {
  const std::size_t begin = kTwo.find("<Piece"), end = kTwo.find("</UnstructuredGrid>");
  const std::string twice = std::string(kTwo).insert(end, kTwo.substr(begin, end - begin));
  const VtkXmlFile file = parse_vtk_xml(twice, "a.vtu");
  QCOMPARE(file.points.rows(), Eigen::Index(8));
  QCOMPARE(file.cells[1], (std::vector<long>{4, 5, 6, 7}));
  const std::string named = replaced(kTwo, "Name=\"label\"", "Name='a &lt;b&gt; &amp;amp; &quot;c&quot;'");
  QVERIFY(parse_vtk_xml(named, "a.vtu").cell_data.contains("a <b> &amp; \"c\""));
  QCOMPARE(file.cell_data.at("label").rows(), Eigen::Index(2));
}

void VtkXmlTest::WhatCannotBeIsRefused_data() {
  QTest::addColumn<QByteArray>("what");
  QTest::addColumn<QByteArray>("by");
  QTest::addColumn<QByteArray>("field");
  const auto row = [](const char* name, const char* what, const char* by, const char* field) {
    QTest::newRow(name) << QByteArray(what) << QByteArray(by) << QByteArray(field);
  };
  row("a negative count of points", "NumberOfPoints=\"4\"", "NumberOfPoints=\"-5\"", "NumberOfPoints");
  row("too many points", "NumberOfPoints=\"4\"", "NumberOfPoints=\"2000000000\"", "NumberOfPoints");
  row("points that the file does not hold", "NumberOfPoints=\"4\"", "NumberOfPoints=\"4000000\"", "Points");
  row("too many cells", "NumberOfCells=\"1\"", "NumberOfCells=\"6000000\"", "NumberOfCells");
  row("a cell without points", ">4<", ">0<", "Cells, cell 0");
  row("more offsets than cells", ">4<", ">4 4<", "Cells");
  row("components without end", "Name=\"label\"", "Name=\"label\" NumberOfComponents=\"99999999999\"",
      "NumberOfComponents");
  row("many components", "Name=\"label\"", "Name=\"label\" NumberOfComponents=\"2000000000\"", "label");
  row("no count of cells", "NumberOfCells=\"1\"", "NumberOfCells=\"one\"", "NumberOfCells");
  row("a point that is not there", ">0 1 2 3<", ">0 1 2 4<", "Cells, cell 0");
  row("a negative point", ">0 1 2 3<", ">0 1 2 -1<", "connectivity");
  row("half a point", ">0 1 2 3<", ">0 1 2 2.5<", "connectivity");
  row("offsets out of range", ">4<", ">400<", "Cells, cell 0");
  row("points that are words", "0 0 0 1", "a b c d", "Points");
  row("an unknown type", "type=\"Float64\"", "type=\"Float128\"", "Points");
  row("another kind", "\"UnstructuredGrid\"", "\"ImageData\"", "type");
  row("an unknown packer", "header_type=\"UInt64\"", "compressor=\"vtkLZMADataCompressor\"", "compressor");
  row("a document type", "<?xml version=\"1.0\"?>",
      "<!DOCTYPE a [<!ENTITY b SYSTEM \"file:///etc/passwd\">]>", "line 1");
  row("an entity", "Name=\"label\"", "Name=\"&b;\"", "line 8");
  row("a tag that does not end", "</CellData>", "</CellData", "line 9");
  row("elements that are crossed", "</CellData>", "</PointData>", "line 8");
  row("no end", "</VTKFile>", "", "line 12");
  row("data elsewhere", "format=\"ascii\">7", "format=\"appended\" offset=\"999\">7", "label");
  row("no base64", "format=\"ascii\">7", "format=\"binary\">!", "label");
}
void VtkXmlTest::WhatCannotBeIsRefused() {
  QFETCH(QByteArray, what);
  QFETCH(QByteArray, by);
  QFETCH(QByteArray, field);
  QCOMPARE(parse_vtk_xml(kTwo, "a.vtu").cell_data.at("label")(0, 0), 7.0);
  const std::string bad = replaced(kTwo, what.toStdString(), by.toStdString());
  QCOMPARE(test::refused_field([&] { (void)parse_vtk_xml(bad, "a.vtu"); }), field.toStdString());
}

void VtkXmlTest::SmallFilesDoNotBecomeLarge() {
  // A thousand arrays that all name the same bytes.
  std::string data(2000000, '\0');
  const auto size = static_cast<std::uint32_t>(data.size());
  std::string text = "<VTKFile type=\"PolyData\"><PolyData><FieldData>";
  for (int n = 0; n < 1000; ++n)
    text +=
        "<DataArray type=\"UInt8\" Name=\"a" + std::to_string(n) + "\" format=\"appended\" offset=\"0\"/>";
  text += "</FieldData><Piece/></PolyData><AppendedData encoding=\"raw\">_" +
          std::string(reinterpret_cast<const char*>(&size), 4) + data + "</AppendedData></VTKFile>";
  const std::string told = test::complaint([&] { (void)parse_vtk_xml(text, "a.vtp"); });
  QVERIFY2(told.find("more than a mesh does") != std::string::npos, told.c_str());
}

void VtkXmlTest::ZerosDoNotBecomeCells() {
  // 16 MB of zeros in some 16 kB, as offsets of as many cells: refused before they are unpacked.
  constexpr int kBlock = 1 << 20, kBlocks = 16;
  const QByteArray packed = qCompress(QByteArray(kBlock, '\0'), 9).mid(4);
  std::string head;
  for (const long word : {long(kBlocks), long(kBlock), 0L})
    head.append(reinterpret_cast<const char*>(&word), 4);
  for (int n = 0; n < kBlocks; ++n) {
    const auto size = static_cast<std::uint32_t>(packed.size());
    head.append(reinterpret_cast<const char*>(&size), 4);
  }
  std::string data = head;
  for (int n = 0; n < kBlocks; ++n) data += packed.toStdString();
  for (const char* count : {"16777216", "4000000"}) {
    const std::string text =
        "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" "
        "compressor=\"vtkZLibDataCompressor\"><PolyData>"
        "<Piece NumberOfPoints=\"1\" NumberOfPolys=\"" +
        std::string(count) +
        "\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 "
        "0</DataArray></Points>"
        "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 0 0</DataArray>"
        "<DataArray type=\"UInt8\" Name=\"offsets\" format=\"appended\" "
        "offset=\"0\"/></Polys></Piece></PolyData>"
        "<AppendedData encoding=\"raw\">_" +
        data + "</AppendedData></VTKFile>";
    const std::string field = test::refused_field([&] { (void)parse_vtk_xml(text, "a.vtp"); });
    QCOMPARE(field, std::string(count[0] == '1' ? "NumberOfCells" : "offsets"));
  }
}

void VtkXmlTest::MutantsAreReadOrRefused_data() {
  QTest::addColumn<int>("mode");
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
    QTest::addRow("%d", mode) << mode;
}
void VtkXmlTest::MutantsAreReadOrRefused() {
  QFETCH(int, mode);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid());
  writer->SetDataMode(mode);
  writer->WriteToOutputStringOn();
  QCOMPARE(writer->Write(), 1);
  const std::string good = writer->GetOutputString();
  std::mt19937 random(11);
  int refused = 0;
  for (int n = 0; n < 120; ++n) {
    const std::string bad = test::mutant_of(good, random, 40);
    try {
      const VtkXmlFile file = parse_vtk_xml(bad, "a.vtu");
      for (const std::vector<long>& cell : file.cells)
        for (const long point : cell) QVERIFY(point >= 0 && point < file.points.rows());
    } catch (const InputError& error) {
      QVERIFY(!error.remedy().empty());
      ++refused;
    }
  }
  QVERIFY(refused > 60);
}

QTEST_APPLESS_MAIN(VtkXmlTest)
#include "vtk_xml_test.moc"
