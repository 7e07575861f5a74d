#define TELAR_REFERENCE_PLUGIN
#include "reference/plugin.h"

#include <embree3/rtcore_config.h>

#include <exception>
#include <new>

#include "reference/ambient.h"
#include "reference/tracer.h"
#include "reference/visibility.h"

namespace telar::reference {
namespace {

/// What fails is told by the job: no exception crosses the library.
template <class Job, class Work>
void told(Job& job, const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    job.failure = {error.code, error.what(), error.pointer, error.limit};
  } catch (const std::bad_alloc&) {
    job.failure = {"X_MEMORY", "not enough memory to trace this model at this size", {}, {}};
  } catch (const std::exception& error) {
    job.failure = {"X_INTERNAL", std::string("the path tracer failed: ") + error.what(), {}, {}};
  }
}

void draw(TraceJob& job) {
  told(job, [&] {
    job.frame = trace(job.scene, job.shot, job.environment, optionsOf(job.shot), job.limits, job.cancel, job.progress,
                      &job.facts);
  });
}

}  // namespace
}  // namespace telar::reference

std::uint64_t telar_reference_layout() { return telar::traceLayout(); }

const char* telar_reference_version() { return "Embree " RTC_VERSION_STRING; }

void telar_reference_draw(telar::TraceJob* job) { telar::reference::draw(*job); }

void telar_reference_ambient(telar::AmbientJob* job) {
  telar::reference::told(*job, [&] { telar::reference::findAmbient(*job); });
}

void telar_reference_visibility(telar::VisibilityJob* job) {
  telar::reference::told(*job, [&] { telar::reference::findVisibility(*job); });
}
