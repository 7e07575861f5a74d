import { buildConstraints } from './constraints.mjs';
import { SelfContact } from './contact.mjs';

/**
 * Extended position-based dynamics with small steps: one pass over all constraints per step.
 * src: Macklin, Storey, Lu, Terdiman, Chentanez, Jeschke, Mueller 2019, "Small steps in physics simulation"
 */
export class Drape {
  /**
   * @param {object} garment - From `sewGarment`.
   * @param {Float64Array} positions - xyz per particle, metres; moved in place.
   * @param {object} options - `size` measures; `body` distance reader from `bakeBody`; `spacing` metres between particles;
   *   `step` seconds.
   */
  constructor(garment, positions, { size, body, spacing, step }) {
    this.positions = positions;
    this.before = positions.slice();
    this.velocity = new Float64Array(positions.length);
    this.step = step;
    this.body = body;
    this.constraints = buildConstraints(garment, size);
    this.inverseMass = this.constraints.mass.map((mass) => 1 / mass);
    this.contact = new SelfContact(garment.particleCount, this.constraints.stretchPairs, spacing * 0.72);
    this.margin = spacing * 0.35;
    this.skin = 0.0035;
    this.friction = 0.35;
  }

  /**
   * @param {number} steps - Count.
   * @param {(progress: number) => {damping: number, pull: number[], body?: Function}} control - Damping in 1/s,
   *   the acceleration of the whole cloth in m/s2, and a moving body, over the run's progress of 0..1.
   */
  run(steps, control) {
    for (let i = 0; i < steps; i++) {
      const { damping, pull, body } = control(i / steps);
      if (body) this.body = body;
      if (i % 10 === 0) this.contact.search(this.positions, this.margin);
      this.#predict(damping, pull);
      this.#stretch();
      this.#bend();
      this.contact.solve(this.positions, this.before, 0.3);
      this.#collide();
      this.#finish();
    }
  }

  #predict(damping, pull) {
    const { positions, before, velocity, step } = this;
    before.set(positions);
    const keep = Math.max(0, 1 - damping * step);
    for (let i = 0; i < positions.length; i++) {
      velocity[i] = velocity[i] * keep + pull[i % 3] * step;
      positions[i] += velocity[i] * step;
    }
  }

  #stretch() {
    const { positions: p, inverseMass } = this;
    const { stretchPairs, rest, stretchStiffness } = this.constraints;
    const scale = 1 / (this.step * this.step);
    // Always in the same order: a sweep that alternates keeps the cloth trembling.
    for (let i = 0; i < rest.length; i++) {
      const [a, b] = [stretchPairs[i * 2], stretchPairs[i * 2 + 1]];
      const [x, y, z] = [p[b * 3] - p[a * 3], p[b * 3 + 1] - p[a * 3 + 1], p[b * 3 + 2] - p[a * 3 + 2]];
      const length = Math.sqrt(x * x + y * y + z * z);
      if (length < 1e-9) continue;
      const excess = length - rest[i];
      // Knit gives way in compression long before it does in tension.
      const softness = scale / (stretchStiffness[i] * (excess < 0 ? 0.8 : 1));
      const pull = excess / ((inverseMass[a] + inverseMass[b] + softness) * length);
      const [pa, pb] = [pull * inverseMass[a], pull * inverseMass[b]];
      p[a * 3] += x * pa;
      p[a * 3 + 1] += y * pa;
      p[a * 3 + 2] += z * pa;
      p[b * 3] -= x * pb;
      p[b * 3 + 1] -= y * pb;
      p[b * 3 + 2] -= z * pb;
    }
  }

  #bend() {
    const { positions: p, inverseMass } = this;
    const { bendParticles: q, bendWeights: w, bendStiffness } = this.constraints;
    const scale = 1 / (this.step * this.step);
    for (let i = 0, o = 0; i < bendStiffness.length; i++, o += 4) {
      const [a, b, c, d] = [q[o], q[o + 1], q[o + 2], q[o + 3]];
      const [wa, wb, wc, wd] = [w[o], w[o + 1], w[o + 2], w[o + 3]];
      const [ma, mb, mc, md] = [inverseMass[a] * wa, inverseMass[b] * wb, inverseMass[c] * wc, inverseMass[d] * wd];
      const inverse = 1 / (ma * wa + mb * wb + mc * wc + md * wd + scale / bendStiffness[i]);
      for (let k = 0; k < 3; k++) {
        const curl = (wa * p[a * 3 + k] + wb * p[b * 3 + k] + wc * p[c * 3 + k] + wd * p[d * 3 + k]) * inverse;
        p[a * 3 + k] -= curl * ma;
        p[b * 3 + k] -= curl * mb;
        p[c * 3 + k] -= curl * mc;
        p[d * 3 + k] -= curl * md;
      }
    }
  }

  #collide() {
    const { positions: p, before, body, skin, friction } = this;
    const normal = new Float64Array(3);
    for (let i = 0; i < p.length; i += 3) {
      const depth = skin - body(p[i], p[i + 1], p[i + 2], normal);
      if (depth <= 0) continue;
      const length = Math.hypot(normal[0], normal[1], normal[2]) || 1;
      // A piece that starts deep inside comes out over many steps, not as a shot.
      const push = Math.min(depth, 0.002) / length;
      for (let c = 0; c < 3; c++) p[i + c] += normal[c] * push;
      const slip = [p[i] - before[i], p[i + 1] - before[i + 1], p[i + 2] - before[i + 2]];
      const along = (slip[0] * normal[0] + slip[1] * normal[1] + slip[2] * normal[2]) / (length * length);
      for (let c = 0; c < 3; c++) slip[c] -= along * normal[c];
      const slide = Math.hypot(slip[0], slip[1], slip[2]);
      const held = slide > 0 ? Math.min(1, (friction * Math.max(push * length, 2e-6)) / slide) : 0;
      for (let c = 0; c < 3; c++) p[i + c] -= slip[c] * held;
    }
  }

  #finish() {
    const { positions, before, velocity, step } = this;
    // 3 m/s: faster cloth is an initial overlap coming apart, and would tunnel.
    const limit = 3 * step;
    for (let i = 0; i < positions.length; i++) {
      const moved = Math.min(limit, Math.max(-limit, positions[i] - before[i]));
      positions[i] = before[i] + moved;
      velocity[i] = moved / step;
    }
  }
}
