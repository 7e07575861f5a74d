#include "telar/renderer.h"

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/picture_json.h"
#include "core/progress_json.h"
#include "frame/layers.h"
#include "frame/picture_facts.h"
#include "frame/pixel_mean.h"
#include "frame/sample_passes.h"
#include "gl/context.h"
#include "ibl/environment_cache.h"
#include "pass/background_pass.h"
#include "pass/describe.h"
#include "pass/layer/layer_pass.h"
#include "pass/lit_plan.h"
#include "pass/model/gpu_scenes.h"
#include "pass/plan/clear_color.h"
#include "pass/plan/draw_list.h"
#include "pass/shadow/ground_pass.h"
#include "pass/shadow/shadow_pass.h"
#include "pass/stage_timer.h"
#include "pass/surface/surface_pass.h"
#include "pass/target/frame_target.h"
#include "pass/target/settled_mask.h"
#include "pass/visible/visible_draws.h"

namespace telar {
namespace {

using Json = nlohmann::ordered_json;
using pass::Behind;
using pass::FramePlan;
using pass::StageTimer;

class GlRenderer final : public Renderer {
 public:
  explicit GlRenderer(const RendererOptions& options)
      : options_(options),
        context_(gl::Context::create(options.backend)),
        environments_(*context_, options.assetDirectory, {options.cacheDirectory, options.cacheBytes}, options.limits),
        surfaces_(*context_, options.limits),
        background_(*context_),
        shadows_(*context_),
        ground_(*context_),
        settled_(*context_),
        visible_(*context_, options.hiddenTriangles),
        buffer_(*context_, options.visibilityBuffer),
        scenes_(*context_) {}

  Frame draw(const std::shared_ptr<const Scene>& scene, const Shot& asked, std::span<const std::byte> environmentFile,
             const CancelToken& cancel, FrameInfo& info, const Progress& progress) override {
    StageTimer timer;
    context_->beginJob(cancel, options_.sliceMs);
    scenes_.forgetReleased();
    surfaces_.forgetMany();
    checkLimit("L_OUTPUT_SIZE", context_->capabilities().maxTextureSize, std::max(asked.width, asked.height), "");
    pass::GpuScene& gpu = scenes_.of(scene);
    Picture picture = prepare(*scene, asked, environmentFile, gpu, cancel, timer);
    std::optional<Picture> guide;
    if (picture.guided) guide.emplace(prepare(*scene, frame::guideOf(asked), environmentFile, gpu, cancel, timer));
    if (progress.isCpuAllowed()) waitForImages(*scene, cancel);  // it is for drawing alone
    progress.begin();
    Guess guess = guide ? drawGuide(*guide, *scene, gpu, cancel) : Guess();
    const pass::VisibilityBuffer::Frame found(buffer_);
    drawShadows(picture, *scene, gpu, cancel);
    const auto& [shot, plan, environment, background, warning] = picture.lit;
    const pass::SurfaceInputs inputs = inputsOf(picture, *scene, gpu, cancel);
    Frame frame = picture.accumulates() ? drawAveraged(inputs, picture, progress, std::move(guess.picture)).frame()
                                        : drawPass(inputs, {}, picture);
    if (picture.accumulates()) timer.lap("resolve");
    pass::VisibilityBuffer::Count count = buffer_.count();
    count.fragments += guess.fragments;
    Json json =
        pass::describeFrame(plan, shot, environment, *context_, {count, visible_.count(), gpu.texels(*scene)}, timer);
    json["glObjects"] = liveObjects();
    json["samples"] = picture.passes * target_->samples();
    tellEnd(json, progress, picture.end);
    json["programsCompiled"] = picture.compiled + (guide ? guide->compiled : 0);
    if (!plan.frame.debugOutput && !coverage_.empty()) json["picture"] = toJson(frame::pictureFacts(frame, coverage_));
    if (warning) json["warnings"] = Json::array({*warning});
    info.json = json.dump();
    if (environment) info.environmentSha256 = environment->sha256;
    if (!asked.layers.empty()) addLayers(frame, scene, asked, cancel, info);
    return frame;
  }

