// An addon with faults that the sanitizers have to find before `npm run sanitize` runs a test: require() reads behind
// an allocation or overflows an integer, as TELAR_PLANTED says.
#include <node_api.h>

#include <climits>
#include <cstdlib>
#include <cstring>
#include <memory>

extern "C" [[gnu::visibility("default")]] napi_value napi_register_module_v1(napi_env, napi_value exports) {
  const char* which = std::getenv("TELAR_PLANTED");
  volatile int count = 4, sum = 0;
  if (which && std::strcmp(which, "address") == 0) {
    const std::unique_ptr<int[]> numbers(new int[4]());
    sum = numbers[static_cast<std::size_t>(count)];
  }
  if (which && std::strcmp(which, "undefined") == 0) sum = INT_MAX - 3 + count;
  return sum == 1 ? nullptr : exports;
}
