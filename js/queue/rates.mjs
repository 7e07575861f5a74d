/** Tenants that are counted at once in this process. */
const MOST = 10_000;

/** How many jobs each tenant has added in the present span of time. */
export class Rates {
  #bounds;
  #span;
  #counts = new Map();

  /** @param {{tenantJobs?: number, tenantMs: number}} bounds without tenantJobs nothing is counted */
  constructor(bounds) {
    this.#bounds = bounds;
  }

  #present() {
    const span = Math.floor(Date.now() / this.#bounds.tenantMs);
    if (span !== this.#span || this.#counts.size > MOST) this.#counts.clear();
    this.#span = span;
    return this.#counts;
  }

  isFull(tenant) {
    const { tenantJobs } = this.#bounds;
    return tenantJobs !== undefined && (this.#present().get(tenant) ?? 0) >= tenantJobs;
  }

  count(tenant) {
    if (this.#bounds.tenantJobs === undefined) return;
    const counts = this.#present();
    counts.set(tenant, (counts.get(tenant) ?? 0) + 1);
  }
}
