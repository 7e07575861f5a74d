#if RECT_LIGHTS > 0
AreaLight rectLight(int i) {
  return AreaLight(rectAreaLights[i].position, rectAreaLights[i].halfWidth, rectAreaLights[i].halfHeight, rectAreaLights[i].color, false);
}
#endif
