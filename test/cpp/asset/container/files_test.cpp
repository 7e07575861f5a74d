#include "asset/container/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "asset/model_builder.h"

namespace telar::test {
namespace {

namespace fs = std::filesystem;

/// A folder with a model, a neighbour and traps; removed afterwards.
class FilesTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "telar-files-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    root = name;
    fs::create_directories(root / "model" / "sub");
    write(root / "secret.bin", std::string(400, 's'));
    model.quad();
    write(root / "model" / "sub" / "a b.bin", {reinterpret_cast<const char*>(model.bin.data()), model.bin.size()});
    fs::create_symlink("../secret.bin", root / "model" / "link.bin");
    fs::create_symlink("a b.bin", root / "model" / "sub" / "inner.bin");
    fs::create_directory_symlink("..", root / "model" / "up");
    ::mkfifo((root / "model" / "pipe.bin").c_str(), 0600);
  }
  void TearDown() override { fs::remove_all(root); }

  static void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

  fs::path writeModel(const std::string& uri) {
    json doc = model.doc;
    doc["buffers"] = {{{"byteLength", model.bin.size()}, {"uri", uri}}};
    const fs::path path = root / "model" / "m.gltf";
    write(path, doc.dump());
    return path;
  }

  std::string errorWith(const std::string& uri, const Limits& limits = {}) { return errorAt(writeModel(uri), limits); }

  static std::string errorAt(const fs::path& path, const Limits& limits = {}) {
    try {
      loadPath(path, limits, {});
      return "";
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find("/tmp"), std::string::npos) << "a message names a server path";
      return error.code;
    }
  }

  fs::path root;
  ModelBuilder model;
};

TEST_F(FilesTest, RegularFilesBeneathTheFolderAreRead) {
  const auto path = writeModel("sub/a%20b.bin");
  const auto scene = loadPath(path, {}, {});
  EXPECT_EQ(scene->bounds.max, glm::dvec3(1, 1, 0));
  EXPECT_EQ(scene->fileBytes, fs::file_size(path) + model.bin.size());
  EXPECT_EQ(errorWith("./sub/.//a%20b.bin"), "");
}

TEST_F(FilesTest, NothingElseIs) {
  EXPECT_EQ(errorWith("../secret.bin"), "E_URI_DENIED");
  EXPECT_EQ(errorWith("/etc/hostname"), "E_URI_DENIED");
  EXPECT_EQ(errorWith("link.bin"), "E_URI_DENIED");
  EXPECT_EQ(errorWith("sub/inner.bin"), "E_URI_DENIED");
  EXPECT_EQ(errorWith("up/secret.bin"), "E_URI_DENIED");
  EXPECT_EQ(errorWith("up/model/sub/a%20b.bin"), "E_URI_DENIED");
  EXPECT_EQ(errorWith("pipe.bin"), "E_URI_DENIED");
  EXPECT_EQ(errorWith("sub"), "E_URI_MISSING");
  EXPECT_EQ(errorWith("."), "E_URI_MISSING");
  EXPECT_EQ(errorWith("none.bin"), "E_URI_MISSING");
  EXPECT_EQ(errorWith("sub/a b.bin/x"), "E_URI_MISSING");
  EXPECT_EQ(errorWith("m.gltf"), "E_URI_MISSING");
  EXPECT_EQ(errorWith("sub/a%20b.bin#x"), "E_URI_MISSING");
}

TEST_F(FilesTest, ExternalFilesAreLimited) {
  Limits limits;
  limits.externalBytes = model.bin.size() - 1;
  EXPECT_EQ(errorWith("sub/a%20b.bin", limits), "L_EXTERNAL_BYTES");
  limits = {};
  limits.externalFiles = 0;
  EXPECT_EQ(errorWith("sub/a%20b.bin", limits), "L_EXTERNAL_FILES");
}

TEST_F(FilesTest, TheModelMayBeALinkButMustBeARegularFile) {
  const auto path = writeModel("sub/a%20b.bin");
  fs::rename(path, root / "elsewhere.gltf");
  fs::create_symlink(root / "elsewhere.gltf", path);
  EXPECT_EQ(errorAt(path), "");
  EXPECT_EQ(errorAt(root / "model"), "E_FILE");
  EXPECT_EQ(errorAt(root / "model" / "pipe.bin"), "E_FILE");
  EXPECT_EQ(errorAt("/dev/zero"), "E_FILE");
  EXPECT_EQ(errorAt(root / "none.glb"), "E_FILE");
  Limits limits;
  limits.fileBytes = 16;
  EXPECT_EQ(errorAt(path, limits), "L_FILE_BYTES");
}

/// The fallback of older kernels must answer as openat2 does.
TEST_F(FilesTest, WalkingAgreesWithTheKernel) {
  const asset::FileDescriptor folder(::open((root / "model").c_str(), O_PATH | O_DIRECTORY));
  for (const char* path : {"sub/a b.bin", "./sub//a b.bin", "link.bin", "sub/inner.bin", "up/secret.bin", "none", "sub",
                           "sub/", "../secret.bin", "sub/a b.bin/x", "none/x"}) {
    errno = 0;
    const asset::FileDescriptor kernel(asset::openBeneath(folder.get(), path));
    const int kernelErrno = kernel ? 0 : errno;
    errno = 0;
    const asset::FileDescriptor walk(asset::walkBeneath(folder.get(), path));
    const int walkErrno = walk ? 0 : errno;
    const bool denied = kernelErrno == ELOOP || kernelErrno == EXDEV;
    EXPECT_EQ(denied, walkErrno == ELOOP || walkErrno == EXDEV) << path;
    EXPECT_EQ(bool(kernel), bool(walk)) << path;
  }
}

}  // namespace
}  // namespace telar::test
