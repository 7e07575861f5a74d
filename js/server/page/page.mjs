/** The page to try the service: what it offers is read from openapi.json. */

const by = (id) => document.getElementById(id);
/** What a first request asks for. */
const FIRST_KEYS = { '/v1/thumbnails': { shot: { size: { width: 512, height: 512 } } } };

const { paths } = await (await fetch('openapi.json')).json();
const routes = Object.entries(paths).filter(([, { post }]) => post);
by('route').replaceChildren(...routes.map(([path]) => new Option(path, path)));

const operation = () => paths[by('route').value].post;
const formOf = ({ requestBody }) => requestBody.content['multipart/form-data'];
/** A file has no type in the schema: its media type says what it is. */
const isFile = ({ type, anyOf, $ref, items }) => (type === undefined && !anyOf && !$ref) || (type === 'array' && items && Object.keys(items).length === 0);

function element(name, properties, ...children) {
  const node = Object.assign(document.createElement(name), properties);
  node.append(...children);
  return node;
}

function showRoute() {
  const { summary, responses } = operation();
  by('summary').textContent = summary;
  by('accept').replaceChildren(...Object.keys(responses[200].content).map((type) => new Option(type, type)));
  const files = Object.entries(formOf(operation()).schema.properties).filter(([, schema]) => isFile(schema));
  by('files').replaceChildren(
    ...files.map(([name, { description, type }]) =>
      element('label', {}, `${name}: ${description}`, element('input', { type: 'file', name, multiple: type === 'array' })),
    ),
  );
  by('keys').value = JSON.stringify(FIRST_KEYS[by('route').value] ?? {}, null, 2);
  showCurl();
}

const inputs = () => [...by('files').querySelectorAll('input')];
const quoted = (text) => `'${text.replaceAll("'", "'\\''")}'`;
const textOf = (value) => (typeof value === 'string' ? value : JSON.stringify(value));

/** Keys of the text field; nothing where it is no JSON. */
function keys() {
  try {
    return Object.entries(JSON.parse(by('keys').value));
  } catch {
    return undefined;
  }
}

function showCurl() {
  const given = inputs().flatMap(({ name, files }) => [...files].map((file) => `-F ${quoted(`${name}=@${file.name}`)}`));
  const fields = (keys() ?? []).map(([name, value]) => `--form-string ${quoted(`${name}=${textOf(value)}`)}`);
  const address = new URL(by('route').value.slice(1), location.href.replace(/try$/, ''));
  by('curl').textContent = ['curl', `-H ${quoted(`accept: ${by('accept').value}`)}`, ...given, ...fields, '-o answer', quoted(address.href)].join(' \\\n  ');
}

let shown;
function showAnswer(blob, type) {
  if (shown) URL.revokeObjectURL(shown);
  shown = URL.createObjectURL(blob);
  const isPicture = /^image\/(png|jpeg|webp|svg)/.test(type);
  by('picture').hidden = !isPicture;
  if (isPicture) by('picture').src = shown;
  by('save').hidden = false;
  by('save').href = shown;
}

async function send() {
  const fields = keys();
  if (!fields) return say('The keys are no JSON.');
  const body = new FormData();
  for (const [name, value] of fields) body.append(name, textOf(value));
  for (const { name, files } of inputs()) for (const file of files) body.append(name, file, file.name);
  say('Waiting …');
  const start = performance.now();
  const response = await fetch(by('route').value.slice(1), { method: 'POST', body, headers: { accept: by('accept').value } });
  const blob = await response.blob();
  const type = response.headers.get('content-type');
  showAnswer(blob, type);
  by('text').hidden = !/json/.test(type);
  if (/json/.test(type)) by('text').textContent = JSON.stringify(JSON.parse(await blob.text()), null, 2).slice(0, 100_000);
  say(`${response.status}, ${type}, ${blob.size} bytes, ${Math.round(performance.now() - start)} ms`);
}

const say = (text) => {
  by('status').textContent = text;
};

by('route').addEventListener('change', showRoute);
by('request').addEventListener('input', showCurl);
by('request').addEventListener('submit', (event) => {
  event.preventDefault();
  send().catch((error) => say(String(error)));
});
showRoute();
