import { between, oneOf, seeded } from './random.mjs';

/** Specs of whole documents that are hard to lay out, for the square of square.mjs; each text has words that no other has. */

const HEBREW = 'תפר צד בתפירה כפולה עם שוליים רחבים ותווית ארוגה במרכז הגב'.split(' ');
const ARABIC = 'درزة جانبية مزدوجة مع حاشية عريضة وبطاقة منسوجة في وسط الظهر'.split(' ');
const CJK = '衿ぐりはリブ編みで仕上げ肩線はテープで補強すること針目は三センチに十二針袖口裾二本針縫合洗濯表示左脇縫目領口羅紋拼接'.match(/.{1,9}/gu);
const PLAIN = 'seam of the side panel with twin needle stitch and narrow hem at the lower edge pressed open'.split(' ');
const LONG = [
  'Donaudampfschifffahrtsgesellschaftskapitänsmützenabzeichen',
  'Rindfleischetikettierungsüberwachungsaufgabenübertragungsgesetz',
  'x'.repeat(90),
  'AB/12-'.repeat(12),
];

class Texts {
  #random;
  #count = 0;
  /** Words that the document must show. */
  told = [];

  constructor(random) {
    this.#random = random;
  }

  /** A word of its own: letters and digits that lines break at no place of. */
  mark() {
    const mark = `Q${(this.#count++).toString(36)}Z`;
    this.told.push(mark);
    return mark;
  }

  /** @param {number} words at most @param {number} characters at most */
  text(words, characters) {
    const random = this.#random;
    const script = oneOf(random, [PLAIN, PLAIN, PLAIN, HEBREW, ARABIC, CJK]);
    const list = Array.from({ length: Math.floor(between(random, 0, words)) }, () => (random() < 0.03 ? oneOf(random, LONG) : oneOf(random, script)));
    const [first, last] = [this.mark(), this.mark()];
    let middle = list.join(script === CJK ? '' : ' ');
    middle = [...middle].slice(0, Math.max(0, characters - first.length - last.length - 2)).join('');
    return [first, middle, last].filter(Boolean).join(' ');
  }

  cell = (words = 12) => this.text(words, 480);
  name = (words = 3) => this.text(words, 110);
  paragraph = (words) => this.text(words, 3900);
}

/** In one of ten documents a list is as long as it gets there. */
const size = (random, usual, most) => (random() < 0.1 ? most : Math.floor(between(random, 0, usual)));
const listOf = (count, make) => Array.from({ length: count }, (_, i) => make(i));

const VIEWS = ['front', 'back', 'left', 'right', 'top', 'three-quarter'];

/** A point of the square. */
const point = (random) => [between(random, -0.149, 0.149), between(random, 0.151, 0.449), 0];
const flatView = (random) => oneOf(random, ['front', 'back']);

/**
 * @param {number} seed
 * @returns {{spec: object, told: string[]}} told: words that the document must show
 */
export function randomSpec(seed) {
  const random = seeded(seed);
  const texts = new Texts(random);
  const some = (make) => (random() < 0.5 ? make() : undefined);
  const views = listOf(1 + Math.floor(random() * 5), (i) => ({
    name: `v${i}`,
    view: oneOf(random, i < 2 ? ['front', 'back'] : VIEWS),
    title: some(() => texts.name(6)),
    style: random() < 0.3 ? 'flat' : undefined,
  }));
  const facing = views.filter(({ view }) => view === 'front' || view === 'back').map(({ name }) => name);
  const sizes = listOf(size(random, 8, 30), (i) => (random() < 0.05 ? texts.name(2) : `${i * 2 + 30}`));
  const colourways = listOf(size(random, 4, 12), () => ({ name: texts.name(), code: some(() => texts.name(1)), swatches: [] }));
  for (const colourway of colourways)
    colourway.swatches = listOf(size(random, 4, 12), () => ({
      part: some(() => texts.name()),
      name: some(() => texts.name()),
      color: random() < 0.8 ? 'teal' : undefined,
    }));
  const spec = {
    paper: { size: oneOf(random, ['A4', 'A4', 'A3', 'Letter']), orientation: oneOf(random, ['landscape', 'landscape', 'portrait']) },
    language: oneOf(random, ['en', 'es']),
    ppi: 36,
    header: {
      style: texts.name(1),
      name: texts.name(4),
      brand: some(() => texts.name()),
      season: some(() => texts.name(1)),
      description: some(() => texts.paragraph(80)),
      sizes,
      baseSize: sizes[0],
    },
    views,
    callouts: listOf(size(random, 14, 60), () => ({
      view: oneOf(random, facing),
      point: point(random),
      text: random() < 0.04 ? texts.paragraph(400) : texts.cell(20),
      side: oneOf(random, [undefined, undefined, 'left', 'right']),
    })),
    details: listOf(size(random, 3, 9), () => ({
      title: texts.name(),
      view: oneOf(random, facing),
      point: point(random),
      size: between(random, 0.01, 0.2),
      shape: oneOf(random, ['circle', 'rectangle']),
      text: some(() => (random() < 0.1 ? texts.paragraph(300) : texts.cell())),
    })),
    measures: listOf(size(random, 8, 60), (i) => ({
      code: random() < 0.05 ? `${i} ${texts.name(1)}` : `M${i}`,
      description: texts.cell(6),
      how: some(() => texts.cell(8)),
      view: flatView(random) && oneOf(random, facing),
      points: random() < 0.6 ? [point(random), point(random)] : undefined,
      tolerance: 0.5,
      values: sizes.length > 0 ? { [sizes[0]]: Number(between(random, 1, 99).toFixed(1)) } : {},
      grade: sizes.length > 0 ? 0.5 : undefined,
    })),
    colourways,
    bill: listOf(size(random, 6, 60), () => ({
      reference: some(() => texts.name(1)),
      item: texts.cell(5),
      supplier: some(() => texts.cell(3)),
      composition: some(() => texts.cell(6)),
      placement: some(() => texts.cell(4)),
      colours: Object.fromEntries(colourways.filter(() => random() < 0.7).map(({ name }) => [name, texts.name(1)])),
    })),
    construction: listOf(size(random, 5, 60), () => ({ part: texts.cell(4), stitch: some(() => texts.name(1)), text: some(() => texts.cell()) })),
    labels: listOf(size(random, 3, 12), () => ({ name: texts.name(), text: some(() => texts.paragraph(60)), placement: some(() => texts.cell(5)) })),
    care: {
      symbols: random() < 0.5 ? ['wash-30-mild', 'bleach-no', 'tumble-dry-low', 'iron-110', 'dry-clean-no'].slice(0, Math.floor(between(random, 1, 6))) : [],
      text: some(() => texts.paragraph(40)),
    },
    artwork: listOf(size(random, 2, 5), () => ({
      name: texts.name(),
      position: some(() => texts.cell()),
      text: some(() => texts.paragraph(random() < 0.1 ? 400 : 30)),
    })),
    notes: some(() => texts.paragraph(120)),
    revisions: listOf(size(random, 3, 20), () => ({ revision: texts.name(1), date: some(() => texts.name(1)), text: texts.cell() })),
  };
  // What is undefined is not there: a spec is JSON. What nothing shows is not told.
  const given = JSON.parse(JSON.stringify(spec));
  const text = JSON.stringify(given);
  return { spec: given, told: texts.told.filter((mark) => text.includes(mark)) };
}
