import { CLOTHS } from '../shot/table/cloths.mjs';

/** Words of material names, in English, Spanish, Italian, German and French, by the preset that they suggest beside its own name. The first that fits is proposed. */
const WORDS = {
  denim: ['jean', 'jeans', 'mezclilla', 'vaquero', 'chambray'],
  'sequin-thread': ['sequin', 'sequins', 'lentejuela', 'lentejuelas', 'pailletten', 'paillette', 'paillettes', 'lurex'],
  velvet: ['velour', 'velours', 'terciopelo', 'velluto', 'samt'],
  satin: ['saten', 'satén', 'raso', 'charmeuse', 'sateen'],
  silk: ['seda', 'seta', 'seide', 'soie', 'habotai'],
  'patent-leather': ['patent', 'charol', 'lackleder'],
  leather: ['cuero', 'piel', 'pelle', 'leder', 'cuir', 'nappa'],
  'waxed-cotton': ['waxed', 'encerado', 'oilskin'],
  'nylon-shell': ['nylon', 'ripstop', 'taffeta', 'tafeta', 'softshell', 'windbreaker'],
  tulle: ['tul', 'tüll', 'net', 'netting'],
  lace: ['encaje', 'pizzo', 'spitze', 'dentelle', 'blonda', 'guipure'],
  towel: ['terry', 'rizo', 'frottee', 'spugna', 'éponge', 'toalla'],
  'wool-felt': ['felt', 'fieltro', 'filz', 'feltro', 'feutre', 'melton'],
  twill: ['gabardine', 'gabardina', 'sarga', 'chino', 'köper'],
  linen: ['lino', 'leinen', 'lin'],
  corduroy: ['pana', 'cord', 'kord'],
  'rib-knit': ['ribbing', 'canalé', 'costina'],
  fleece: ['polar', 'vlies', 'felpa'],
  suede: ['ante', 'gamuza', 'wildleder', 'nubuck', 'daim'],
  'quilted-nylon': ['quilted', 'quilting', 'acolchado', 'puffer', 'gesteppt'],
  chiffon: ['gasa', 'georgette'],
  boucle: ['bouclé', 'rizado'],
  'cotton-jersey': ['jersey', 'tshirt', 'punto', 'trikot', 'interlock'],
};

const wordsOf = (text) => text.toLowerCase().match(/\p{L}+/gu) ?? [];

/** Camel case counts as words: "BodyDenim_v2" is body, denim, v. */
const separated = (name) => name.replace(/(\p{Ll})(\p{Lu})/gu, '$1 $2');

/**
 * The cloth that a material's name suggests; factors alone suggest none, as those of cloths are alike.
 * @param {string} name
 * @returns {string | null} a preset: something to look at, never applied by itself
 */
export function proposedPreset(name) {
  const said = new Set(wordsOf(separated(name)));
  const known = [...Object.keys(WORDS), ...CLOTHS.filter((preset) => !Object.hasOwn(WORDS, preset))].filter((preset) => CLOTHS.includes(preset));
  const named = known.filter((preset) => wordsOf(preset).every((word) => said.has(word)));
  const longest = named.sort((a, b) => b.length - a.length)[0];
  return longest ?? known.find((preset) => (WORDS[preset] ?? []).some((word) => said.has(word))) ?? null;
}
