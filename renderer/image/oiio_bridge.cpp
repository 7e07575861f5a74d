#include "image/oiio_bridge.h"

#include <dlfcn.h>

#include <cstdlib>
#include <new>
#include <string>

#include "oiio/plugin.h"

namespace telar::image {
namespace {

constexpr const char* LIBRARY_NAME = "libtelar_oiio.so";

/// Folder of the .node, .so or program that holds this function, with a slash at its end.
std::string ownFolder() {
  Dl_info info = {};
  if (!dladdr(reinterpret_cast<const void*>(&ownFolder), &info) || !info.dli_fname) return "./";
  const std::string path = info.dli_fname;
  return path.substr(0, path.rfind('/') + 1);
}

/// What the loader misses, without the folder: its message starts with the file's path.
std::string missingFile(const char* message) {
  const std::string text = message ? message : LIBRARY_NAME;
  const std::string path = text.substr(0, text.find(':'));
  return path.substr(path.rfind('/') + 1);
}

[[noreturn]] void failToLoad(const std::string& what) {
  throw Error("X_LIBRARY_MISSING",
              "OpenImageIO is needed for .hdr, .exr and TIFF files and for ICC profiles, but " + what +
                  "; run: apt-get install libopenimageio2.4 liblcms2-2, and build telar again if it is older");
}

/// The loaded library. It is never unloaded (OpenImageIO does not bear it), so loading it again is cheap and no state
/// of ours has to remember it.
class Library {
 public:
  Library() {
    const char* folder = std::getenv("TELAR_LIBRARY_DIR");
    const std::string path = (folder && *folder ? std::string(folder) + "/" : ownFolder()) + LIBRARY_NAME;
    handle_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!handle_) failToLoad(missingFile(dlerror()) + " cannot be loaded");
    if (function<TelarOiioVersionFunction>("telar_oiio_version")() != TELAR_OIIO_VERSION) {
      failToLoad(std::string(LIBRARY_NAME) + " is of another version");
    }
  }
  ~Library() { dlclose(handle_); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  template <class Function>
  Function* function(const char* name) const {
    void* address = dlsym(handle_, name);
    if (!address) failToLoad(std::string(LIBRARY_NAME) + " is incomplete");
    return reinterpret_cast<Function*>(address);
  }

 private:
  void* handle_ = nullptr;
};

bool append(void* user, const void* bytes, std::size_t count) {
  auto& out = *static_cast<std::vector<std::byte>*>(user);
  try {
    const auto* begin = static_cast<const std::byte*>(bytes);
    out.insert(out.end(), begin, begin + count);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

TelarOiioCancel cancelOf(const CancelToken& cancel) {
  return {&cancel, [](const void* user) { return static_cast<const CancelToken*>(user)->cancelled(); }};
}

/// @param code of a FAILED result
void check(const TelarOiioResult& result, const char* code, const std::string& subject, const CancelToken& cancel) {
  switch (result.status) {
    case TELAR_OIIO_OK:
      return;
    case TELAR_OIIO_CANCELLED:
      cancel.check();
      break;
    case TELAR_OIIO_NO_MEMORY:
      throw std::bad_alloc();
    case TELAR_OIIO_UNSUPPORTED:
      throw Error("E_ENVIRONMENT_FORMAT", subject + " cannot be used: " + result.message);
    default:
      break;
  }
  throw Error(code, subject + " failed: " + quoted(result.message));
}

TelarOiioFormat formatOf(OutputOptions::Format format) {
  switch (format) {
    case OutputOptions::Format::kTiff:
      return TELAR_OIIO_TIFF;
    case OutputOptions::Format::kExr:
      return TELAR_OIIO_EXR;
    default:
      return TELAR_OIIO_PNG;
  }
}

}  // namespace

std::vector<std::byte> encodeWithOiio(const Frame& frame, const OutputOptions& options, const CancelToken& cancel) {
  std::vector<std::byte> file;
  const TelarOiioWrite job = {formatOf(options.format), frame.width, frame.height, frame.pixels.data(),
                              options.bitDepth,         options.ppi, options.icc,  cancelOf(cancel)};
  const TelarOiioSink sink = {&file, append};
  TelarOiioResult result;
  Library().function<TelarOiioWriteFunction>("telar_oiio_write")(&job, &sink, &result);
  check(result, "X_OUTPUT", "writing the image", cancel);
  return file;
}

std::vector<std::byte> srgbProfile() {
  std::vector<std::byte> profile;
  const TelarOiioSink sink = {&profile, append};
  TelarOiioResult result;
  Library().function<TelarOiioProfileFunction>("telar_oiio_srgb_profile")(&sink, &result);
  check(result, "X_OUTPUT", "making the ICC profile", {});
  return profile;
}

void readWithOiio(Bytes file, EnvironmentFormat format, ImageF& image, const CancelToken& cancel) {
  const TelarOiioRead job = {format == EnvironmentFormat::kHdr ? TELAR_OIIO_HDR : TELAR_OIIO_EXR,
                             file.data(),
                             file.size(),
                             image.width,
                             image.height,
                             image.pixels.data(),
                             cancelOf(cancel)};
  TelarOiioResult result;
  Library().function<TelarOiioReadFunction>("telar_oiio_read")(&job, &result);
  check(result, "E_ENVIRONMENT_CORRUPT", "reading the environment", cancel);
}

}  // namespace telar::image
