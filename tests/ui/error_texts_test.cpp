// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of files and cases, as they are thrown, are known to the translators: a changed sentence is noticed
// here.
#include <QCoreApplication>
#include <QRegularExpression>
#include <QTest>
#include <QTranslator>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/failure_sentence.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/parts/keeping.h"
#include "glisson/ui/common/error_texts.h"

namespace glisson {

namespace fs = std::filesystem;

class ErrorTextsTest : public QObject {
  Q_OBJECT
 private slots:
  void ThrownErrorsAreKnown_data();
  void ThrownErrorsAreKnown();
  void OthersStayAsTheyAre();
  void NamesWithPlaceholdersStayWhole();
  void NamesDoNotGetIntoTheLog_data();
  void NamesDoNotGetIntoTheLog();
  void EveryPhraseStandsInTheModules();
  void ErrorsAreToldInGerman_data();
  void ErrorsAreToldInGerman();
};

using Throws = std::function<void(const fs::path& folder)>;

void ErrorTextsTest::ThrownErrorsAreKnown_data() {
  QTest::addColumn<Throws>("throws");
  const auto row = [](const char* name, Throws throws) { QTest::newRow(name) << throws; };
  row("no file", [](const fs::path& at) { read_file(at / "none"); });
  row("a folder", [](const fs::path& at) { read_file(at); });
  row("over a folder", [](const fs::path& at) { write_file_atomically(at, "x"); });
  row("over a device", [](const fs::path&) { write_file_atomically("/dev/full", "x"); });
  row("no folder", [](const fs::path& at) { write_file_atomically(at / "none/x", "x"); });
  row("a loop", [](const fs::path& at) {
    fs::create_symlink("loop", at / "loop");
    write_file_atomically(at / "loop", "x");
  });
  row("no temporary folder", [](const fs::path& at) { const TemporaryFolder inner(at / "none"); });
  row("no JSON", [](const fs::path& at) {
    std::ofstream(at / "bad.json") << "{";
    read_json(at / "bad.json");
  });
  row("no case", [](const fs::path& at) { engine::open_case(at / "none.glisson", RunContext()); });
  row("an empty folder", [](const fs::path& at) {
    fs::create_directory(at / "empty.glisson");
    engine::open_case(at / "empty.glisson", RunContext());
  });
  row("over something else", [](const fs::path& at) {
    fs::create_directory(at / "other.glisson");
    engine::save_case(at / "other.glisson", {}, RunContext());
  });
  row("no name of a case", [](const fs::path& at) { engine::save_case(at / "x", {}, RunContext()); });
  row("never saved", [](const fs::path&) { (void)engine::SaveCase{}.apply({}, RunContext()); });
  row("a newer case", [](const fs::path& at) {
    fs::create_directory(at / "new.glisson");
    write_json(at / "new.glisson/case.json", {{"format", "glisson-case"}, {"version", 99}, {"parts", {}}});
    engine::open_case(at / "new.glisson", RunContext());
  });
  row("held", [](const fs::path& at) {
    throw engine::held_error(at / "x.glisson", {"anna", "host", 7, "boot", "2026-11-22 06:42"});
  });
  row("not writable", [](const fs::path& at) { throw engine::held_error(at / "x.glisson", {}); });
  for (const auto code : {std::errc::permission_denied, std::errc::no_space_on_device, std::errc::io_error})
    row("the file system", [code](const fs::path& at) {
      throw FileError(sentence_of(fs::filesystem_error("status", at, std::make_error_code(code))));
    });
}

void ErrorTextsTest::ThrownErrorsAreKnown() {
  QFETCH(Throws, throws);
  const TemporaryFolder folder;
  try {
    throws(folder.path());
    QFAIL("nothing was thrown");
  } catch (const Error& failure) {
    QVERIFY2(ui::is_error_known(failure.what()), failure.what());
    // Without a translator the words are the engine's own.
    QCOMPARE(ui::error_text(failure.what()), QString::fromUtf8(failure.what()));
  }
}

void ErrorTextsTest::OthersStayAsTheyAre() {
  const char* sentence = "a.ply: vertex 12: is no fair point. Write the cloud anew.";
  QVERIFY(!ui::is_error_known(sentence));
  QCOMPARE(ui::error_text(sentence), QString::fromUtf8(sentence));
}

void ErrorTextsTest::NamesWithPlaceholdersStayWhole() {
  const char* sentence = "50%2 (a) %1.json: cannot be opened (100 %1). Check the path.";
  QVERIFY(ui::is_error_known(sentence));
  QCOMPARE(ui::error_text(sentence), QString::fromUtf8(sentence));
}

void ErrorTextsTest::NamesDoNotGetIntoTheLog_data() {
  QTest::addColumn<QString>("sentence");
  QTest::addColumn<QString>("logged");
  QTest::newRow("a file in small letters")
      << "mueller.anna.dcm: is a DICOM file that cannot be read. Export the series again."
      << "is a DICOM file that cannot be read. Export the series again";
  QTest::newRow("two files") << "mueller: anna.dcm, smith (0028|0030): stands twice. Export it again."
                             << "stands twice. Export it again";
  QTest::newRow("a name in a place")
      << "volume: holds no series mueller anna, but \"smith\". Choose one of these by its UID."
      << "holds no series _, but _. Choose one of these by its UID";
  QTest::newRow("a name in an unknown sentence")
      << "volume: looks like mueller anna, not \"smith\". Choose one of these by its UID."
      << "another error. Choose one of these by its UID";
  QTest::newRow("a person")
      << "/home/mueller anna/x.glisson: is open for writing by smith. Close it there, or save "
         "under another name. If that program runs no longer, remove mueller."
      << "_: is open for writing by _. Close it there, or save under another name. If that "
         "program runs no longer, remove _.";
  QTest::newRow("another sentence") << "mueller anna is no volume"
                                    << "another error";
  QTest::newRow("nothing") << ""
                           << "another error";
}

void ErrorTextsTest::NamesDoNotGetIntoTheLog() {
  QFETCH(QString, sentence);
  QFETCH(QString, logged);
  const QString line = QString::fromStdString(ui::logged_error(sentence.toStdString()));
  for (const char* name : {"mueller", "anna", "smith"}) QVERIFY2(!line.contains(name), qPrintable(line));
  QCOMPARE(line, logged);
}

void ErrorTextsTest::EveryPhraseStandsInTheModules() {
  // A changed sentence is noticed here. Literals that go on in the next line are one.
  QString source;
  const fs::path root = fs::path(qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString());
  for (const char* part : {"modules", "app"})
    for (const auto& entry : fs::recursive_directory_iterator(root / part))
      if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h")
        source += QString::fromStdString(read_file(entry.path()));
  QVERIFY(source.size() > 1000000);
  source.remove(QRegularExpression("\"\\s*\n\\s*\""));
  for (const char* phrase : ui::error_phrases())
    for (QString part : QString::fromUtf8(phrase).split(QRegularExpression("%\\d"))) {
      const bool is_raw = source.contains(part);  // R"(...)", or without quotes
      QVERIFY2(is_raw || source.contains(part.replace("\"", "\\\"")), phrase);
    }
}

void ErrorTextsTest::ErrorsAreToldInGerman_data() {
  QTest::addColumn<QString>("sentence");
  QTest::addColumn<QString>("german");
  const auto row = [](const Error& error, const char* german) {
    QTest::newRow(error.what()) << QString(error.what()) << QString::fromUtf8(german);
  };
  row(InputError("a.nrrd", "spacing", "is 0 x 1 x 1 mm, which is no patient's",
                 "Check that the file's unit is the millimetre and correct its header"),
      "a.nrrd: spacing: ist 0 x 1 x 1 mm, so ist kein Patient. Prüfen Sie, ob die Einheit der Datei der "
      "Millimeter ist, und berichtigen Sie den Kopf.");
  row(FileError("50%2 a: b.nii: cannot be opened (%1). Check its permissions."),
      "50%2 a: b.nii: kann nicht geöffnet werden (%1). Prüfen Sie die Rechte.");
  row(InputError("film.mkv", "", "breaks off after 3 frames of 90",
                 "Copy the video again, or record it anew"),
      "film.mkv: bricht nach 3 von 90 Bildern ab. Kopieren Sie das Video noch einmal, oder nehmen Sie es neu "
      "auf.");
  row(InputError("liver.stl", "surface", "has holes or edges with more than two triangles",
                 "Close it (fill its holes) before it is meshed"),
      "liver.stl: surface: hat Löcher oder Kanten mit mehr als zwei Dreiecken. Schließen Sie sie (füllen Sie "
      "ihre Löcher), bevor sie vernetzt wird.");
  row(Error("--vertices x: must be a number from 50 to 200000."),
      "--vertices x: muss eine Zahl von 50 bis 200000 sein.");
  row(Error("cloud.ply: must hold a number such as %02d, as in 'cloud_%02d.ply'."),
      "cloud.ply: muss eine Zahl wie %02d enthalten, wie in 'cloud_%02d.ply'.");
  // The problem is not known here: what to do is what counts.
  row(InputError("a.ply", "", "is something new", "Check the path"),
      "a.ply: is something new. Prüfen Sie den Pfad.");
}

void ErrorTextsTest::ErrorsAreToldInGerman() {
  QFETCH(QString, sentence);
  QTranslator german;
  QVERIFY(german.load(QStringLiteral(GLISSON_GERMAN)));
  QCoreApplication::installTranslator(&german);
  const QString told = ui::error_text(sentence.toStdString());
  QCoreApplication::removeTranslator(&german);
  QTEST(told, "german");
  QCOMPARE(ui::error_text(sentence.toStdString()), sentence);
}

}  // namespace glisson

QTEST_GUILESS_MAIN(glisson::ErrorTextsTest)
#include "error_texts_test.moc"
