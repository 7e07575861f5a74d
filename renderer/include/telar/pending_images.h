#pragma once
#include "telar/cancel.h"

namespace telar {

/// Images of a scene that other threads decode while the scene is used: their pixels and nothing else is written, and
/// nothing reads these before wait() has returned. One thread at a time waits.
class PendingImages {
 public:
  PendingImages() = default;
  PendingImages(const PendingImages&) = delete;
  PendingImages& operator=(const PendingImages&) = delete;
  /// Stops what is not done.
  virtual ~PendingImages() = default;

  /// Until all are decoded. Where it is cancelled, the images that it would have decoded itself are lost.
  /// @throws what decoding the first one that is damaged has thrown, each time: Error{E_IMAGE_*, L_IMAGE_*} with the
  ///         image's pointer, X_MEMORY; X_CANCELLED, X_TIMEOUT
  virtual void wait(const CancelToken& cancel) = 0;
};

}  // namespace telar
