// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/confinement.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>

namespace glisson {
namespace fs = std::filesystem;
namespace {

// linux/landlock.h, which older systems do not have.
struct LandlockRuleset {
  std::uint64_t handled_access_fs;
};
struct LandlockPath {
  std::uint64_t allowed_access;
  std::int32_t parent_fd;
} __attribute__((packed));
constexpr long kCreateRuleset = 444, kAddRule = 445, kRestrictSelf = 446;
constexpr std::uint64_t kExecute = 1U << 0, kWriteFile = 1U << 1, kReadFile = 1U << 2, kReadFolder = 1U << 3;
constexpr std::uint64_t kAllVersion1 = (1U << 13) - 1, kRefer = 1U << 13, kTruncate = 1U << 14;

bool allow(int ruleset, const fs::path& path, std::uint64_t access) {
  const int at = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (at < 0) return errno == ENOENT;
  std::error_code failure;
  // Rights of folders cannot be given to a file.
  if (!fs::is_directory(path, failure)) access &= kExecute | kWriteFile | kReadFile | kTruncate;
  const LandlockPath rule{access, at};
  const long result = ::syscall(kAddRule, ruleset, 1, &rule, 0);
  ::close(at);
  return result == 0;
}

/// 0 and less: none.
long landlock_version() { return ::syscall(kCreateRuleset, nullptr, 0, 1); }

bool confine_files(const std::vector<fs::path>& readable, const std::vector<fs::path>& writable) {
  const long version = landlock_version();
  if (version < 1) return false;
  const std::uint64_t handled = kAllVersion1 | (version >= 2 ? kRefer : 0) | (version >= 3 ? kTruncate : 0);
  const LandlockRuleset rules{handled};
  const auto ruleset = static_cast<int>(::syscall(kCreateRuleset, &rules, sizeof rules, 0));
  if (ruleset < 0) return false;
  bool good = true;
  for (const char* folder : {"/usr", "/lib", "/lib64"})
    good = allow(ruleset, folder, kReadFile | kReadFolder | kExecute) && good;
  for (const fs::path& path : readable) good = allow(ruleset, path, kReadFile | kReadFolder) && good;
  for (const fs::path& path : writable) good = allow(ruleset, path, handled & ~kExecute) && good;
  good = good && ::syscall(kRestrictSelf, ruleset, 0) == 0;
  ::close(ruleset);
  return good;
}

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;
#endif

// fcntl(2); their names are the C library's only with its extensions.
constexpr std::uint32_t kSetSignal = 10, kSetOwnerEx = 15;
constexpr std::uint32_t kChangeMode2 = 452;  // fchmodat2, which older systems do not have

// The calls that nobody needs who reads files and writes numbers.
std::vector<std::uint32_t> calls_to_others() {
  return {SYS_socket,
          SYS_socketpair,
          SYS_connect,
          SYS_bind,
          SYS_listen,
          SYS_accept,
          SYS_accept4,
          SYS_sendto,
          SYS_sendmsg,
          SYS_sendmmsg,
          SYS_execve,
          SYS_execveat,
          SYS_ptrace,
          SYS_process_vm_readv,
          SYS_process_vm_writev,
          SYS_kill,
          SYS_pidfd_open,
          SYS_pidfd_getfd,
          SYS_pidfd_send_signal,
          SYS_tkill,
          SYS_rt_sigqueueinfo,
          SYS_rt_tgsigqueueinfo,
          SYS_shmget,
          SYS_shmat,
          SYS_shmctl,
          SYS_msgget,
          SYS_msgsnd,
          SYS_msgrcv,
          SYS_msgctl,
          SYS_semget,
          SYS_semop,
          SYS_semtimedop,
          SYS_semctl,
          SYS_mq_open,
          SYS_mq_unlink};
}

std::vector<std::uint32_t> calls_that_change_the_machine() {
  return {SYS_mount,
          SYS_umount2,
          SYS_pivot_root,
          SYS_chroot,
          SYS_unshare,
          SYS_setns,
          SYS_bpf,
          SYS_perf_event_open,
          SYS_keyctl,
          SYS_add_key,
          SYS_request_key,
          SYS_userfaultfd,
          SYS_io_uring_setup,
          SYS_io_uring_enter,
          SYS_io_uring_register,
          SYS_init_module,
          SYS_finit_module,
          SYS_delete_module,
          SYS_kexec_load,
          SYS_open_by_handle_at,
          SYS_name_to_handle_at,
          SYS_reboot,
          SYS_swapon,
          SYS_swapoff,
          SYS_sethostname,
          SYS_setdomainname,
          SYS_settimeofday,
          SYS_clock_settime,
          SYS_acct,
          SYS_quotactl,
          SYS_fchmod,
          SYS_fchmodat,
          kChangeMode2,
          SYS_fchown,
          SYS_fchownat,
          SYS_utimensat,
          SYS_setxattr,
          SYS_lsetxattr,
          SYS_fsetxattr,
          SYS_removexattr,
          SYS_lremovexattr,
          SYS_fremovexattr,
          SYS_truncate};
}

std::vector<std::uint32_t> denied_calls() {
  std::vector<std::uint32_t> calls = calls_to_others();
  const std::vector<std::uint32_t> further = calls_that_change_the_machine();
  calls.insert(calls.end(), further.begin(), further.end());
#if defined(__x86_64__)
  calls.insert(calls.end(), {SYS_fork, SYS_vfork, SYS_iopl, SYS_ioperm, SYS_chmod, SYS_chown, SYS_lchown,
                             SYS_utime, SYS_utimes, SYS_futimesat});
#endif
  return calls;
}

bool confine_calls() {
  if (kArchitecture == 0) return false;
  std::vector<sock_filter> program;
  const auto load = [&](std::size_t offset) {
    program.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)));
  };
  const auto answer = [&](std::uint32_t what) { program.push_back(BPF_STMT(BPF_RET | BPF_K, what)); };
  const auto unless = [&](std::uint16_t test, std::uint32_t value, std::uint8_t skip) {
    program.push_back(BPF_JUMP(static_cast<std::uint16_t>(BPF_JMP | test | BPF_K), value, 0, skip));
  };
  constexpr std::uint32_t kRefuse = SECCOMP_RET_ERRNO | EPERM, kUnknown = SECCOMP_RET_ERRNO | ENOSYS;
  load(offsetof(seccomp_data, arch));
  unless(BPF_JEQ, kArchitecture, 1);
  program.push_back(BPF_STMT(BPF_JMP | BPF_JA, 1));
  answer(SECCOMP_RET_KILL_PROCESS);
  load(offsetof(seccomp_data, nr));
