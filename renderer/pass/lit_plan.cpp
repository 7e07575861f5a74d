#include "pass/lit_plan.h"

#include "pass/describe.h"
#include "pass/plan/fragment_estimate.h"
#include "pass/plan/simplified_draws.h"
#include "pass/plan/triangle_order.h"
#include "pass/surface/surface_pass.h"

namespace telar::pass {

LitPlan planLit(const Scene& scene, const Shot& asked, std::span<const std::byte> environmentFile,
                ibl::EnvironmentCache& environments, GpuScene& gpu, const RendererOptions& options,
                const CancelToken& cancel, StageTimer& timer) {
  LitPlan lit{asked, planDraws(scene, asked, options.limits, options.allFeatures)};
  limitDetail(lit.plan, scene, asked, gpu, cancel);
  const auto extents = [&gpu](const Primitive& part) -> const PartExtents& { return gpu.extents(part); };
  checkFragments(lit.plan, asked, extents, options.limits, cancel);
  timer.lap("plan");
  const bool wanted = asked.environment.source != Shot::Environment::Source::kNone;
  const EnvironmentForms forms = environmentForms(lit.plan, asked);
  const auto environmentOf = [&](const ibl::EnvironmentUses& uses) {
    return &environments.get(asked.environment, environmentFile, uses, cancel);
  };
  if (wanted && (lit.plan.environment || lit.plan.environmentBackground)) lit.environment = environmentOf(forms.lit);
  lit.background = wanted && forms.seen ? environmentOf(*forms.seen) : lit.environment;
  const ibl::Suns suns = lit.environment && forms.lit.suns ? lit.environment->suns.value_or(ibl::Suns()) : ibl::Suns();
  if (!suns.list.empty() && asked.shading != ShadingModel::kThree) {
    lit.shot = withSuns(asked, suns);
    Limits limits = options.limits;
    limits.lights += suns.list.size();
    lit.plan = planDraws(scene, lit.shot, limits, options.allFeatures);
    limitDetail(lit.plan, scene, asked, gpu, cancel);
  } else if (!suns.list.empty()) {
    lit.warning = rangeWarning(suns.share);
  }
  timer.lap("environment");
  orderTriangles(lit.plan, cancel);
  timer.lap("plan");
  return lit;
}

}  // namespace telar::pass
