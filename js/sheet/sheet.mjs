import { careSvg } from './care.mjs';
import { changesBetween } from './changes.mjs';
import { Engine, TEMPLATE, bundledFonts } from './engine.mjs';
import { checkCharacters, checkText, readFonts } from './fonts.mjs';
import { readImages } from './images.mjs';
import { Layout } from './layout.mjs';
import { lengthOf } from './lengths.mjs';
import { oneLine } from './names.mjs';
import { readOptions } from './options.mjs';
import { wrongValue } from '../shot/complain.mjs';
import { pagesOf, pngOf } from './output.mjs';
import { calloutPages } from './pages/callouts.mjs';
import { colourwayPages } from './pages/colourways.mjs';
import { coverPage } from './pages/cover.mjs';
import { detailPages } from './pages/details.mjs';
import { artworkPages, billPages, carePages, closingPages, constructionPages, labelPages } from './pages/lists.mjs';
import { measurePages } from './pages/measures.mjs';
import { swatchPages } from './pages/swatches.mjs';
import { viewPages } from './pages/views.mjs';
import { Pictures } from './pictures.mjs';
import { pointOf } from './places.mjs';
import { ABOUT, readSpec } from './read.mjs';
import { Squares, colourListOf } from './squares.mjs';
import { shownBy } from './shown.mjs';
import { eachOnce } from './warnings.mjs';
import { wordsOf } from './words.mjs';

/** Makes a sheet: reads the spec, lays out its pages, draws their pictures together, and has them set. */

const PAGES = [
  coverPage,
  viewPages,
  calloutPages,
  detailPages,
  measurePages,
  colourwayPages,
  swatchPages,
  billPages,
  constructionPages,
  labelPages,
  carePages,
  artworkPages,
  closingPages,
];

/** Fields at the head of each page, and the one for the logo. */
const HEAD_FIELDS = ['season', 'brand', 'baseSize', 'date', 'revision'];

/** Most characters of what stands at the head of every page; the first page has it in full. */
const HEAD = { style: 28, name: 48, field: 20 };

const cut = (text = '', most) =>
  [...text].length > most
    ? `${[...text]
        .slice(0, most - 1)
        .join('')
        .trimEnd()}…`
    : text;

/** What the template reads. */
function documentOf(layout, sections, images) {
  const { spec, words, page, facts } = layout;
  const { header } = spec;
  const logo = images.get(header.logo);
  const title = [header.style, header.name].filter(Boolean).join(' ') || facts.name || words('sheet');
  return {
    title: `${words('sheet')}: ${title}`,
    author: header.author ?? '',
    language: spec.language.split('-')[0],
    fonts: layout.fonts,
    page,
    words: { page: words('page'), of: words('of') },
    head: {
      style: cut(header.style, HEAD.style),
      name: cut(header.name, HEAD.name),
      fields: HEAD_FIELDS.filter((field) => header[field]).map((field) => [cut(words(field), HEAD.field), cut(header[field], HEAD.field)]),
      logo: logo ? { file: logo.file, alt: words('alt.logo', { brand: header.brand ?? '' }) } : null,
    },
    foot: words('sheet'),
    sections,
  };
}

/** @throws {TelarError} E_SPEC */
function folderOf({ template }, templates) {
  if (Object.hasOwn(templates, template)) return templates[template];
  if (template === 'telar') return TEMPLATE;
  throw wrongValue(['template'], ['telar', ...Object.keys(templates)].map((name) => `"${name}"`).join(' or '), template, ABOUT);
}

async function filesOf(engine, document, { format, ppi }) {
  if (format === 'pdf') return [engine.pdf(document)];
  const pages = pagesOf(engine.svg(document), document.page);
  if (format === 'svg') return pages.map((text) => Buffer.from(text));
  const files = [];
  for (const page of pages) files.push(await pngOf(page, document.page, ppi));
  return files;
}

/**
 * Reads a spec and lays its pages out: where everything stands, before any picture is drawn.
 * @param {object} source as createSheet's
 * @param {object} given a spec
 * @param {object} settings of readOptions
 * @returns {Promise<{layout: Layout, sections: object[], engine: Engine, pictures: Pictures, images: Map}>} the engine is to be closed
 */