  void release(const Scene& scene) override { scenes_.release(scene); }
  std::string describe() const override { return pass::describeContext(*context_).dump(); }
  int liveObjects() const override { return context_->gl().liveObjects - scenes_.keptTextures(); }

 private:
  /// A picture that is drawn, in one pass or several.
  struct Picture {
    pass::LitPlan lit;
    StageTimer& timer;
    bool buffered = false;                 ///< by the visibility buffer
    bool guided = false;                   ///< its mean is joined with a guide
    glm::dvec2 shift{0};                   ///< px, of the pass
    std::optional<glm::dvec2> capturedAt;  ///< shift when the vertex stage ran for the buffer
    int compiled = 0;
    int passes = 1;
    Ending end{};

    bool accumulates() const { return lit.shot.resolve == Resolve::kLinear && !lit.plan.frame.debugOutput; }
  };

  /// A guide that is drawn.
  struct Guess {
    std::vector<glm::vec4> picture;
    std::size_t fragments = 0;
  };

  /// Plans a picture, uploads what it is drawn from and compiles its programs.
  Picture prepare(const Scene& scene, const Shot& asked, std::span<const std::byte> environmentFile,
                  pass::GpuScene& gpu, const CancelToken& cancel, StageTimer& timer) {
    Picture picture{pass::planLit(scene, asked, environmentFile, environments_, gpu, options_, cancel, timer), timer};
    FramePlan& plan = picture.lit.plan;
    Shot& shot = picture.lit.shot;
    // Without tone mapping a picture has no exposure, as in three.js; linear passes would have it.
    if (picture.accumulates() && shot.toneMapping == ToneMapping::kNone &&
        framePixelType(shot.output) == PixelType::kRgba8)
      shot.exposure = 1;
    picture.guided = picture.accumulates() && asked.denoise && frame::samplePassesOf(asked).count > 1;
    picture.buffered = buffer_.mayDraw(plan, shot, targetFor(shot));
    pass::VisibilityBuffer::use(plan, picture.buffered);
    surfaces_.upload(plan, scene, gpu, cancel);
    timer.lap("upload");
    picture.compiled = surfaces_.prepare(plan, cancel);
    timer.lap("compile");
    return picture;
  }

  void drawShadows(const Picture& picture, const Scene& scene, pass::GpuScene& gpu, const CancelToken& cancel) {
    const FramePlan& plan = picture.lit.plan;
    shadows_.draw(plan, scene, gpu, cancel);
    if (!plan.shadows.empty()) {
      context_->pacer().finish();
      picture.timer.lap("shadows");
    }
    shadows_.bind(plan.shadows, pass::SurfacePass::firstShadowUnit());
  }

  static pass::SurfaceInputs inputsOf(const Picture& picture, const Scene& scene, pass::GpuScene& gpu,
                                      const CancelToken& cancel) {
    const pass::LitPlan& lit = picture.lit;
    return {lit.plan, lit.shot, scene, gpu, lit.environment, lit.background, cancel};
  }

  Guess drawGuide(Picture& guide, const Scene& scene, pass::GpuScene& gpu, const CancelToken& cancel) {
    const pass::VisibilityBuffer::Frame found(buffer_);
    drawShadows(guide, scene, gpu, cancel);
    Frame pass = drawPass(inputsOf(guide, scene, gpu, cancel), {}, guide);
    const auto* pixels = reinterpret_cast<const glm::vec4*>(pass.pixels.data());
    Guess guess{{pixels, pixels + std::size_t{pass.width} * pass.height}, buffer_.count().fragments};
    target_->reuse(std::move(pass));
    return guess;
  }

