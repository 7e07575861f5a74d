import { millimetresOf, printedOf, printedText } from '../units.mjs';
import { wrongValue } from '../../shot/complain.mjs';
import { ABOUT } from '../read.mjs';
import { scaleText } from '../scale.mjs';
import { hexOf, isLong, listTable, shared } from './cells.mjs';

/** Pages that are lists: materials, sewing, labels, care, artwork, comments, revisions. */

/** A cell that shows a colour or an image. */
function swatchCell(layout, { color, image, item, name }) {
  if (image !== undefined) return { kind: 'image', file: layout.images.get(image).file, alt: layout.words('alt.image', { name: item ?? name }) };
  return color === undefined ? '' : { kind: 'swatch', colour: hexOf(color) };
}

/** Most colourways beside what else a line of the bill says, and in a table of their own. */
const COLOURS = { wide: [4, 9], upright: [1, 5] };

export function billPages(layout) {
  const { spec, words, page } = layout;
  const plain = (key, width) => ({ key, name: words(key), width });
  const item = { key: 'item', name: words('item'), width: 2, cell: (line) => ({ kind: 'strong', text: line.item }) };
  const colour = ({ name }) => ({ key: name, name, width: 1.2, cell: ({ colours }) => (Object.hasOwn(colours, name) ? colours[name] : '') });
  const [beside, apart] = page.isWide ? COLOURS.wide : COLOURS.upright;
  const isBeside = spec.colourways.length <= beside;
  const columns = [
    { key: 'image', name: words('swatch'), cell: (line) => swatchCell(layout, line) },
    plain('reference', 1.1),
    item,
    plain('supplier', 1.5),
    plain('composition', 2),
    plain('weight', 1.1),
    plain('quantity', 1),
    plain('placement', 1.6),
  ];
  const tables = listTable(layout, { list: 'bill', title: words('bill'), columns: [...columns, ...(isBeside ? spec.colourways.map(colour) : [])] });
  if (isBeside || !spec.bill.some(({ colours }) => Object.keys(colours).length > 0)) return tables;
  const title = `${words('bill')}: ${words('colourways')}`;
  const further = shared(spec.colourways, apart).flatMap((some) =>
    listTable(layout, { list: 'bill', title, columns: [plain('reference', 1.1), item, ...some.map(colour)] }),
  );
  return [...tables, ...further];
}

export function constructionPages(layout) {
  const { words } = layout;
  const plain = (key, width) => ({ key, name: words(key), width });
  return listTable(layout, {
    list: 'construction',
    breaks: false,
    title: words('construction'),
    columns: [
      { key: 'part', name: words('part'), width: 2, cell: ({ part }) => ({ kind: 'strong', text: part }) },
      plain('stitch', 1),
      plain('seam', 1),
      plain('density', 1),
      plain('allowance', 1),
      plain('thread', 1.2),
      plain('text', 3),
    ],
  });
}

export function labelPages(layout) {
  const { words } = layout;
  return listTable(layout, {
    list: 'labels',
    breaks: false,
    title: words('labels'),
    columns: [
      { key: 'image', name: '', cell: (item) => swatchCell(layout, item) },
      { key: 'name', name: words('item'), width: 1.4, cell: ({ name }) => ({ kind: 'strong', text: name }) },
      { key: 'text', name: words('text'), width: 3 },
      { key: 'placement', name: words('placement'), width: 2 },
      { key: 'size', name: words('size'), width: 1 },
    ],
  });
}

/** Width of a care symbol with its gap. */
const SYMBOL = 24;

export function carePages({ spec, words, page }) {
  const { symbols, text = '' } = spec.care;
  if (symbols.length === 0 && text === '') return [];
  return [
    {
      kind: 'care',
      break: false,
      title: words('care'),
      note: null,
      columns: Math.max(1, Math.min(symbols.length, Math.floor((page.box.width + 2) / SYMBOL))),
      symbols: symbols.map((key) => ({ file: `care-${key}.svg`, name: words(`care.${key}`) })),
      text,
    },
  ];
}

/** Room for a print beside its words, part of the page. */
const PRINT = 0.55;

/** How far the sides of a print may be off the proportions of its image, which is shown whole. */
const STRETCHED = 0.005;

/** @throws {TelarError} E_SPEC where width and height are not of the proportions of the image */
function checkProportions({ width, height }, image, i) {
  if (width === undefined || height === undefined) return;
  const fitting = (width * image.height) / image.width;
  if (Math.abs(height / fitting - 1) <= STRETCHED) return;
  const expected = `${Number(fitting.toPrecision(4))}, as the image has ${image.width} x ${image.height} pixels, or no height`;
  throw wrongValue(['artwork', i, 'height'], expected, height, ABOUT);
}

function printOf(layout, print, i) {
  const { spec, words, page, images } = layout;
  const image = print.image === undefined ? undefined : images.get(print.image);
  const wide = print.width === undefined ? undefined : millimetresOf(print.width, spec.units);
  const tall = print.height === undefined ? undefined : millimetresOf(print.height, spec.units);
  const sideText = (key) => {
    if (print[key] === undefined) return undefined;
    const printed = printedOf(print[key], spec);
    if (!printed.isKept) layout.roundedAt(['artwork', i, key], print[key], printed);
    return printedText(printed);
  };
  const facts = [
    ['width', sideText('width')],
    ['height', sideText('height')],
    ['position', print.position],
    ['technique', print.technique],
    ['colours', print.colours],
    ['text', print.text],
  ];
  const shown = {
    name: print.name,
    file: null,
    width: 0,
    height: 0,
    alt: '',
    note: '',
    long: isLong(print.text) || isLong(print.position) || isLong(print.colours),
    changed: layout.isChanged('artwork', i),
  };
  if (image) {
    checkProportions(print, image, i);
    const proportion = image.height / image.width;
    const size = { width: wide ?? (tall ? tall / proportion : 60), height: tall ?? (wide ?? 60) * proportion };
    const shrink = Math.min(1, (page.box.width * PRINT) / size.width, (page.box.height - 20) / size.height);
    const isSized = wide !== undefined || tall !== undefined;
    const note = !isSized ? '' : shrink === 1 ? words('actual') : words('reduced', { scale: scaleText(1 / shrink) });
    Object.assign(shown, { file: image.file, width: size.width * shrink, height: size.height * shrink, alt: words('alt.image', { name: print.name }), note });
  }
  return { ...shown, facts: facts.filter(([, value]) => value).map(([key, value]) => [words(key), value]) };
}

export function artworkPages(layout) {
  const { spec, words } = layout;
  if (spec.artwork.length === 0) return [];
  const note = `${words('units')} ${words(`unit.${spec.printedUnits}`)}`;
  return [{ kind: 'artwork', break: true, title: words('artwork'), note, prints: spec.artwork.map((print, i) => printOf(layout, print, i)) }];
}

export function closingPages(layout) {
  const { spec, words } = layout;
  const comments = spec.notes ? [{ kind: 'words', break: false, title: words('notes'), note: null, text: spec.notes }] : [];
  const plain = (key, width) => ({ key, name: words(key), width });
  const revisions = listTable(layout, {
    list: 'revisions',
    title: words('revisions'),
    breaks: false,
    columns: [
      { key: 'revision', name: words('revision'), cell: ({ revision }) => ({ kind: 'strong', text: revision }) },
      plain('date'),
      plain('author'),
      { key: 'text', name: words('text'), width: 5 },
    ],
  });
  return [...comments, ...revisions];
}
