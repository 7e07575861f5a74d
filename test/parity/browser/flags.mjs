export const COMMON_FLAGS = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/** Flags by rasteriser. `mesa` is the one that parity is judged on: the server draws with the same llvmpipe. */
export const RASTERIZER_FLAGS = {
  mesa: ['--use-gl=angle', '--use-angle=gl-egl', '--ignore-gpu-blocklist'],
  swiftshader: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
};

/** The page around WebGL is drawn without GL: llvmpipe would take a fourth to a half of a test's time for it. */
export const PLAIN_PAGE_FLAGS = ['--disable-gpu-rasterization', '--disable-gpu-compositing'];
