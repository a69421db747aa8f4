// SPDX-License-Identifier: GPL-3.0-or-later
// The other way round than error_texts_test: what the sources throw is known to the translators, so that no
// error is told half in one language and half in another.
#include <QTest>

#include <filesystem>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/ui/common/error_texts.h"
#include "thrown_helpers.h"

namespace glisson {

namespace fs = std::filesystem;

namespace {

/// Rooms whose errors only developers see.
bool is_internal(const std::string& file) {
  return file.starts_with("modules/insilico/") || file.starts_with("modules/experiments/");
}

/// A bare value: its field and the remedy say what it is.
bool is_bare(const QString& problem) {
  return problem == QLatin1String("is 7") || problem == QLatin1String("is not 7") ||
         problem == QLatin1String("are 7");
}

/// Whether the translators know all of a sentence.
bool is_known(const std::string& sentence, bool has_remedy) {
  const std::string logged = ui::logged_error(sentence);
  return !logged.starts_with("another error") &&
         (!has_remedy || logged.find(". ") != std::string::npos || logged.ends_with('.'));
}

/// What of an InputError is not known.
QStringList unknown_of_input(const QStringList& arguments) {
  const QStringList fields = thrown::texts_of(arguments[1]);
  const std::string field = fields.front().isEmpty() ? "" : fields.front().toStdString();
  QStringList unknown;
  for (const QString& problem : thrown::texts_of(arguments[2])) {
    if (problem == thrown::kValue || is_bare(problem)) continue;
    // Some are known with their remedy only.
    const QString remedy = thrown::texts_of(arguments[3]).front();
    const InputError error("file", field, problem.toStdString(), remedy.toStdString());
    const InputError with_another("file", field, problem.toStdString(), "Check the path");
    if (!is_known(error.what(), false) && !is_known(with_another.what(), false)) unknown << problem;
  }
  for (const QString& remedy : thrown::texts_of(arguments[3])) {
    if (remedy == thrown::kValue || remedy.isEmpty()) continue;
    const InputError error("file", field, thrown::texts_of(arguments[2]).front().toStdString(),
                           remedy.toStdString());
    const InputError with_another("file", "", "is missing", remedy.toStdString());
    if (!is_known(error.what(), true) && !is_known(with_another.what(), true)) unknown << remedy;
  }
  return unknown;
}

/// What of a FileError or UsageError is not known.
QStringList unknown_of_sentence(const QString& argument) {
  QStringList unknown;
  if (argument.contains(QLatin1String("::tr("))) return unknown;  // told in the person's language already
  for (const QString& sentence : thrown::texts_of(argument)) {
    if (sentence.startsWith(thrown::kValue + ". See ")) continue;  // Qt's own words on options
    const bool has_remedy = sentence.contains(QLatin1String(". "));
    if (sentence != thrown::kValue && !is_known(sentence.toStdString(), has_remedy)) unknown << sentence;
  }
  return unknown;
}

QStringList unknown_in(const thrown::Call& call) {
  const bool is_input = call.name == QLatin1String("InputError");
  if (is_input && call.arguments.size() == 4) return unknown_of_input(call.arguments);
  return !is_input && call.arguments.size() == 1 ? unknown_of_sentence(call.arguments[0]) : QStringList();
}

}  // namespace

class ErrorSourcesTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatIsThrownIsKnown();
  void SourcesAreReadAsTheCompilerDoes();
  void UnknownOnesAreFound();
  void HelpersAreSeenThrough_data();
  void HelpersAreSeenThrough();
  void HelpersOfOthersAreNotTaken();
};

void ErrorSourcesTest::WhatIsThrownIsKnown() {
  const fs::path root = qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString();
  thrown::Sources sources;
  for (const char* part : {"modules", "app"})
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      const std::string file = fs::relative(entry.path(), root).generic_string();
      const bool is_source = entry.path().extension() == ".cpp" || entry.path().extension() == ".h";
      if (is_source && !is_internal(file))
        sources.add(QString::fromStdString(file), QString::fromStdString(read_file(entry.path())));
    }
  sources.find_helpers();
  QString offences;
  int direct = 0, through_helpers = 0;
  std::set<QString> seen;  // the same is asked once
  for (const QString& path : sources.paths())
    for (const thrown::Call& call : sources.throws_in(path)) {
      ++(call.is_through_helper ? through_helpers : direct);
      if (!seen.insert(call.arguments.join(QLatin1Char(','))).second) continue;
      for (const QString& text : unknown_in(call)) offences += path + ": " + text + '\n';
    }
  QVERIFY2(direct > 500, qPrintable(QString::number(direct)));
  QVERIFY2(through_helpers > 500, qPrintable(QString::number(through_helpers)));
  QVERIFY2(offences.isEmpty(),
           qPrintable("not in the tables of ui/common/src/error_phrases*.cpp:\n" + offences));
}

