/**
 * Lay the pieces' flat charts side by side in one square picture and draw a value per vertex into it.
 */

const PADDING = 5;

function chartOf({ flat }) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < flat.length; i += 2) {
    box[0] = Math.min(box[0], flat[i]);
    box[1] = Math.min(box[1], flat[i + 1]);
    box[2] = Math.max(box[2], flat[i]);
    box[3] = Math.max(box[3], flat[i + 1]);
  }
  return { low: [box[0], box[1]], width: box[2] - box[0], height: box[3] - box[1] };
}

// Shelves, tallest first. Returns null when the charts do not fit at this scale.
function tryPack(charts, order, size, scale) {
  let [x, y, shelf] = [PADDING, PADDING, 0];
  const places = [];
  for (const index of order) {
    const [w, h] = [Math.ceil(charts[index].width * scale), Math.ceil(charts[index].height * scale)];
    if (x + w + PADDING > size) {
      x = PADDING;
      y += shelf + 2 * PADDING;
      shelf = 0;
    }
    if (x + w + PADDING > size || y + h + PADDING > size) return null;
    places[index] = [x, y];
    x += w + 2 * PADDING;
    shelf = Math.max(shelf, h);
  }
  return places;
}

/**
 * @param {object[]} pieces - With `flat` coordinates in metres.
 * @param {number} size - Pixels along one edge.
 * @returns {{uv: Float64Array[], texelsPerMetre: number}} Atlas coordinates 0..1 per piece, v down.
 */
export function packCharts(pieces, size) {
  const charts = pieces.map(chartOf);
  const order = charts.map((_, i) => i).sort((a, b) => charts[b].height - charts[a].height || a - b);
  let scale = size;
  let places = tryPack(charts, order, size, scale);
  while (!places) {
    scale *= 0.99;
    places = tryPack(charts, order, size, scale);
  }
  const uv = pieces.map(({ flat }, p) => Float64Array.from(flat, (value, i) => (places[p][i % 2] + (value - charts[p].low[i % 2]) * scale) / size));
  return { uv, texelsPerMetre: scale };
}

function fillTriangle(image, size, corners, values) {
  const [[ax, ay], [bx, by], [cx, cy]] = corners;
  const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  if (Math.abs(area) < 1e-12) return;
  const reach = 0.75;
  for (let y = Math.max(0, Math.floor(Math.min(ay, by, cy) - reach)); y <= Math.min(size - 1, Math.max(ay, by, cy) + reach); y++) {
    for (let x = Math.max(0, Math.floor(Math.min(ax, bx, cx) - reach)); x <= Math.min(size - 1, Math.max(ax, bx, cx) + reach); x++) {
      const [px, py] = [x + 0.5, y + 0.5];
      const wb = ((px - ax) * (cy - ay) - (py - ay) * (cx - ax)) / area;
      const wc = ((bx - ax) * (py - ay) - (by - ay) * (px - ax)) / area;
      const wa = 1 - wb - wc;
      if (Math.min(wa, wb, wc) < -1e-6) continue;
      image[y * size + x] = wa * values[0] + wb * values[1] + wc * values[2];
    }
  }
}

// Grow the charts into their padding, so that filtering and smaller levels never reach an empty texel;
// what lies beyond takes the mean.
function growEdges(image, size) {
  let edge = [];
  for (let i = 0; i < image.length; i++) if (!Number.isNaN(image[i])) edge.push(i);
  const mean = edge.reduce((sum, i) => sum + image[i], 0) / edge.length;
  for (let round = 0; round < 2 * PADDING; round++) {
    const grown = [];
    for (const i of edge) {
      for (const j of [i - 1, i + 1, i - size, i + size]) {
        if (j < 0 || j >= image.length || !Number.isNaN(image[j])) continue;
        image[j] = image[i];
        grown.push(j);
      }
    }
    edge = grown;
  }
  return image.map((value) => (Number.isNaN(value) ? mean : value));
}

/**
 * @param {object[]} pieces
 * @param {Float64Array[]} uv - From `packCharts`.
 * @param {Float64Array[]} values - One per vertex, 0..1.
 * @returns {Float64Array} size * size values, row 0 at v = 0, no empty texel.
 */
export function drawAtlas(pieces, uv, values, size) {
  const image = new Float64Array(size * size).fill(NaN);
  pieces.forEach(({ indices }, p) => {
    for (let t = 0; t < indices.length; t += 3) {
      const at = [indices[t], indices[t + 1], indices[t + 2]];
      fillTriangle(
        image,
        size,
        at.map((i) => [uv[p][i * 2] * size, uv[p][i * 2 + 1] * size]),
        at.map((i) => values[p][i]),
      );
    }
  });
  return growEdges(image, size);
}
