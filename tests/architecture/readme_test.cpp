// SPDX-License-Identifier: GPL-3.0-or-later
// Holds the texts against the disk: every module has a README, its texts are short enough to be read and
// can be found from there, and what the texts link to exists.
#include <QTest>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

constexpr int kMostWords = 800;

fs::path source_root() { return fs::path(qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString()); }

std::string content_of(const fs::path& path) {
  std::ifstream stream(path);
  std::stringstream content;
  content << stream.rdbuf();
  return content.str();
}

std::vector<fs::path> modules() {
  std::vector<fs::path> found;
  for (const auto& room : fs::directory_iterator(source_root() / "modules"))
    if (room.is_directory()) found.push_back(room.path());
  return found;
}

/// What white space separates, as `wc -w` counts it.
int words_in(const std::string& text) {
  std::istringstream stream(text);
  int count = 0;
  for (std::string word; stream >> word;) ++count;
  return count;
}

/// Lines of a text outside its code blocks: those that are fenced, and those that are indented by four after
/// an empty line.
std::vector<std::string> prose_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  bool fenced = false, empty_before = true, indented = false;
  for (std::string line; std::getline(stream, line);) {
    const bool fence = line.rfind("```", 0) == 0;
    if (fence) fenced = !fenced;
    indented = line.rfind("    ", 0) == 0 && (empty_before || indented);
    empty_before = line.empty();
    if (!fence && !fenced && !indented) lines.push_back(line);
  }
  return lines;
}

/// The name by which a heading is linked to: lower case, spaces as hyphens, nothing but letters, digits,
/// hyphens and underscores.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char letter : heading) {
    const auto byte = static_cast<unsigned char>(letter);
    if (letter == ' ') anchor += '-';
    if (std::isalnum(byte) != 0 || letter == '-' || letter == '_' || byte >= 0x80)
      anchor += static_cast<char>(std::tolower(byte));
  }
  return anchor;
}

std::set<std::string> anchors_in(const fs::path& path) {
  static const std::regex kHeading("^#+ +(.*)$");
  std::set<std::string> anchors;
  for (const std::string& line : prose_of(content_of(path))) {
    std::smatch match;
    if (std::regex_match(line, match, kHeading)) anchors.insert(anchor_of(match[1]));
  }
  return anchors;
}

/// What Markdown links and pictures in a text lead to.
std::vector<std::string> links_in(const std::string& text) {
  static const std::regex kLink("\\]\\(([^)\\s]+)\\)");
  std::vector<std::string> links;
  for (const std::string& line : prose_of(text))
    for (std::sregex_iterator link(line.begin(), line.end(), kLink), end; link != end; ++link)
      links.push_back((*link)[1]);
  return links;
}

/// Why a link leads nowhere; empty: it leads somewhere, or out of the repository.
std::string fault_of(const fs::path& text, const std::string& link) {
  if (link.find("://") != std::string::npos) return {};
  const auto hash = link.find('#');
  const std::string file = link.substr(0, hash);
  const fs::path target = file.empty() ? text : text.parent_path() / file;
  if (!fs::exists(target)) return "no such file";
  if (hash == std::string::npos || target.extension() != ".md") return {};
  return anchors_in(target).contains(link.substr(hash + 1)) ? "" : "no such heading";
}

std::vector<fs::path> texts() {
  std::vector<fs::path> found = {source_root() / "README.md", source_root() / "CHANGELOG.md"};
  for (const char* folder : {"modules", "packaging", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(source_root() / folder))
      if (entry.path().extension() == ".md") found.push_back(entry.path());
  return found;
}

}  // namespace

class ReadmeTest : public QObject {
  Q_OBJECT
 private slots:
  void EveryModuleHasAReadme();
  void TextsOfModulesAreShort();
  void TextsOfModulesAreLedTo();
  void LinksLeadSomewhere();
  void BrokenLinksAreFound();
};

void ReadmeTest::EveryModuleHasAReadme() {
  QVERIFY2(modules().size() >= 4, "GLISSON_SOURCE_DIR must name the checkout");
  for (const fs::path& module : modules())
    QVERIFY2(words_in(content_of(module / "README.md")) > 0, module.c_str());
}

/// Its README, and what that leads to.
void ReadmeTest::TextsOfModulesAreShort() {
  std::string offences;
  for (const fs::path& module : modules())
    for (const auto& entry : fs::directory_iterator(module)) {
      if (entry.path().extension() != ".md") continue;
      const int words = words_in(content_of(entry.path()));
      if (words > kMostWords)
        offences += entry.path().string() + ": has " + std::to_string(words) + " words, more than " +
                    std::to_string(kMostWords) + "\n";
    }
  QVERIFY2(offences.empty(), ("\n" + offences).c_str());
}

/// From the README on, so that nobody has to know that a text is there.
void ReadmeTest::TextsOfModulesAreLedTo() {
  std::string offences;
  for (const fs::path& module : modules()) {
    std::set<fs::path> found = {module / "README.md"};
    for (std::size_t before = 0; before != found.size();) {
      before = found.size();
      for (const fs::path& text : std::set<fs::path>(found))
        for (const std::string& link : links_in(content_of(text)))
          if (fs::exists(module / link)) found.insert(module / link);
    }
    for (const auto& entry : fs::directory_iterator(module))
      if (entry.path().extension() == ".md" && !found.contains(entry.path()))
        offences += entry.path().string() + "\n";
  }
  QVERIFY2(offences.empty(), ("no link leads to:\n" + offences).c_str());
}

void ReadmeTest::LinksLeadSomewhere() {
  std::string offences;
  int followed = 0;
  for (const fs::path& text : texts())
    for (const std::string& link : links_in(content_of(text))) {
      const std::string fault = fault_of(text, link);
      if (!fault.empty())
        offences += fs::relative(text, source_root()).string() + ": " + link + ": " + fault + "\n";
      ++followed;
    }
  QVERIFY(followed > 20);
  QVERIFY2(offences.empty(), ("\n" + offences).c_str());
}

void ReadmeTest::BrokenLinksAreFound() {
  const fs::path manual = source_root() / "packaging/manual/manual.md";
  QCOMPARE(links_in("see [a](b.md), ![c](d.png)\n\n    [code](gone.md)\n").size(), std::size_t{2});
  QCOMPARE(QString::fromStdString(fault_of(manual, "manual.md#commands")), QString());
  QCOMPARE(QString::fromStdString(fault_of(manual, "manual.md#gone")), QString("no such heading"));
  QCOMPARE(QString::fromStdString(fault_of(manual, "gone.png")), QString("no such file"));
  QCOMPARE(QString::fromStdString(anchor_of("What the figures mean")), QString("what-the-figures-mean"));
}

QTEST_APPLESS_MAIN(ReadmeTest)
#include "readme_test.moc"
