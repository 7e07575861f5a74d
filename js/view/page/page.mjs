import './no_eval.mjs';
import { VIEWS } from '../../shot/frame.mjs';
import { withView } from './camera_edit.mjs';
import { Client } from './client.mjs';
import { bindCloths } from './cloths_picker.mjs';
import { bindControls } from './controls.mjs';
import { addOrbit } from './orbit.mjs';
import { Pictures } from './pictures.mjs';
import { session } from './remote.mjs';
import { savePicture } from './saving.mjs';
import { addSheet } from './sheet.mjs';
import { bindShortcuts } from './shortcuts.mjs';
import { ShotState } from './shot_state.mjs';
import { bindShotText } from './shot_text.mjs';
import { Stage } from './stage.mjs';
import { titled } from './text.mjs';

const $ = (id) => document.getElementById(id);

const STATUS = { loading: 'Loading the model', drawing: 'The server draws', comparing: 'Comparing', ready: '', error: '' };

let drawings = 0;

/** What the page does, for readers (the status line) and tests (the attributes). */
function setPhase(phase) {
  if (phase === 'drawing') {
    tell();
    document.body.dataset.drawings = String(++drawings);
  }
  document.body.dataset.phase = phase;
  $('status').textContent = STATUS[phase];
}

function tell(error) {
  $('alert').textContent = error ? `${error.message}${error.code ? ` [${error.code}]` : ''}` : '';
  $('alert').hidden = !error;
}

/** Runs what may be refused; whether it went well. */
function attempt(act) {
  try {
    act();
    tell();
    return true;
  } catch (error) {
    tell(error);
    return false;
  }
}

function fail(error) {
  console.error(error);
  tell(error);
  setPhase('error');
}

function addViews(state) {
  const buttons = Object.keys(VIEWS).map((view, i) => {
    const button = Object.assign(document.createElement('button'), { type: 'button', textContent: titled(view) });
    button.setAttribute('aria-keyshortcuts', String(i + 1));
    button.dataset.view = view;
    button.addEventListener('click', () => choose(view));
    return button;
  });
  const cameraOf = (view) => withView(state.shot.camera, state.resolved.camera, view);
  const choose = (view) => attempt(() => state.change({ camera: cameraOf(view) }));
  const mark = () => {
    for (const button of buttons) button.setAttribute('aria-pressed', state.isShowing({ camera: cameraOf(button.dataset.view) }));
  };
  $('views').replaceChildren(...buttons);
  state.addEventListener('change', mark);
  mark();
  return Object.fromEntries(Object.keys(VIEWS).map((view, i) => [String(i + 1), () => choose(view)]));
}

function addModes(stage) {
  const radios = [...document.querySelectorAll('input[name=mode]')];
  for (const radio of radios) radio.addEventListener('change', () => (stage.mode = radio.value));
  stage.mode = radios.find(({ checked }) => checked).value;
  return Object.fromEntries(radios.map((radio) => [radio.dataset.key, () => radio.click()]));
}

async function start() {
  setPhase('loading');
  const { name, shot, environments, spec, server } = await session();
  $('model-name').textContent = name;
  document.title = `${name} · telar`;
  const client = await Client.load({ place: $('client-canvas'), model: `model/${encodeURIComponent(name)}`, environments, shot });
  const state = new ShotState(shot, (wanted) => client.facts(wanted));
  const stage = new Stage($('stage'));
  const pictures = new Pictures({ state, client, stage, serverGl: server.renderer, setPhase, fail });
  const { cameras, variants } = client.facts(shot);
  bindControls($('controls'), state, { environments, cameras, variants, animations: client.animations }, attempt);
  bindCloths($('controls'), state, client.names, attempt);
  bindShotText($('shot-text'), state, attempt);
  addOrbit($('stage'), state, () => client.camera, attempt);
  const stem = name.replace(/\.[^.]*$/, '');
  const save = (side) => {
    const { [side]: image, resolved } = pictures.shown;
    if (image) savePicture(image, resolved, `${stem}-${side}.png`).catch(tell);
  };
  for (const side of ['browser', 'server']) $(`save-${side}`).addEventListener('click', () => save(side));
  const help = () => $('help').showModal();
  $('help-button').addEventListener('click', help);
  const sheetKeys = spec ? await addSheet({ client, shots: state, tell }) : {};
  bindShortcuts(
    {
      ...sheetKeys,
      ...addViews(state),
      ...addModes(stage),
      ' ': () => stage.pause(),
      s: () => save('browser'),
      S: () => save('server'),
      '?': help,
    },
    $('single-keys'),
  );
  await pictures.update();
  $('gate-command').textContent = `telar compare --gate ${pictures.gate}`;
  $('client-gl').textContent = `three.js r${Client.revision}, ${client.glName}`;
  $('server-gl').textContent = `telar, ${server.renderer}`;
}

start().catch(fail);
