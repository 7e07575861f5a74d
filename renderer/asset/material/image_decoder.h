#pragma once
#include <atomic>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "telar/codec.h"
#include "telar/pending_images.h"

namespace telar::asset {

/// Threads that decode images beside their scene; who waits for them helps.
class ImageDecoder : public PendingImages {
 public:
  struct File {
    std::size_t image = 0;
    std::string where;                  ///< JSON pointer of the image
    std::shared_ptr<const void> owner;  ///< of the bytes
    std::span<const std::byte> bytes;
  };

  /// @param images  of these sizes, without pixels
  /// @param files   in the order of their images
  /// @param cancel  of who loads the scene: no more images are begun after it
  /// @param threads  at most
  ImageDecoder(std::shared_ptr<std::vector<Image8>> images, std::vector<File> files, const Limits& limits,
               const CancelToken& cancel, std::size_t threads);
  ~ImageDecoder() override;

  void wait(const CancelToken& cancel) override;

 private:
  void run(const CancelToken& cancel);
  void decode(const File& file, const CancelToken& cancel);
  void waitForThreads(const CancelToken& cancel);

  const std::shared_ptr<std::vector<Image8>> images_;
  std::vector<File> files_;
  const Limits limits_;
  const CancelToken loading_, stop_;
  std::atomic<std::size_t> next_ = 0;
  std::vector<std::exception_ptr> thrown_;  ///< by file

  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::size_t left_;

  std::vector<std::jthread> threads_;  // last, as they use all of the above
};

}  // namespace telar::asset