  /// The layers of a picture that is drawn, and what info says of them.
  void addLayers(Frame& frame, const std::shared_ptr<const Scene>& scene, const Shot& shot, const CancelToken& cancel,
                 FrameInfo& info) {
    StageTimer timer;
    if (!layers_) layers_ = std::make_unique<pass::LayerPass>(*context_);
    frame.layers =
        layers_->draw({*scene, shot, scenes_.of(scene), surfaces_, shadows_, ground_, options_.limits, cancel});
    if (shot.hasLayer(Layer::kCoverage)) {
      FrameInfo unused;
      frame.layers.push_back(frame::coverageLayer(
          frame::alphaIsCoverage(shot) ? frame : draw(scene, frame::coverageShot(shot), {}, cancel, unused, {})));
    }
    timer.lap("layers");
    Json json = Json::parse(info.json);
    json["layers"] = frame::describeLayers(*scene, shot, frame.layers);
    json["ms"]["layers"] = timer.json()["layers"];
    info.json = json.dump();
  }

  pass::FrameTarget& targetFor(const Shot& shot) {
    const PixelType type = shot.resolve == Resolve::kLinear ? PixelType::kRgbaF32 : framePixelType(shot.output);
    const int samples = frame::samplePassesOf(shot).samples;
    if (!target_ || !target_->matches(shot.width, shot.height, samples, type)) {
      target_.reset();
      target_ = std::make_unique<pass::FrameTarget>(*context_, shot.width, shot.height, samples, type);
    }
    return *target_;
  }

  void drawBackground(const pass::SurfaceInputs& inputs, const Behind& behind) {
    pass::writeAlpha(context_->gl(), !behind.opaque);
    background_.draw(inputs.plan.camera, inputs.shot, *inputs.background, inputs.plan.frame);
    pass::writeAlpha(context_->gl(), true);
  }

  void drawGround(const pass::SurfaceInputs& inputs, const Behind& behind) {
    pass::writeAlpha(context_->gl(), !behind.opaque);
    ground_.draw(inputs.plan, inputs.shot, pass::SurfacePass::firstShadowUnit());
    pass::writeAlpha(context_->gl(), true);
  }

  /// One pass over everything that the shot shows, read back.
  /// @param settled  pixels that are not asked for, the upper row first; settled_ masks them; empty = none
  Frame drawPass(const pass::SurfaceInputs& inputs, std::span<const std::uint8_t> settled, Picture& picture) {
    if (picture.buffered) {
      if (findVisible(inputs, settled, picture)) return drawBuffered(inputs, picture.timer);
      picture.buffered = false;
      pass::VisibilityBuffer::use(picture.lit.plan, false);
      picture.compiled += surfaces_.prepare(picture.lit.plan, inputs.cancel);
    }
    surfaces_.uploadTextures(inputs);
    picture.timer.lap("upload");
    return drawTriangles(inputs, !settled.empty(), picture.timer);
  }

  /// The same by the GL's own rasterizer.
  Frame drawTriangles(pass::SurfaceInputs inputs, bool settled, StageTimer& timer) {
    const FramePlan& plan = inputs.plan;
    const Shot& shot = inputs.shot;
    pass::FrameTarget& target = targetFor(shot);
    inputs.transmission = drawBehind(inputs);
    inputs.samples = target.samples();
    target.bind();
    const pass::VisibleDraws::Frame found(visible_);
    visible_.find(plan, inputs.gpu, {shot.width, shot.height}, target.samples(), inputs.cancel);
    inputs.visible = &visible_;
    timer.lap("visibility");
    const bool debug = plan.frame.debugOutput;
    const Behind behind = pass::behindOf(plan, shot);
    pass::clearTarget(context_->gl(), behind.color);
    if (settled) settled_.draw();
    if (plan.environmentBackground && !debug) drawBackground(inputs, behind);
    surfaces_.draw({&plan.draws.opaque, &plan.draws.transmissive}, inputs);
    if (plan.ground && !debug) drawGround(inputs, behind);
    surfaces_.draw({&plan.draws.blended}, inputs);
    context_->pacer().finish();
    timer.lap("draw");
    return finished(target.read(), inputs, behind, timer);
  }

