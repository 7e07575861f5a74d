#include "asset/material/image_decoder.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <system_error>
#include <utility>

namespace telar::asset {
namespace {

constexpr std::chrono::milliseconds LOOK{5};  ///< from one look at the caller's token to the next

}  // namespace

ImageDecoder::ImageDecoder(std::shared_ptr<std::vector<Image8>> images, std::vector<File> files, const Limits& limits,
                           const CancelToken& cancel, std::size_t threads)
    : images_(std::move(images)), files_(std::move(files)), limits_(limits), loading_(cancel), left_(files_.size()) {
  thrown_.resize(files_.size());
  threads_.reserve(threads);
  try {
    while (threads_.size() < std::min(threads, files_.size())) threads_.emplace_back([this] { run(stop_); });
  } catch (const std::system_error&) {
    // The machine has no thread to give: who waits does it all.
  }
}

ImageDecoder::~ImageDecoder() { stop_.cancel(); }

void ImageDecoder::run(const CancelToken& cancel) {
  for (std::size_t i = next_++; i < files_.size(); i = next_++) {
    try {
      if (loading_.cancelled()) loading_.check();  // its deadline is that of threads that count their work
      decode(files_[i], cancel);
    } catch (...) {
      thrown_[i] = std::current_exception();
    }
    files_[i].owner.reset();
    // No more are begun after one that is damaged. Those before it are, so of two the first one is told.
    const std::size_t begun = thrown_[i] ? next_.exchange(files_.size()) : files_.size();
    const std::lock_guard lock(mutex_);
    left_ -= 1 + files_.size() - std::min(begun, files_.size());
    changed_.notify_all();
  }
}

void ImageDecoder::decode(const File& file, const CancelToken& cancel) {
  Image8& image = (*images_)[file.image];
  try {
    Image8 decoded = decodeImage(file.bytes, limits_, cancel);
    if (decoded.width != image.width || decoded.height != image.height || decoded.type != image.type)
      throw Error("E_IMAGE_CORRUPT", "the image is not of the size that its header says; export the image again");
    image.pixels = std::move(decoded.pixels);
  } catch (Error& error) {
    if (!error.pointer) error.at(file.where);
    throw;
  }
}

void ImageDecoder::wait(const CancelToken& cancel) {
  run(cancel);
  waitForThreads(cancel);
  threads_.clear();
  for (const std::exception_ptr& thrown : thrown_) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
      throw Error("X_MEMORY", "there is not enough memory to load the model");
    }
  }
}

void ImageDecoder::waitForThreads(const CancelToken& cancel) {
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, LOOK, [&] { return left_ == 0; })) cancel.check();
}

}  // namespace telar::asset
