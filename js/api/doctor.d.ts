import type { PlainError } from '../error/index.js';
import type { Backend } from './loading.js';
import type { Versions } from './versions.js';

export type BackendReport =
  | { backend: Backend; works: true; vendor?: string; renderer?: string; version?: string; software?: boolean }
  | { backend: Backend; works: false; failure: string; cure?: string };

export interface DoctorReport {
  ok: boolean;
  versions: Versions;
  system: string;
  native: { path: string } | { error: PlainError };
  chosen: Backend | null;
  reason: string;
  backends: BackendReport[];
  /** Whether quality "reference" can be drawn. */
  reference: { works: true; version: string } | { works: false; failure: string };
  /** CPU milliseconds of two small pictures, by GL, as measured here for `quality: {budgetMs}`; empty before its first picture. tracer: 0 without Embree. */
  calibration: Record<string, { raster: number; tracer: number }>;
  /** Whether .hdr, .exr, TIFF and ICC profiles can be had; PNG, JPEG, WebP and KTX2 always can. */
  imageFiles: { works: true } | { works: false; failure: string };
  /** What a worker of telar/pool gives up, what this kernel refuses, and whether failed allocations are noticed; empty where the native part is missing. */
  isolation: IsolationStep[];
}

/** A right that a worker of telar/pool gives up, or what it watches of itself; `failure`: what the kernel said, as "EPERM", or why else not; null where it did. */
export interface IsolationStep {
  step: string;
  failure: string | null;
}

/**
 * Tells which GL backends this machine has, which one "auto" chooses and why, and the cure for those that are missing. It does not
 * throw for what it finds.
 * @example
 * const { ok, chosen, reason } = await doctor();
 * if (!ok) console.error(reason);
 */
export function doctor(): Promise<DoctorReport>;
