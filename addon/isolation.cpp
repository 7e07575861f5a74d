#include "isolation.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <optional>

#include "first_steps.h"

namespace telar::addon {
namespace {

/// Open files of a worker: the GL driver and Node have some thirty, a model is read file by file.
constexpr rlim_t MAX_FILES = 256;

#if defined(__x86_64__)
constexpr std::uint32_t ARCHITECTURE = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t ARCHITECTURE = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t ARCHITECTURE = 0;
#endif

/// Numbers that every architecture has in common, for calls that are younger than the headers of some systems.
constexpr std::uint32_t IO_URING_SETUP = 425, OPEN_TREE = 428, MOVE_MOUNT = 429, FSOPEN = 430, FSMOUNT = 432,
                        PIDFD_OPEN = 434, PIDFD_GETFD = 438, PROCESS_MADVISE = 440, MOUNT_SETATTR = 442,
                        PIDFD_SEND_SIGNAL = 424;

/// Calls that start programs, reach other processes, change what is mounted or loaded, or do any of these by another
/// way: io_uring opens sockets.
constexpr std::uint32_t DENIED[] = {
    __NR_execve,
    __NR_execveat,
    __NR_ptrace,
    __NR_process_vm_readv,
    __NR_process_vm_writev,
    __NR_mount,
    __NR_umount2,
    __NR_pivot_root,
    __NR_chroot,
    __NR_setns,
    __NR_unshare,
    __NR_bpf,
    __NR_perf_event_open,
    __NR_kexec_load,
    __NR_init_module,
    __NR_finit_module,
    __NR_delete_module,
    __NR_keyctl,
    __NR_add_key,
    __NR_request_key,
    __NR_userfaultfd,
    __NR_open_by_handle_at,
    __NR_reboot,
    __NR_swapon,
    __NR_swapoff,
    __NR_acct,
    __NR_quotactl,
    __NR_settimeofday,
    __NR_clock_settime,
    __NR_sethostname,
    __NR_setdomainname,
    __NR_kcmp,
    __NR_rt_sigqueueinfo,
    __NR_rt_tgsigqueueinfo,
    IO_URING_SETUP,
    OPEN_TREE,
    MOVE_MOUNT,
    FSOPEN,
    FSMOUNT,
    PIDFD_OPEN,
    PIDFD_GETFD,
    PROCESS_MADVISE,
    MOUNT_SETATTR,
    PIDFD_SEND_SIGNAL,
};

/// As in clone3's manual: a C library that is told so starts its threads by clone(), whose flags a filter can read.
constexpr std::uint32_t CLONE3 = 435;

/// Calls whose first argument names a process: only this one.
constexpr std::uint32_t OWN_PROCESS[] = {__NR_kill, __NR_tgkill};
constexpr std::uint32_t OWN_PROCESS_OR_0[] = {__NR_prlimit64};

constexpr std::uint32_t lowHalf(std::size_t argument) {
  return offsetof(seccomp_data, args) + argument * sizeof(std::uint64_t);
}

/// A program of the kernel's packet filter, by appending. No heap: it also runs between fork() and _exit().
class Filter {
 public:
  void load(std::uint32_t offset) { add(BPF_LD | BPF_W | BPF_ABS, 0, 0, offset); }
  void answer(std::uint32_t action) { add(BPF_RET | BPF_K, 0, 0, action); }
  void deny() { answer(SECCOMP_RET_ERRNO | EACCES); }

  /// Skips `count` instructions unless the loaded word is `value`.
  void unlessIs(std::uint32_t value, std::uint8_t count) { add(BPF_JMP | BPF_JEQ | BPF_K, 0, count, value); }
  void ifIs(std::uint32_t value, std::uint8_t count) { add(BPF_JMP | BPF_JEQ | BPF_K, count, 0, value); }
  void ifBelow(std::uint32_t value, std::uint8_t count) { add(BPF_JMP | BPF_JGE | BPF_K, 0, count, value); }

