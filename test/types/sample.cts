// Checked by tsc against the published entries, never run: require() gives the same types.
import telar = require('telar');
import shot = require('telar/shot');
import compare = require('telar/compare');

export const drawn: Promise<telar.Image> = telar.createRenderer().then((renderer) => renderer.render('shirt.glb', { exposure: 2 }));
export const resolved: shot.ResolvedShot = shot.resolveShot({ camera: { view: 'top' } }, { min: [0, 0, 0], max: [1, 1, 1] });
export const within = (a: compare.Image, b: compare.Image): boolean => compare.judge(compare.compareImages(a, b), 'parity').pass;
export const isOurs = (error: unknown): boolean => error instanceof telar.TelarError && error.retryable;
