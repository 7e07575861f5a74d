#include "fault.h"

#include <new>
#include <system_error>

namespace telar::addon {

Fault Fault::current() {
  try {
    throw;
  } catch (const Error& error) {
    return {error.code, error.what(), error.pointer, error.offset, error.limit};
  } catch (const std::bad_alloc&) {
    return {"X_MEMORY", "there is not enough memory for this job", {}, {}, {}};
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again) {
      return {"X_MEMORY",
              "the system starts no more threads for this process; raise its limit of processes (ulimit -u, the "
              "container's pids) or "
              "of memory",
              {},
              {},
              {}};
    }
    return {error.code() == std::errc::not_enough_memory ? "X_MEMORY" : "X_INTERNAL", error.what(), {}, {}, {}};
  } catch (const std::exception& error) {
    return {"X_INTERNAL", error.what(), {}, {}, {}};
  } catch (...) {
    return {"X_INTERNAL", "an exception of an unknown type was thrown", {}, {}, {}};
  }
}

Napi::Object Fault::toJs(Napi::Env env) const {
  Napi::Object object = Napi::Object::New(env);
  object["code"] = code;
  object["message"] = message;
  if (pointer) object["pointer"] = *pointer;
  if (offset) object["offset"] = static_cast<double>(*offset);
  if (limit) {
    Napi::Object fact = Napi::Object::New(env);
    fact["name"] = limit->name;
    fact["max"] = limit->max;
    fact["actual"] = limit->actual;
    object["limit"] = fact;
  }
  return object;
}

}  // namespace telar::addon
