import { cross, dot, length, subtract } from '../shot/frame.mjs';

const unit = (v) => v.map((x) => x / length(v));

/** Rows of the view matrix: world to camera axes, the camera looks along its -Z. */
function viewRows({ position, target, up }) {
  const back = unit(subtract(position, target));
  const right = unit(cross(up, back));
  return [right, cross(back, right), back].map((axis) => [...axis, -dot(axis, position)]);
}

/** Rows x, y, z, w of the clip coordinates, as WebGL has them: x, y, z in [-w, w]. */
function clipRows(camera, aspect) {
  const [x, y, z] = viewRows(camera);
  const { near, far } = camera;
  const times = (row, s) => row.map((value) => value * s);
  const plus = (row, w) => [row[0], row[1], row[2], row[3] + w];
  if (camera.projection === 'orthographic') {
    const s = 2 / camera.height;
    return [times(x, s / aspect), times(y, s), plus(times(z, -2 / (far - near)), -(far + near) / (far - near)), [0, 0, 0, 1]];
  }
  const s = 1 / Math.tan((camera.fovY * Math.PI) / 360);
  return [
    times(x, s / aspect), times(y, s),
    plus(times(z, -(far + near) / (far - near)), (-2 * far * near) / (far - near)), times(z, -1),
  ];
}

/**
 * Where a point of the world lies in the image: (X, Y, Z, W) = M (x, y, z, 1), metres; the pixel is (X / W, Y / W), from
 * the top left corner of the image, pixel centres at halves; Z / W is the depth, 0 near to 1 far; W <= 0 lies behind.
 * @param {object} shot resolved
 * @returns {number[]} 16 numbers, column-major, as THREE.Matrix4.fromArray takes them
 */
export function worldToPixel({ camera, size: { width, height } }) {
  const [x, y, z, w] = clipRows(camera, width / height);
  const rows = [
    x.map((value, i) => (width / 2) * (value + w[i])),
    y.map((value, i) => (height / 2) * (w[i] - value)),
    z.map((value, i) => (value + w[i]) / 2),
    w,
  ];
  return [0, 1, 2, 3].flatMap((column) => rows.map((row) => row[column] + 0));
}
