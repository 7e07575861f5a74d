#include "first_steps.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <linux/landlock.h>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <climits>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace telar::addon {
namespace {

/// Standard input, output and errors, and the pipe to the parent (js/pool/child.mjs).
constexpr unsigned KEPT_DESCRIPTORS = 4;

int closeDescriptors() { return failureOf(close_range(KEPT_DESCRIPTORS, UINT_MAX, 0)); }

constexpr std::size_t CAPABILITY_WORDS = _LINUX_CAPABILITY_U32S_3;
using Capabilities = std::array<__user_cap_data_struct, CAPABILITY_WORDS>;

long callOfCapabilities(long call, Capabilities& capabilities) {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  return syscall(call, &header, capabilities.data());
}

/// Whether the process may do what its user alone may not. Where that is unknown, it may.
bool hasRights() {
  Capabilities now{};
  if (callOfCapabilities(SYS_capget, now) != 0) return true;
  std::uint32_t some = 0;
  for (const __user_cap_data_struct& word : now) some |= word.permitted;
  return some != 0;
}

int writeFile(const char* path, const char* text) {
  const int file = open(path, O_WRONLY | O_CLOEXEC);
  if (file == -1) return errno;
  const int failure = failureOf(write(file, text, std::strlen(text)));
  close(file);
  return failure;
}

/// Numbers of the user and the group mean in the namespace what they mean outside.
int mapIds(uid_t user, gid_t group) {
  char ids[64];
  std::snprintf(ids, sizeof ids, "%u %u 1", user, user);
  if (const int failure = writeFile("/proc/self/uid_map", ids)) return failure;
  // The kernel wants this before the groups of somebody without rights.
  if (const int failure = writeFile("/proc/self/setgroups", "deny")) return failure;
  std::snprintf(ids, sizeof ids, "%u %u 1", group, group);
  return writeFile("/proc/self/gid_map", ids);
}

/// Inside a user namespace its maker has every right, of which a worker needs none.
int networkOfUser() {
  const uid_t user = geteuid();
  const gid_t group = getegid();
  // There is no way back from a namespace whose ids cannot be mapped.
  if (access("/proc/self/uid_map", W_OK) != 0) return errno;
  if (unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) return errno;
  const int failure = mapIds(user, group);
  Capabilities none{};
  const int dropped = failureOf(callOfCapabilities(SYS_capset, none));
  return failure != 0 ? failure : dropped;
}

/// Files of others, which rights of root open, are lost in a user namespace.
int ownNetwork() { return hasRights() ? failureOf(unshare(CLONE_NEWNET)) : networkOfUser(); }

/// Of Landlock's third version, which the headers of some systems lack.
constexpr std::uint64_t TRUNCATE = 1u << 14;

/// Rights to change files that this kernel's Landlock can take; 0 and errno where it has none.
std::uint64_t rightsToWrite() {
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return 0;
  std::uint64_t rights = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                         LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR |
                         LANDLOCK_ACCESS_FS_MAKE_REG | LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                         LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;
  if (version >= 2) rights |= LANDLOCK_ACCESS_FS_REFER;
  if (version >= 3) rights |= TRUNCATE;
  return rights;
}

/// Keeps rights below a folder. In one that cannot be opened nothing can be written.
int keepBelow(int rules, const char* folder, std::uint64_t rights) {
  const int place = open(folder, O_PATH | O_CLOEXEC);
  if (place == -1) return 0;
  landlock_path_beneath_attr beneath{};
  beneath.allowed_access = rights;
  beneath.parent_fd = place;
  const int failure = failureOf(syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0));
  close(place);
  return failure;
}

/// The same below each of some folders, a line each.
int keepBelowEach(int rules, const char* folders, std::uint64_t rights) {
  char folder[PATH_MAX];
  while (*folders != 0) {
    const std::size_t length = std::strcspn(folders, "\n");
    if (length < sizeof folder) {  // else no call takes it
      std::memcpy(folder, folders, length);
      folder[length] = 0;
      if (const int failure = keepBelow(rules, folder, rights)) return failure;
    }
    folders += length;
    folders += *folders == '\n';
  }
  return 0;
}

int keepWrites(int rules, std::uint64_t rights) {
  // A GPU is a device, which is opened to be written to; a process sets its priority by files of its own.
  const std::uint64_t change = rights & (LANDLOCK_ACCESS_FS_WRITE_FILE | TRUNCATE);
  for (const char* place : {"/dev", "/proc/self"})
    if (const int failure = keepBelow(rules, place, change)) return failure;
  const char* folders = std::getenv(WORKER_FOLDERS);
  if (const int failure = keepBelowEach(rules, folders ? folders : "", rights)) return failure;
  // Without it the kernel asks for rights of root.
  if (const int failure = forgoPrivileges()) return failure;
  return failureOf(syscall(SYS_landlock_restrict_self, rules, 0));
}

/// For this thread and those that it will start: so it is done while there is no other.
int noWritesElsewhere() {
  landlock_ruleset_attr handled{};
  handled.handled_access_fs = rightsToWrite();
  if (handled.handled_access_fs == 0) return errno;
  const auto rules = static_cast<int>(syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
  if (rules == -1) return errno;
  const int failure = keepWrites(rules, handled.handled_access_fs);
  close(rules);
  return failure;
}

}  // namespace

constinit const std::array<FirstStep, 3> FIRST_STEPS{{
    {"no inherited descriptors", closeDescriptors},
    {"own network", ownNetwork},
    {"no writes elsewhere", noWritesElsewhere},
}};

FirstFailures takeFirstSteps() {
  FirstFailures failures{};
  for (std::size_t i = 0; i < FIRST_STEPS.size(); ++i) failures[i] = FIRST_STEPS[i].take();
  return failures;
}

}  // namespace telar::addon