  /// Whether the visibility buffer can draw the pass.
  bool findVisible(pass::SurfaceInputs inputs, std::span<const std::uint8_t> settled, Picture& picture) {
    if (!picture.capturedAt) {
      pass::FrameTarget& target = targetFor(inputs.shot);
      target.bindPixel();
      buffer_.begin(inputs.plan, inputs.shot, target);
      inputs.samples = target.samples();
      inputs.buffer = &buffer_;
      inputs.captures = true;
      surfaces_.draw({&inputs.plan.draws.opaque}, inputs);
      picture.capturedAt = picture.shift;
      picture.timer.lap("vertices");
    }
    const bool found = buffer_.find(inputs.plan, inputs.shot, {glm::vec2(picture.shift - *picture.capturedAt), settled},
                                    inputs.cancel);
    picture.timer.lap("visibility");
    return found;
  }

  /// The same by the visibility buffer, which has found what is seen.
  Frame drawBuffered(pass::SurfaceInputs inputs, StageTimer& timer) {
    const FramePlan& plan = inputs.plan;
    const pass::UnreadLevels unread(plan, inputs.scene, inputs.gpu, buffer_);
    pass::FrameTarget& target = targetFor(inputs.shot);
    if (target.type() == PixelType::kRgba8) inputs.unread = &unread;  // floats show the last bit of a level of detail
    surfaces_.uploadTextures(inputs);
    timer.lap("upload");
    const Behind behind = pass::behindOf(plan, inputs.shot);
    Frame frame;
    if ((plan.environmentBackground || plan.ground) && !plan.frame.debugOutput) {
      target.bind();
      pass::clearTarget(context_->gl(), behind.color);
      if (plan.environmentBackground) drawBackground(inputs, behind);
      if (plan.ground) drawGround(inputs, behind);
      frame = target.read();
    } else {
      frame = target.filled(behind.color);
    }
    inputs.samples = target.samples();
    inputs.buffer = &buffer_;
    buffer_.bind();
    surfaces_.draw({&plan.draws.opaque}, inputs);
    context_->pacer().finish();
    timer.lap("draw");
    buffer_.compose(frame);
    return finished(std::move(frame), inputs, behind, timer);
  }

  /// @param frame  as it is read
  Frame finished(Frame frame, const pass::SurfaceInputs& inputs, const Behind& behind, StageTimer& timer) {
    const Shot& shot = inputs.shot;
    pass::FrameTarget::finish(frame, behind.opaque);
    if (inputs.samplePass == 0) {
      coverage_.clear();
      if (behind.opaque || !(inputs.plan.environmentBackground || pass::piercesColor(inputs.plan, shot)))
        coverage_ = frame::coverageOf(frame, shot.ground && !behind.opaque ? shot.ground->opacity : 0);
    }
    if (behind.opaque) frame::makeOpaque(frame);
    timer.lap("read");
    return frame;
  }