void ErrorSourcesTest::SourcesAreReadAsTheCompilerDoes() {
  const QString code = thrown::plain(
      "throw InputError(a, \"b, (\", n > 1 ? \"holds \" + text(n, 2) + \" of it\" : std::string(\"is "
      "\\\"x\\\"\"), // no\n"
      "  R\"(Write {\"a\": \\d})\" \"; or\"\n   \" not\");");
  const auto calls = thrown::calls_in(code, QStringLiteral("InputError"));
  QCOMPARE(calls.size(), std::size_t{1});
  QCOMPARE(calls[0].arguments.size(), 4);
  QCOMPARE(thrown::texts_of(calls[0].arguments[0]), QStringList{QStringLiteral("7")});
  QCOMPARE(thrown::texts_of(calls[0].arguments[1]), QStringList{QStringLiteral("b, (")});
  QCOMPARE(thrown::texts_of(calls[0].arguments[2]),
           (QStringList{QStringLiteral("holds 7 of it"), QStringLiteral("is \"x\"")}));
}

void ErrorSourcesTest::UnknownOnesAreFound() {
  const auto unknown = [](const char* source) {
    const QString code = thrown::plain(QString::fromUtf8(source));
    return unknown_in(thrown::calls_in(code, QStringLiteral("InputError|FileError|UsageError")).at(0));
  };
  QCOMPARE(unknown("InputError(f, \"\", \"is missing\", \"Check the path\")"), QStringList());
  QCOMPARE(unknown("InputError(f, g, \"is a marvel\", \"Check the path\")"),
           QStringList{QStringLiteral("is a marvel")});
  QCOMPARE(unknown("InputError(f, g, \"is missing\", \"Wonder at it\")"),
           QStringList{QStringLiteral("Wonder at it")});
  QCOMPARE(unknown("FileError(f + \": cannot be opened (\" + why + \"). Check the path.\")"), QStringList());
  QCOMPARE(unknown("FileError(f + \": cannot be opened (\" + why + \"). Wonder at it.\")").size(), 1);
  QCOMPARE(unknown("UsageError(\"--x: is a marvel.\")").size(), 1);
}

namespace {

/// What is not known in the last of some sources.
QStringList unknown_in_last(const std::vector<std::pair<const char*, const char*>>& files) {
  thrown::Sources sources;
  for (const auto& [path, source] : files) sources.add(QLatin1String(path), QString::fromUtf8(source));
  sources.find_helpers();
  QStringList unknown;
  for (const thrown::Call& call : sources.throws_in(QLatin1String(files.back().first)))
    if (call.is_through_helper) unknown << unknown_in(call);
  return unknown;
}

}  // namespace

void ErrorSourcesTest::HelpersAreSeenThrough_data() {
  QTest::addColumn<QString>("source");
  QTest::newRow("a function") << R"(
    [[noreturn]] void refuse(const std::string& file, const char* problem) {
      throw InputError(file, "", problem, "Check the path");
    }
    void read() { if (a < b) refuse(name, "is missing"); else refuse(name, n > 1 ? "is a marvel" : "is empty"); })";
  QTest::newRow("a member with a remedy of its own") << R"(
    class File {
      void refuse(const std::string& problem, const std::string& remedy = kExport) const {
        throw InputError(name_, "", problem, remedy);
      }
      int read() const { file.refuse("is missing"); this->refuse("is a marvel", "Check the path"); }
      static constexpr const char* kExport = "Check the path";
    };)";
  QTest::newRow("a lambda") << R"(
    int read(const std::map<std::string, int>& all) {
      const auto fail = [&](const std::string& problem) -> void { throw FileError(f + ": " + problem + ". Check the path."); };
      fail("is a marvel");
    })";
  QTest::newRow("a helper of a helper") << R"(
    void fail(const std::string& problem, const std::string& remedy) { throw InputError(f, g, problem, remedy); }
    void fail(const std::string& problem) { fail(problem, "Check the path"); }
    void read() { fail("is a marvel"); })";
  QTest::newRow("values that are called") << R"(
    struct Refusal {
      void operator()(const char* field, const std::string& problem) const { throw InputError(f, field, problem, remedy); }
    };
    constexpr Refusal refuse{"Check the path"};
    void read() { refuse("size", "is a marvel"); })";
}

void ErrorSourcesTest::HelpersAreSeenThrough() {
  QFETCH(QString, source);
  const QByteArray text = source.toUtf8();
  const QStringList unknown = unknown_in_last({{"modules/a/src/a.cpp", text.constData()}});
  QCOMPARE(unknown.size(), 1);
  QVERIFY2(unknown[0].contains(QLatin1String("is a marvel")), qPrintable(unknown[0]));
}

void ErrorSourcesTest::HelpersOfOthersAreNotTaken() {
  const char* header =
      "class A { [[noreturn]] void fail(const char* problem, const char* remedy = \"\") const; };";
  const char* body =
      "#include \"a.h\"\n"
      "void A::fail(const char* problem, const char* remedy) const { throw InputError(f, g, problem, "
      "remedy); }";
  const std::pair<const char*, const char*> a{"modules/a/src/a.h", header}, b{"modules/a/src/a.cpp", body};
  const char* caller = "#include \"a.h\"\nvoid read(A& a) { a.fail(\"is a marvel\"); }";
  QCOMPARE(unknown_in_last({a, b, {"modules/a/src/c.cpp", caller}}).size(), 1);
  QCOMPARE(unknown_in_last({a, b, {"modules/b/src/c.cpp", caller}}), QStringList());
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::ErrorSourcesTest)
#include "error_sources_test.moc"
