import { versions } from '../api/versions.mjs';

/**
 * Spans of OpenTelemetry, where the package @opentelemetry/api is installed; what they are sent to is the owner's SDK. No span has an address with its
 * parameters, a header or a name of a file.
 */

const NAME = 'telar';

/** Of performance.now(), as milliseconds since 1970. */
const clock = (ms) => performance.timeOrigin + ms;

/** One span, and those beneath it. */
class Span {
  #api;
  #tracer;
  #span;
  #context;

  constructor(api, tracer, span, parent) {
    this.#api = api;
    this.#tracer = tracer;
    this.#span = span;
    this.#context = api.trace.setSpan(parent, span);
  }

  /** @param {string} name @param {number} from @param {number} to of performance.now() @param {Record<string, string | number>} [attributes] */
  add(name, from, to, attributes) {
    this.#tracer.startSpan(name, { startTime: clock(from), attributes }, this.#context).end(clock(to));
  }

  /** @param {{attributes: Record<string, string | number>, code?: string, isFault?: boolean}} facts code: of the error */
  end({ attributes, code, isFault }) {
    this.#span.setAttributes({ ...attributes, ...(code && { 'error.type': code }) });
    if (isFault) this.#span.setStatus({ code: this.#api.SpanStatusCode.ERROR, message: code });
    this.#span.end();
  }
}

const NO_SPAN = Object.freeze({ add() {}, end() {} });
export const NO_SPANS = Object.freeze({ request: () => NO_SPAN, job: () => NO_SPAN });

class Spans {
  #api;
  #tracer;

  constructor(api) {
    this.#api = api;
    this.#tracer = api.trace.getTracer(NAME, versions.telar);
  }

  /** Beneath what the owner's own instrumentation has begun, or what the headers say (W3C trace context, where the owner's SDK reads it). */
  request(headers, name, attributes) {
    const { context, propagation, trace, SpanKind } = this.#api;
    const active = context.active();
    const parent = trace.getSpan(active) ? active : propagation.extract(active, headers);
    return new Span(this.#api, this.#tracer, this.#tracer.startSpan(name, { kind: SpanKind.SERVER, attributes }, parent), parent);
  }

  /** A job that nobody waits for. */
  job(attributes) {
    const { ROOT_CONTEXT } = this.#api;
    return new Span(this.#api, this.#tracer, this.#tracer.startSpan('telar.job', { attributes }, ROOT_CONTEXT), ROOT_CONTEXT);
  }
}

/** @param {() => Promise<object>} [load] gives the package; tests give others */
export async function openSpans(load = () => import('@opentelemetry/api')) {
  try {
    return new Spans(await load());
  } catch {
    return NO_SPANS;
  }
}