export async function layOut(source, given, settings) {
  const { renderer, fonts: extra, resolve, templates, shot, previous, limits, timeoutMs, signal } = settings;
  const call = { signal, ...(timeoutMs !== undefined && { timeoutMs }) };
  const model = source?.facts ? source : await renderer.load(source, { signal });
  const told = await renderer.factsOf(model, {}, { signal });
  const facts = { ...told, name: oneLine(told.name) };
  const spec = readSpec(given, facts);
  const shown = await shownBy(spec.views, model, { signal });
  const words = wordsOf(spec);
  const bundled = await bundledFonts();
  const fonts = readFonts([...bundled, ...extra], bundled.length);
  checkCharacters(given, fonts);
  // The name of the model stands where the spec has none.
  const isNamed = spec.header.name || spec.header.style;
  if (facts.name && !isNamed) checkText(facts.name, fonts, { place: 'the name of the model, in place of spec.header.name', pointer: '/header/name' });
  const images = await readImages(spec, { resolve, limits, signal });
  const engine = await Engine.create({ fonts: [...bundled, ...extra], folder: folderOf(spec, templates) });
  try {
    const pictures = new Pictures(renderer, { ppi: spec.ppi, shot, flats: spec.flats, call });
    const changed = new Set(previous ? changesBetween(previous, given) : []);
    const layout = new Layout({ spec, facts, shown, words, pictures, engine, changed, images, fonts: fonts.families });
    layout.squares = new Squares({ model, renderer, call, list: await colourListOf(spec, { resolve, fonts }) });
    layout.colours = [];
    layout.pointOf = (item, view, { pointer, picture }) =>
      pointOf(item, {
        pointer,
        picture,
        basis: layout.extent(view).basis,
        variant: view.variant,
        middleOf: (part) => pictures.middleOf(layout.extent(view), { ratio: picture.ratio, ...layout.seen(view) }, part),
        renderer,
        model: layout.seen(view).model,
        call,
      });
    const warn = (...told) => layout.warn(...told);
    layout.lengthOf = (measure, id) => {
      const { variant } = spec.views.find(({ name }) => name === measure.view);
      return lengthOf(measure, { model, anchors: spec.anchors, variant, pointer: `/measures/${id}`, call, warn });
    };
    const sections = [];
    for (const pages of PAGES) sections.push(...(await pages(layout)));
    return { layout, sections, engine, pictures, images };
  } catch (thrown) {
    engine.close();
    throw thrown;
  }
}

/** js/sheet/index.d.ts documents it. */
export async function createSheet(source, given, options = {}) {
  const settings = readOptions(options);
  const start = performance.now();
  const { layout, sections, engine, pictures, images } = await layOut(source, given, settings);
  try {
    const laidOut = performance.now();
    const drawn = await pictures.draw(settings.onProgress);
    const pictured = performance.now();
    for (const [file, { data }] of drawn) engine.add(file, data);
    for (const { file, data } of images.values()) engine.add(file, data);
    for (const key of layout.spec.care.symbols) engine.add(`care-${key}.svg`, Buffer.from(careSvg(key)));
    const { format } = settings;
    const files = await filesOf(engine, documentOf(layout, sections, images), { format, ppi: layout.spec.ppi });
    const milliseconds = { layout: laidOut - start, pictures: pictured - laidOut, typeset: performance.now() - pictured, total: performance.now() - start };
    return {
      format,
      files,
      info: { pictures: drawn.size, warnings: warningsOf(layout, drawn), measures: measuresOf(layout), swatches: layout.colours, milliseconds },
    };
  } finally {
    engine.close();
  }
}

/** What of the model, of the spec and of the pictures is to be told. @param {Map<string, {info?: object}>} drawn flats have no info */
const warningsOf = ({ facts, warnings }, drawn) => eachOnce([facts.warnings ?? [], warnings, ...[...drawn.values()].map(({ info }) => info?.warnings ?? [])]);

const measuresOf = ({ measured = [] }) => measured.filter(({ length }) => length !== undefined).map(({ code, length }) => ({ code, millimetres: length }));