  /// The mean of passes that are moved by parts of a pixel, in linear light before tone mapping.
  /// @param picture  the projection of its plan is shifted and restored; its passes are those until every pixel settled
  /// @param guide  that the mean is joined with; empty = none
  frame::PixelMean drawAveraged(const pass::SurfaceInputs& frame, Picture& picture, const Progress& progress,
                                std::vector<glm::vec4> guide) {
    FramePlan& plan = picture.lit.plan;
    int& drawn = picture.passes;
    const Shot& shot = frame.shot;
    pass::SurfaceInputs inputs = frame;
    const frame::SamplePasses passes = frame::samplePassesOf(shot);
    const glm::dmat4 projection = plan.camera.projection;
    frame::PixelMean mean(shot, true, progress.isErrorAllowed(), passes.fewest());
    if (!guide.empty()) mean.setGuide(std::move(guide));
    const auto isEnough = [&] { return drawn > 0 && progress.isEnough(mean.standardError()); };
    for (drawn = 0; drawn < passes.count && !mean.allSettled() && !isEnough();) {
      inputs.samplePass = drawn;
      picture.shift = passes.shift(drawn++);
      plan.camera.projection = frame::shifted(projection, picture.shift, shot.width, shot.height);
      Frame pass = drawPass(inputs, mean.settled(), picture);
      const bool looked = mean.add(pass, drawn == passes.count);
      target_->reuse(std::move(pass));
      if (progress.previews.asked() && std::has_single_bit(static_cast<unsigned>(drawn)) && drawn < passes.count)
        progress.previews.put({mean.frame(), drawn});
      if (!looked) continue;
      settled_.set(mean.settled(), shot.width, shot.height);
      picture.timer.lap("settle");
    }
    plan.camera.projection = projection;
    picture.end = {drawn < passes.count && !mean.allSettled(), mean.standardError()};
    return mean;
  }

  /// Draws the transmission target. Null where nothing transmits.
  const pass::TransmissionTarget* drawBehind(const pass::SurfaceInputs& frame) {
    const pass::DrawList& draws = frame.plan.draws;
    if (draws.transmissive.empty()) {
      transmission_.reset();
      return nullptr;
    }
    Shot shot = frame.shot;
    const ThreeTerms& three = frame.plan.frame.three;
    const auto extent = pass::TransmissionTarget::extentOf(shot, three);
    if (!transmission_ || !transmission_->matches(extent)) {
      transmission_.reset();
      transmission_ = std::make_unique<pass::TransmissionTarget>(*context_, extent);
    }
    shot.exposure = 1;  // the transmissive surface in front is exposed
    shot.width = extent.width, shot.height = extent.height;
    pass::SurfaceInputs inputs{frame.plan,       shot,        frame.scene, frame.gpu, frame.environment,
                               frame.background, frame.cancel};
    inputs.samplePass = frame.samplePass;
    inputs.samples = extent.samples;
    transmission_->bind();
    pass::clearTarget(context_->gl(), pass::clearColorBehind(shot, three));
    if (frame.plan.environmentBackground) {
      shader::VariantKey linear = frame.plan.frame;
      linear.toneMapping = shader::ToneMapping::kNone;
      linear.outputLinear = true;
      background_.draw(frame.plan.camera, shot, *frame.background, linear);
    }
    surfaces_.draw({&draws.behind}, inputs);
    transmission_->resolve();
    // Without samples of its own to draw into, WebGL refuses to draw into the texture that is read.
    if (!draws.behindBackSides.empty() && extent.samples > 1) {
      inputs.transmission = transmission_.get();
      surfaces_.draw({&draws.behindBackSides}, inputs);
      transmission_->resolve();
    }
    return transmission_.get();
  }

  // The context is first, so that it is destroyed after everything that owns GL names.
  RendererOptions options_;
  std::unique_ptr<gl::Context> context_;
  ibl::EnvironmentCache environments_;
  pass::SurfacePass surfaces_;
  pass::BackgroundPass background_;
  pass::ShadowPass shadows_;
  pass::GroundPass ground_;
  pass::SettledMask settled_;
  pass::VisibleDraws visible_;
  pass::VisibilityBuffer buffer_;
  std::unique_ptr<pass::FrameTarget> target_;
  std::vector<std::uint8_t> coverage_;  ///< of the last picture by the model, from its first pass; empty = not known
  std::unique_ptr<pass::TransmissionTarget> transmission_;
  std::unique_ptr<pass::LayerPass> layers_;  ///< from the first frame with layers on
  pass::GpuScenes scenes_;
};

}  // namespace

std::unique_ptr<Renderer> Renderer::create(const RendererOptions& options) {
  return std::make_unique<GlRenderer>(options);
}

}  // namespace telar
