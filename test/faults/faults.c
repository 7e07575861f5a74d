// What fails in a process that loads this by LD_PRELOAD, as the environment says:
//   TELAR_FAULT_ALLOCATIONS=FILE   the nth allocation of workers of a pool fails, n as the 64-bit number at the beginning of FILE says; 0 = none
//   TELAR_FAULT_PATH=TEXT          of files whose path holds TEXT:
//   TELAR_FAULT_OPEN=ERRNO         opening one for writing fails
//   TELAR_FAULT_WRITE=ERRNO        the second writing to one fails
//   TELAR_FAULT_SHORT=1            each writing takes no more than 7 bytes
//   TELAR_FAULT_SYNC=ERRNO         fsync fails
//   TELAR_FAULT_RENAME=ERRNO       renaming fails
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/uio.h>
#include <unistd.h>

enum { SHORT_BYTES = 7 };

extern void *__libc_malloc(size_t);
extern void *__libc_calloc(size_t, size_t);
extern void *__libc_realloc(void *, size_t);
extern void *__libc_memalign(size_t, size_t);

static _Atomic long long *countdown;
static const char *marked;
static int open_error, write_error, sync_error, rename_error, is_short;
static atomic_int writings;

static int number(const char *name) {
  const char *text = getenv(name);
  return text ? atoi(text) : 0;
}

static int is_worker(void) {
  char line[4096];
  const int file = open("/proc/self/cmdline", O_RDONLY | O_CLOEXEC);
  const ssize_t bytes = file < 0 ? 0 : read(file, line, sizeof line);
  if (file >= 0) close(file);
  return bytes > 0 && memmem(line, (size_t)bytes, "pool/child.mjs", 14) != NULL;
}

__attribute__((constructor)) static void begin(void) {
  marked = getenv("TELAR_FAULT_PATH");
  open_error = number("TELAR_FAULT_OPEN");
  write_error = number("TELAR_FAULT_WRITE");
  sync_error = number("TELAR_FAULT_SYNC");
  rename_error = number("TELAR_FAULT_RENAME");
  is_short = number("TELAR_FAULT_SHORT");
  const char *name = getenv("TELAR_FAULT_ALLOCATIONS");
  if (!name || !is_worker()) return;
  const int file = open(name, O_RDWR | O_CLOEXEC);
  if (file < 0) return;
  void *mapped = mmap(NULL, sizeof(long long), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  if (mapped != MAP_FAILED) countdown = mapped;
}

static int allocation_fails(void) {
  if (!countdown || atomic_load_explicit(countdown, memory_order_relaxed) <= 0) return 0;
  if (atomic_fetch_sub(countdown, 1) != 1) return 0;
  errno = ENOMEM;
  return 1;
}

void *malloc(size_t bytes) { return allocation_fails() ? NULL : __libc_malloc(bytes); }
void *calloc(size_t count, size_t bytes) { return allocation_fails() ? NULL : __libc_calloc(count, bytes); }
void *realloc(void *old, size_t bytes) { return allocation_fails() ? NULL : __libc_realloc(old, bytes); }
void *memalign(size_t alignment, size_t bytes) { return allocation_fails() ? NULL : __libc_memalign(alignment, bytes); }
void *aligned_alloc(size_t alignment, size_t bytes) { return allocation_fails() ? NULL : __libc_memalign(alignment, bytes); }
int posix_memalign(void **result, size_t alignment, size_t bytes) {
  if (allocation_fails()) return ENOMEM;
  *result = __libc_memalign(alignment, bytes);
  return *result ? 0 : ENOMEM;
}

static int is_marked(const char *path) { return marked && path && strstr(path, marked); }

static int is_marked_file(int file) {
  char link[64], path[PATH_MAX];
  if (!marked) return 0;
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length <= 0) return 0;
  path[length] = '\0';
  return is_marked(path);
}

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static int opened(int (*next)(const char *, int, ...), const char *path, int flags, mode_t mode) {
  if (open_error && (flags & O_ACCMODE) != O_RDONLY && is_marked(path)) {
    errno = open_error;
    return -1;
  }
  return next(path, flags, mode);
}

static mode_t mode_of(int flags, va_list rest) { return flags & (O_CREAT | __O_TMPFILE) ? va_arg(rest, mode_t) : 0; }

int open(const char *path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return opened(NEXT(open), path, flags, mode);
}

int open64(const char *path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return opened(NEXT(open64), path, flags, mode);
}

// Bytes that may be written, or -1.
static ssize_t allowed(int file, size_t bytes) {
  if ((!write_error && !is_short) || !is_marked_file(file)) return (ssize_t)bytes;
  if (write_error && atomic_fetch_add(&writings, 1) > 0) {
    errno = write_error;
    return -1;
  }
  // So that there is a second one.
  return bytes > SHORT_BYTES ? SHORT_BYTES : (ssize_t)bytes;
}

ssize_t write(int file, const void *from, size_t bytes) {
  const ssize_t most = allowed(file, bytes);
  return most < 0 ? -1 : NEXT(write)(file, from, (size_t)most);
}
ssize_t pwrite(int file, const void *from, size_t bytes, off_t at) {
  const ssize_t most = allowed(file, bytes);
  return most < 0 ? -1 : NEXT(pwrite)(file, from, (size_t)most, at);
}
ssize_t pwrite64(int file, const void *from, size_t bytes, off64_t at) {
  const ssize_t most = allowed(file, bytes);
  return most < 0 ? -1 : NEXT(pwrite64)(file, from, (size_t)most, at);
}
ssize_t writev(int file, const struct iovec *pieces, int count) {
  if ((!write_error && !is_short) || count < 1 || !is_marked_file(file)) return NEXT(writev)(file, pieces, count);
  return write(file, pieces[0].iov_base, pieces[0].iov_len);
}

int fsync(int file) {
  if (!sync_error || !is_marked_file(file)) return NEXT(fsync)(file);
  errno = sync_error;
  return -1;
}

int rename(const char *from, const char *to) {
  if (!rename_error || !is_marked(to)) return NEXT(rename)(from, to);
  errno = rename_error;
  return -1;
}
