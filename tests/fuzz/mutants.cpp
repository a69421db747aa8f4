// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_mutants COUNT [ENTRY...]: gives each reader COUNT damaged copies of its seeds, in a process apart, and
// prints a table. Blind where libFuzzer sees, but it needs nothing that is built anew: every reader, the
// whole engine's included. What ends, hangs (20 s) or fills (4 GB) the process, and what a reader takes
// although it cannot be, stays in fuzz_found/. Leaves with 1 when there is anything.
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "damage.h"
#include "entries.h"

namespace {

using namespace glisson;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostBytes = 1U << 20U;

/// What the process apart is at, seen from both.
struct Desk {
  int done;
  int faults;  ///< what a reader took although it cannot be
  double longest;
  std::size_t size;
  char bytes[kMostBytes];
};

void keep(const Desk& desk, const char* entry, const char* kind) {
  std::filesystem::create_directories("fuzz_found");
  const std::string name = std::string("fuzz_found/") + entry + "-" + kind + "-" + std::to_string(desk.done);
  std::ofstream(name, std::ios::binary).write(desk.bytes, static_cast<std::streamsize>(desk.size));
}

[[noreturn]] void read_all(Desk& desk, const fuzz::Named& named, int count) {
#if !defined(GLISSON_INSTRUMENTED)  // a sanitizer's shadow memory is larger than any limit
  const rlimit memory{4000000000UL, 4000000000UL};
  ::setrlimit(RLIMIT_AS, &memory);
#endif
  const auto seeds = fuzz::seed_files(named.name);
  for (; desk.done < count; ++desk.done) {
    std::mt19937 random(static_cast<unsigned>(desk.done));
    std::string bytes = seeds[random() % seeds.size()].second;
    for (unsigned n = 1 + random() % 3; n > 0; --n) bytes = fuzz::damaged(std::move(bytes), random);
    bytes.resize(std::min(bytes.size(), kMostBytes));
    desk.size = bytes.size();
    std::memcpy(desk.bytes, bytes.data(), bytes.size());
    const auto begin = Clock::now();
    ::alarm(20);
    try {
      named.entry(bytes);
    } catch (const std::exception& fault) {
      ++desk.faults;
      std::fprintf(stderr, "%s %d: %s\n", named.name, desk.done, fault.what());
      keep(desk, named.name, "taken");
    }
    ::alarm(0);
    desk.longest = std::max(desk.longest, std::chrono::duration<double>(Clock::now() - begin).count());
  }
  std::exit(0);  // removes the temporary folders
}

/// @return how many faults there were.
int run(const fuzz::Named& named, int count) {
  auto* desk = static_cast<Desk*>(
      ::mmap(nullptr, sizeof(Desk), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  if (desk == MAP_FAILED) return 1;
  int crashes = 0, hangs = 0;
  long kilobytes = 0;
  const auto begin = Clock::now();
  while (desk->done < count) {
    std::fflush(stdout);
    const pid_t child = ::fork();
    if (child < 0) return 1;
    if (child == 0) read_all(*desk, named, count);
    int status = 0;
    rusage used{};
    ::wait4(child, &status, 0, &used);
    kilobytes = std::max(kilobytes, used.ru_maxrss);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) break;
    const bool hung = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
    ++(hung ? hangs : crashes);
    keep(*desk, named.name, hung ? "hung" : "ended");
    ++desk->done;
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  std::printf("| %s | %d | %d | %d | %d | %.2f s | %ld MB | %.0f s |\n", named.name, count, crashes, hangs,
              desk->faults, desk->longest, kilobytes / 1024, seconds);
  const int faults = crashes + hangs + desk->faults;
  ::munmap(desk, sizeof(Desk));
  return faults;
}

}  // namespace

int main(int words, char** word) {
  if (words < 2) {
    std::fprintf(stderr, "fuzz_mutants COUNT [ENTRY...]\n");
    return 2;
  }
  std::printf(
      "| reader | damaged | ended | hung | taken though it cannot be | longest | memory | all |\n"
      "|---|---|---|---|---|---|---|---|\n");
  int faults = 0;
  for (const fuzz::Named& named : fuzz::all_entries()) {
    const bool wanted = words == 2 || std::any_of(word + 2, word + words, [&](const char* one) {
                          return std::strcmp(one, named.name) == 0;
                        });
    if (wanted) faults += run(named, std::atoi(word[1]));
  }
  return faults == 0 ? 0 : 1;
}
