// next.config.mjs
export default {
  // The addon and the pool's processes are files: they are not bundled, and come along with `output: 'standalone'`.
  serverExternalPackages: ['telar'],
  outputFileTracingIncludes: { '/thumbnails': ['./node_modules/telar/**/*', './node_modules/telar-linux-*/**/*'] },
};
