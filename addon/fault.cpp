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
    const bool exhausted =
        error.code() == std::errc::resource_unavailable_try_again || error.code() == std::errc::not_enough_memory;
    return {exhausted ? "X_MEMORY" : "X_INTERNAL", error.what(), {}, {}, {}};
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
