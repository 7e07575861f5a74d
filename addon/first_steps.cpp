#include "first_steps.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <climits>
#include <cstdint>
#include <cstdio>
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

}  // namespace

constinit const std::array<FirstStep, 2> FIRST_STEPS{{
    {"no inherited descriptors", closeDescriptors},
    {"own network", ownNetwork},
}};

FirstFailures takeFirstSteps() {
  FirstFailures failures{};
  for (std::size_t i = 0; i < FIRST_STEPS.size(); ++i) failures[i] = FIRST_STEPS[i].take();
  return failures;
}

}  // namespace telar::addon
