#include "images.h"

#include "handles.h"
#include "state.h"
#include "telar/codec.h"

namespace telar::addon {

Napi::Value decodeImage(const Napi::CallbackInfo& info) {
  auto file = unwrap<BytesHandle>(info[0]).bytes();
  const Limits limits = limitsFromJs(info[1]);
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[2]).token);
  return State::of(info.Env()).runOnPool(info.Env(), job, [job, file, limits] {
    auto image = std::make_shared<Image8>(telar::decodeImage(*file, limits, job->cancel));
    if (image->type != TexelType::kByte) {
      throw Error("E_IMAGE_FORMAT",
                  "the image is " + image->format + ", which are no 8-bit texels; convert it to PNG to compare it");
    }
    job->value = [image](Napi::Env env) {
      Napi::Object result = Napi::Object::New(env);
      result["width"] = image->width;
      result["height"] = image->height;
      result["data"] = Napi::Buffer<std::uint8_t>::Copy(env, image->pixels.data(), image->pixels.size());
      return result;
    };
  });
}

Napi::Value encodePng(const Napi::CallbackInfo& info) {
  auto pixels = unwrap<BytesHandle>(info[0]).bytes();
  const std::uint32_t width = info[1].ToNumber().Uint32Value(), height = info[2].ToNumber().Uint32Value();
  if (width == 0 || height == 0 || pixels->size() != std::size_t{4} * width * height) {
    throw Napi::TypeError::New(info.Env(), "native telar expected width * height RGBA8 pixels");
  }
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[3]).token);
  return State::of(info.Env()).runOnPool(info.Env(), job, [job, pixels, width, height] {
    const Frame frame{width, height, PixelType::kRgba8, {pixels->begin(), pixels->end()}};
    auto file = std::make_shared<Bytes>(encode(frame, OutputOptions(), job->cancel));
    job->value = [file](Napi::Env env) { return bytesToJs(env, std::move(*file)); };
  });
}

}  // namespace telar::addon
