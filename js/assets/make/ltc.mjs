import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

/**
 * Writes renderer/pass/surface/ltc_tables.inc, the tables of rect lights, from the three.js package: the same numbers as in the
 * browser, so that both sides read the same lobes. node js/assets/make/ltc.mjs
 */

export const LTC_FILE = fileURLToPath(new URL('../../../renderer/pass/surface/ltc_tables.inc', import.meta.url));

const NUMBERS_A_LINE = 16;

const NOTICE = `// GGX lobes as linearly transformed cosines, 64 x 64 texels, written by js/assets/make/ltc.mjs from
// RectAreaLightTexturesLib of the three.js package (MIT licence, copyright 2010-2026 three.js authors), which has them
// from ltc_code:
//
// Copyright (c) 2017, Eric Heitz, Jonathan Dupuy, Stephen Hill and David Neubelt.
// All rights reserved.
//
// Redistribution and use in source and binary forms, with or without modification, are permitted provided that the
// following conditions are met:
//
// * If you use (or adapt) the source code in your own work, please include a reference to the paper:
//   Real-Time Polygonal-Light Shading with Linearly Transformed Cosines. Eric Heitz, Jonathan Dupuy, Stephen Hill and
//   David Neubelt. ACM Transactions on Graphics (Proceedings of ACM SIGGRAPH 2016) 35(4), 2016.
//   Project page: https://eheitzresearch.wordpress.com/415-2/
// * Redistributions of source code must retain the above copyright notice, this list of conditions and the following
//   disclaimer.
// * Redistributions in binary form must reproduce the above copyright notice, this list of conditions and the following
//   disclaimer in the documentation and/or other materials provided with the distribution.
//
// THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES,
// INCLUDING, BUT NOT LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE ARE
// DISCLAIMED. IN NO EVENT SHALL THE COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT, INCIDENTAL,
// SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR
// SERVICES; LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON ANY THEORY OF LIABILITY,
// WHETHER IN CONTRACT, STRICT LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN ANY WAY OUT OF THE USE OF
// THIS SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE.
`;

/** The shortest literal of an fp32 number: 0.1 as ".1f", 1 as "1". */
function literal(value) {
  let text = String(value);
  for (let digits = 1; digits <= 9; digits++) {
    const candidate = Number(value.toPrecision(digits));
    if (Math.fround(candidate) !== value) continue;
    text = String(candidate);
    break;
  }
  return Number.isInteger(value) ? text : `${text.replace(/^(-?)0\./, '$1.')}f`;
}

function array(name, comment, numbers) {
  const lines = [];
  for (let i = 0; i < numbers.length; i += NUMBERS_A_LINE)
    lines.push(
      `  ${numbers
        .slice(i, i + NUMBERS_A_LINE)
        .map(literal)
        .join(', ')},`,
    );
  return `\n// ${comment}\nconstexpr float ${name}[${numbers.length}] = {\n${lines.join('\n')}\n};\n`;
}

/** @returns {Promise<string>} text of LTC_FILE */
export async function ltcTables() {
  const { RectAreaLightTexturesLib } = await import('three/addons/lights/RectAreaLightTexturesLib.js');
  const { LTC_FLOAT_1, LTC_FLOAT_2 } = RectAreaLightTexturesLib.init();
  const inverse = [...LTC_FLOAT_1.image.data];
  // The other two channels are 0 and what three.js does not read.
  const albedo = [...LTC_FLOAT_2.image.data].filter((_, i) => i % 4 < 2);
  return (
    NOTICE +
    array('LTC_INVERSE', 'RGBA: entries [0][0], [0][2], [2][0] and [2][2] (column, row) of the inverse matrix.', inverse) +
    array('LTC_ALBEDO', "RG: the lobe's albedo is f0 R + (f90 - f0) G.", albedo)
  );
}

if (process.argv[1] === fileURLToPath(import.meta.url)) writeFileSync(LTC_FILE, await ltcTables());
