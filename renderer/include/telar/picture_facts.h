#pragma once

namespace telar {

/// What a picture shows of the model: tells the empty and the wrongly exposed one. Parts 0..1.
struct PictureFacts {
  double coverage = 0;  ///< of all pixels: show something of the model
  /// Of the pixels that the model covers wholly: no channel is above 2/255, none below 250/255, or each is at
  /// one of these ends and they differ. Of linear radiance: 0, and nothing else.
  double dark = 0, bright = 0, saturated = 0;
};

}  // namespace telar