#if defined(__x86_64__)
  unless(BPF_JGE, 0x40000000U, 1);  // the x32 numbers of the same calls
  answer(kRefuse);
#endif
  for (const std::uint32_t call : denied_calls()) {
    unless(BPF_JEQ, call, 1);
    answer(kRefuse);
  }
  // abort() signals its own process, limits are set of the own (0): of no other.
  const auto own_only = [&](std::uint32_t call, std::uint32_t own, std::uint32_t also) {
    unless(BPF_JEQ, call, 5);
    load(offsetof(seccomp_data, args));  // a process has 32 bits
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, own, 2, 0));
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, also, 1, 0));
    answer(kRefuse);
    answer(SECCOMP_RET_ALLOW);
  };
  // What has the kernel send signals to others, or types for the person at a terminal.
  const auto refuse_command = [&](std::uint32_t call, const std::vector<std::uint32_t>& commands) {
    unless(BPF_JEQ, call, static_cast<std::uint8_t>(2 * commands.size() + 2));
    load(offsetof(seccomp_data, args) + sizeof(std::uint64_t));  // the second argument, of 32 bits
    for (const std::uint32_t command : commands) {
      unless(BPF_JEQ, command, 1);
      answer(kRefuse);
    }
    answer(SECCOMP_RET_ALLOW);
  };
  refuse_command(SYS_fcntl, {F_SETOWN, kSetOwnerEx, kSetSignal});
  refuse_command(SYS_ioctl, {FIOSETOWN, SIOCSPGRP, TIOCSTI});
  const auto self = static_cast<std::uint32_t>(::getpid());
  own_only(SYS_tgkill, self, self);
  own_only(SYS_prlimit64, self, 0);
  unless(BPF_JEQ, SYS_clone3, 1);  // its flags lie in memory: the C library falls back on clone
  answer(kUnknown);
  unless(BPF_JEQ, SYS_clone, 4);  // threads, but no processes
  load(offsetof(seccomp_data, args));
  program.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, CLONE_THREAD, 1, 0));
  answer(kRefuse);
  answer(SECCOMP_RET_ALLOW);
  answer(SECCOMP_RET_ALLOW);
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  return ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &filter) == 0;
}

