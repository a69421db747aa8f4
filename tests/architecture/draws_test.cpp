// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers are the same by every compiler: no argument list holds two draws. Its order is the
// compiler's, and GCC and Clang draw in opposite ones. Braces have an order, from left to right.
#include <QTest>

#include "house.h"

using namespace glisson::house;
namespace fs = std::filesystem;

namespace {

/// One that is open while code is read.
struct Brackets {
  char kind = '(';
  std::size_t begin = 0;
  std::vector<std::size_t> ends;  ///< of its arguments so far, without the last
};

bool draws(const std::string& argument) {
  // A number, or a function that draws from what it is given.
  static const std::regex kDraw(
      "\\w\\((random_?|\\*?random)\\)|\\brandom_?\\(\\)|\\b(hand|dice)_?\\.\\w+\\(|"
      "\\b(uniform|between)\\(|[(,]\\s*(hand|dice|random)_?\\)");
  return std::regex_search(argument, kDraw);
}

/// Argument lists with two draws, each as it stands in the code.
std::vector<std::string> lists_with_two_draws(const std::string& code) {
  std::vector<std::string> found;
  std::vector<Brackets> open;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    if (c == '(' || c == '[' || c == '{') open.push_back({c, i, {}});
    if (open.empty()) continue;
    if (c == ',') open.back().ends.push_back(i);
    if (c != ')' && c != ']' && c != '}') continue;
    Brackets list = open.back();
    open.pop_back();
    if (list.kind != '(') continue;
    list.ends.push_back(i);
    std::size_t begin = list.begin + 1, drawing = 0;
    for (const std::size_t end : list.ends) {
      drawing += draws(code.substr(begin, end - begin)) ? 1 : 0;
      begin = end + 1;
    }
    if (drawing > 1) found.push_back(code.substr(list.begin, i + 1 - list.begin));
  }
  return found;
}

}  // namespace

class DrawsTest : public QObject {
  Q_OBJECT

 private slots:
  void FindsThem_data();
  void FindsThem();
  void NoArgumentListHoldsTwo();
};

void DrawsTest::FindsThem_data() {
  QTest::addColumn<QString>("code");
  QTest::addColumn<int>("lists");
  QTest::newRow("two coordinates") << "Vector2d(normal(random), normal(random))" << 1;
  QTest::newRow("inside of others") << "f(1, Vector2d(2.0 * normal(random_), 1.0 + random_() % 3), g(x))"
                                    << 1;
  QTest::newRow("in two lists of one") << "f(g(normal(random)), g(normal(random)))" << 1;
  QTest::newRow("a lambda's") << "Vector2d(uniform(), 0.3 * uniform())" << 1;
  QTest::newRow("handed on") << "take(v, 2.0 * hand.uniform(), askew(n, 0.5, hand))" << 1;
  QTest::newRow("braces have an order") << "Vector2d{normal(random), normal(random)}" << 0;
  QTest::newRow("statements have one") << "const double x = normal(random), y = normal(random);" << 0;
  QTest::newRow("one draw and its generator's declaration")
      << "f(std::mt19937_64& random) { g(a, normal(random)); }" << 0;
}

void DrawsTest::FindsThem() {
  QFETCH(QString, code);
  QTEST(static_cast<int>(lists_with_two_draws(code.toStdString()).size()), "lists");
}

void DrawsTest::NoArgumentListHoldsTwo() {
  for (const char* folder : {"modules", "app", "ui", "tests"})
    for (const fs::path& source : sources_below(source_root() / folder))
      for (const std::string& list : lists_with_two_draws(code_of(source)))
        QFAIL(qPrintable(QString::fromStdString(fs::relative(source, source_root()).string() + ": " + list)));
}

QTEST_APPLESS_MAIN(DrawsTest)
#include "draws_test.moc"