  void denyCall(std::uint32_t call) {
    unlessIs(call, 1);
    deny();
  }

  /// Lets the call pass where its first argument is `a` or `b`. The number of the call has to be loaded, and is
  /// afterwards.
  void denyUnless(std::uint32_t call, std::uint32_t a, std::uint32_t b) {
    unlessIs(call, 5);
    load(lowHalf(0));
    ifIs(a, 2);
    ifIs(b, 1);
    deny();
    load(offsetof(seccomp_data, nr));
  }

  /// Threads, and no processes: one of those would not end with this one.
  void denyUnlessThread(std::uint32_t call) {
    unlessIs(call, 4);
    load(lowHalf(0));
    add(BPF_JMP | BPF_JSET | BPF_K, 1, 0, CLONE_THREAD);
    deny();
    load(offsetof(seccomp_data, nr));
  }

  /// As if the kernel did not have it.
  void hideCall(std::uint32_t call) {
    unlessIs(call, 1);
    answer(SECCOMP_RET_ERRNO | ENOSYS);
  }

  long install() {
    sock_fprog program{static_cast<unsigned short>(size_), code_.data()};
    return syscall(__NR_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program);
  }

 private:
  void add(std::uint16_t code, std::uint8_t jumpTrue, std::uint8_t jumpFalse, std::uint32_t k) {
    if (size_ < code_.size()) code_[size_++] = {code, jumpTrue, jumpFalse, k};
  }
  std::array<sock_filter, 160> code_{};
  std::size_t size_ = 0;
};

int denyCalls(std::uint64_t) {
  if (ARCHITECTURE == 0) return ENOSYS;
  const auto self = static_cast<std::uint32_t>(getpid());
  Filter filter;
  filter.load(offsetof(seccomp_data, arch));
  filter.ifIs(ARCHITECTURE, 1);
  filter.deny();
  filter.load(offsetof(seccomp_data, nr));
#if defined(__x86_64__)
  // The same calls by their numbers of x32.
  filter.ifBelow(0x40000000, 1);
  filter.deny();
#endif
  for (const std::uint32_t call : DENIED) filter.denyCall(call);
#if defined(__x86_64__)
  filter.denyCall(__NR_fork);
  filter.denyCall(__NR_vfork);
#endif
  filter.hideCall(CLONE3);
  filter.denyUnlessThread(__NR_clone);
  filter.denyUnless(__NR_socket, AF_UNIX, AF_UNIX);
  for (const std::uint32_t call : OWN_PROCESS) filter.denyUnless(call, self, self);
  for (const std::uint32_t call : OWN_PROCESS_OR_0) filter.denyUnless(call, self, 0);
  filter.answer(SECCOMP_RET_ALLOW);
  const long result = filter.install();
  // Above 0: the number of a thread that could not take the filter.
  if (result != 0) return result > 0 ? EBUSY : errno;
  // There is no such program: the kernel says ENOENT where the filter lets the call pass.
  return syscall(__NR_execve, "", nullptr, nullptr) == -1 && errno == EACCES ? 0 : EPROTO;
}

/// Sets both bounds, at most to what the hard one is.
int limit(__rlimit_resource resource, rlim_t most) {
  rlimit now{};
  if (getrlimit(resource, &now) != 0) return errno;
  const rlim_t value = now.rlim_max < most ? now.rlim_max : most;
  const rlimit bounds{value, value};
  return failureOf(setrlimit(resource, &bounds));
}

int endWithParent(std::uint64_t) { return failureOf(prctl(PR_SET_PDEATHSIG, SIGKILL)); }
int noNewPrivileges(std::uint64_t) { return forgoPrivileges(); }
int noCore(std::uint64_t) { return limit(RLIMIT_CORE, 0); }
int fewFiles(std::uint64_t) { return limit(RLIMIT_NOFILE, MAX_FILES); }
#if defined(__SANITIZE_ADDRESS__)
/// The sanitizer reserves terabytes for what it notes about each byte.
int boundedData(std::uint64_t) { return ENOTSUP; }
#else
int boundedData(std::uint64_t bytes) { return bytes == 0 ? 0 : limit(RLIMIT_DATA, bytes); }
#endif
int notTraceable(std::uint64_t) { return failureOf(prctl(PR_SET_DUMPABLE, 0)); }

struct Step {
  const char* name;
  int (*take)(std::uint64_t dataBytes);
};

/// In order: without new privileges the filter needs no rights to be installed.
constexpr Step STEPS[] = {
    {"end with the parent", endWithParent}, {"no new privileges", noNewPrivileges}, {"no core dump", noCore},
    {"few open files", fewFiles},           {"bounded memory", boundedData},        {"not traceable", notTraceable},
    {"filtered system calls", denyCalls},
};
constexpr std::size_t STEP_COUNT = std::size(STEPS);
using Failures = std::array<int, STEP_COUNT>;

Failures takeSteps(std::uint64_t dataBytes) {
  Failures failures{};
  for (std::size_t i = 0; i < STEP_COUNT; ++i) failures[i] = STEPS[i].take(dataBytes);
  return failures;
}

/// What came of all steps; the first ones where somebody took them.
struct StepsTaken {
  std::optional<FirstFailures> first;
  Failures failures;
};

std::string rowOf(const char* step, std::optional<int> failure) {
  std::string text = "{\"step\":\"" + std::string(step) + "\"";
  if (failure == 0) text += ",\"failure\":null";
  if (failure > 0) {
    const char* name = strerrorname_np(*failure);
    text += ",\"failure\":\"" + std::string(name ? name : "unknown") + "\"";
  }
  return text + "}";
}

std::string reportOf(const StepsTaken& taken) {
  std::string text = "[";
  for (std::size_t i = 0; i < FIRST_STEPS.size(); ++i)
    text += rowOf(FIRST_STEPS[i].name, taken.first ? std::optional((*taken.first)[i]) : std::nullopt) + ",";
  for (std::size_t i = 0; i < STEP_COUNT; ++i)
    text += rowOf(STEPS[i].name, taken.failures[i]) + (i + 1 < STEP_COUNT ? "," : "");
  return text + "]";
}

/// What this process gave up at its start.
std::optional<FirstFailures> firstFailures() {
  auto* find = reinterpret_cast<FirstFailuresFunction*>(dlsym(RTLD_DEFAULT, FIRST_FAILURES_SYMBOL));
  const FirstFailures* failures = find ? find() : nullptr;
  return failures ? std::optional(*failures) : std::nullopt;
}

}  // namespace

std::string isolateProcess(std::uint64_t dataBytes) { return reportOf({firstFailures(), takeSteps(dataBytes)}); }

std::string probeIsolation(bool withFirst) {
  StepsTaken taken;
  taken.failures.fill(EIO);
  if (withFirst) taken.first.emplace().fill(EIO);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return reportOf(taken);
  const pid_t child = fork();
  if (child == 0) {
    // Other threads may have held any lock: nothing here allocates. The pipe has the place of a worker's own.
    constexpr int PIPE = 3;
    StepsTaken found;
    const bool isHeard = dup2(ends[1], PIPE) == PIPE;
    if (withFirst) found.first = takeFirstSteps();
    found.failures = takeSteps(0);
    _exit(isHeard && write(PIPE, &found, sizeof found) == sizeof found ? 0 : 1);
  }
  close(ends[1]);
  if (child > 0) {
    StepsTaken found;
    if (read(ends[0], &found, sizeof found) == sizeof found) taken = found;
    while (waitpid(child, nullptr, 0) == -1 && errno == EINTR) {
    }
  }
  close(ends[0]);
  return reportOf(taken);
}

}  // namespace telar::addon