void limit(int resource, double value) {
  rlimit limits{};
  if (::getrlimit(static_cast<__rlimit_resource>(resource), &limits) != 0) return;
  const double most = limits.rlim_max == RLIM_INFINITY ? 9e18 : static_cast<double>(limits.rlim_max);
  limits.rlim_cur = static_cast<rlim_t>(std::min(value, most));
  ::setrlimit(static_cast<__rlimit_resource>(resource), &limits);
}

#if defined(GLISSON_INSTRUMENTED)
// Shadow memory, the search for leaks and counts of lines need what is given up.
constexpr bool kInstrumented = true;
#else
constexpr bool kInstrumented = false;
#endif

}  // namespace

Confinement possible_confinement() {
  Confinement possible;
  if (kInstrumented) return possible;
  const std::uint32_t refuse = SECCOMP_RET_ERRNO;
  possible.files = landlock_version() >= 1;
  possible.calls = kArchitecture != 0 && ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &refuse) == 0;
  return possible;
}

Confinement confine(const std::vector<fs::path>& readable, const std::vector<fs::path>& writable) {
  Confinement confinement;
  if (kInstrumented || ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return confinement;
  confinement.files = confine_files(readable, writable);
  confinement.calls = confine_calls();
  return confinement;
}

void limit_memory(double bytes) {
  if (!kInstrumented) limit(RLIMIT_AS, bytes);
}
void limit_seconds(double seconds) { limit(RLIMIT_CPU, kInstrumented ? 20.0 * seconds : seconds); }
void limit_written_file(double bytes) { limit(RLIMIT_FSIZE, bytes); }

void die_with_parent() {
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  leave_requests_to_the_parent();
}

void leave_requests_to_the_parent() {
  for (const int request : {SIGINT, SIGTERM, SIGHUP}) ::signal(request, SIG_IGN);
}

std::vector<std::string> escapes() {
  std::vector<std::string> could;
  if (const int socket = ::socket(AF_INET, SOCK_STREAM, 0); socket >= 0) {
    could.emplace_back("network");
    ::close(socket);
  }
  if (const pid_t child = ::fork(); child >= 0) {
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    could.emplace_back("program");
  }
  std::error_code failure;
  std::string pattern = (fs::temp_directory_path(failure) / ".glisson-XXXXXX").string();
  if (const int file = ::mkstemp(pattern.data()); file >= 0) {
    could.emplace_back("write");
    ::close(file);
    ::unlink(pattern.c_str());
  }
  if (const int file = ::open("/etc/passwd", O_RDONLY | O_CLOEXEC); file >= 0) {
    could.emplace_back("read");
    ::close(file);
  }
  // What changes nothing where it is allowed: the program's own mode, its length, no signal at all.
  const char* self = "/proc/self/exe";
  struct stat itself = {};
  if (::stat(self, &itself) == 0) {
    if (::chmod(self, itself.st_mode & 07777U) == 0) could.emplace_back("mode");
    if (::truncate(self, itself.st_size) == 0 || (errno != EPERM && errno != EACCES))
      could.emplace_back("truncate");
  }
  if (::syscall(SYS_tgkill, ::getppid(), ::getppid(), 0) == 0) could.emplace_back("signal");
  if (const int file = ::open(self, O_RDONLY | O_CLOEXEC); file >= 0) {
    if (::fcntl(file, F_SETOWN, ::getppid()) == 0) could.emplace_back("asynchronous_signal");
    ::close(file);
  }
  if (::syscall(SYS_msgsnd, -1, nullptr, 0, 0) != 0 && errno != EPERM) could.emplace_back("message");
  return could;
}

}  // namespace glisson
