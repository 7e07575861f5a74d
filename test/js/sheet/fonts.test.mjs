import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bundledFonts } from '../../../js/sheet/engine.mjs';
import { readFonts } from '../../../js/sheet/fonts.mjs';

const [inter] = await bundledFonts();

const utf16 = (text) => Buffer.from(text, 'utf16le').swap16();

/**
 * Inter with other names: its table of names goes to the end.
 * @param {{platform: number, encoding?: number, id: number, bytes: Buffer}[]} records
 */
function named(records, { name = 'name', length } = {}) {
  const font = Buffer.from(inter);
  const entries = Array.from({ length: font.readUInt16BE(4) }, (_, i) => 12 + 16 * i);
  const entry = entries.find((at) => font.toString('latin1', at, at + 4) === 'name');
  const strings = 6 + 12 * records.length;
  const head = Buffer.alloc(strings);
  head.writeUInt16BE(records.length, 2);
  head.writeUInt16BE(strings, 4);
  let offset = 0;
  records.forEach(({ platform, encoding = platform === 3 ? 1 : 0, id, bytes }, i) => {
    [platform, encoding, 0, id, length ?? bytes.length, offset].forEach((value, k) => head.writeUInt16BE(value, 6 + 12 * i + 2 * k));
    offset += bytes.length;
  });
  font.write(name, entry, 'latin1');
  font.writeUInt32BE(font.length, entry + 8);
  return Buffer.concat([font, head, ...records.map(({ bytes }) => bytes)]);
}

const family = (font) => readFonts([font]).families[0];

test('the family of a font is the typographic one, of Windows before Unicode and Macintosh', () => {
  const windows = { platform: 3, id: 1, bytes: utf16('Windows') };
  const unicode = { platform: 0, encoding: 3, id: 1, bytes: utf16('Ünicode') };
  const macintosh = { platform: 1, id: 1, bytes: Buffer.from([0x4d, 0x8a, 0x63]) };
  assert.equal(family(named([macintosh, unicode, windows])), 'Windows');
  assert.equal(family(named([macintosh, unicode])), 'Ünicode');
  assert.equal(family(named([macintosh])), 'Mäc');
  assert.equal(family(named([{ ...macintosh, id: 16, bytes: Buffer.from('Typo') }, windows])), 'Typo');
  // What is no text, and what is in an encoding that is no Unicode, is passed over.
  const broken = ['d8000041', '0041d800', '00', '', '000a0041', '0000'].map((hex) => ({ ...windows, bytes: Buffer.from(hex, 'hex') }));
  for (const record of [...broken, { ...windows, encoding: 2 }]) assert.equal(family(named([record, macintosh])), 'Mäc', record.bytes.toString('hex'));
});

test('a font whose family has no name is refused by its place', () => {
  const windows = { platform: 3, id: 1, bytes: utf16('Windows') };
  const wrong = [
    named([]),
    named([{ ...windows, id: 4 }]),
    named([{ ...windows, bytes: Buffer.alloc(0) }]),
    named([{ ...windows, bytes: utf16('\ud800"\n') }]),
    named([{ platform: 1, encoding: 1, id: 1, bytes: Buffer.from('Mac') }]),
    named([windows], { name: 'none' }),
  ];
  for (const [i, font] of wrong.entries())
    assert.throws(
      () => readFonts([inter, inter, font], 1),
      {
        code: 'E_OPTION',
        message: 'options.fonts[1]: expected the bytes of a TrueType or OpenType font with a Unicode character map and a name of its family',
      },
      `${i}`,
    );
});
