// Starts the page: puts the parts together, and listens to the keyboard, to files that are dropped and to the address.
import { App } from './app.js';
import { Panel } from './panel.js';
import { fromHash, toHash } from './state.js';
import { Viewer } from './viewer.js';

const element = (id) => document.getElementById(id);
const state = fromHash(location.hash);
const panel = new Panel();

let viewer;
try {
  viewer = new Viewer(element('canvas'), {
    onPick: (source) => app.setSource(source),
    onChange: () => saveState(),
  });
} catch (error) {
  panel.showMessage('This page needs WebGL 2, which this browser does not offer.');
  throw error;
}
const app = new App(viewer, panel, state);
panel.connect(app);
panel.showNearest(false);

let saved = location.hash;
function saveState() {
  state.view = viewer.getView();
  saved = toHash(state);
  history.replaceState(null, '', saved);
}
app.onState = saveState;

async function start() {
  if (state.view) viewer.setView(state.view);
  if (state.sample) await app.openSample(state.sample, state.faces, true);
  else panel.showMessage(`This link is about the file “${state.file}”: open it to see the same.`, true, true);
}

window.addEventListener('hashchange', () => {
  if (location.hash === saved) return;
  location.reload();
});

element('copy-link').addEventListener('click', async () => {
  saveState();
  try {
    await navigator.clipboard.writeText(location.href);
    panel.showMessage('The link is in the clipboard.', true);
  } catch {
    panel.showMessage('The link is in the address bar of the browser.', true);
  }
});

const turn = Math.PI / 24;
const keys = {
  o: () => element('open').click(),
  s: () => viewer.pickCenter(),
  r: () => { viewer.resetView(); saveState(); },
  m: () => { if (state.solver === 'exact') app.setSolver('exact', panel.nextMethod(state)); },
  c: () => app.toggleCut(),
  p: () => app.export('png'),
  '?': () => element('help').showModal(),
  '+': () => viewer.zoom(0.9),
  '=': () => viewer.zoom(0.9),
  '-': () => viewer.zoom(1 / 0.9),
  Escape: () => { app.cancel(); panel.hideMessage(); },
};
const canvasKeys = {
  ArrowLeft: () => viewer.orbit(-turn, 0),
  ArrowRight: () => viewer.orbit(turn, 0),
  ArrowUp: () => viewer.orbit(0, -turn),
  ArrowDown: () => viewer.orbit(0, turn),
};

window.addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || element('help').open) return;
  const isTyping = event.target.matches('input[type=number], input[type=range], select');
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  if (isTyping && key !== 'Escape') return;
  if (/^[1-4]$/.test(key)) element('samples').children[Number(key) - 1].click();
  else if (keys[key]) keys[key]();
  else if (canvasKeys[key] && !event.target.matches('button, input')) canvasKeys[key]();
  else return;
  event.preventDefault();
});

const stage = document.body;
let depth = 0; // of the elements entered while a file is dragged
stage.addEventListener('dragenter', () => { ++depth; element('drop').hidden = false; });
stage.addEventListener('dragleave', () => { if (--depth <= 0) element('drop').hidden = true; });
stage.addEventListener('dragover', (event) => event.preventDefault());
stage.addEventListener('drop', (event) => {
  event.preventDefault();
  depth = 0;
  element('drop').hidden = true;
  const [file] = event.dataTransfer.files;
  if (file) app.openFile(file);
});

// for tests and for whoever looks at the page from the console
window.cutLocusPage = { app, viewer, panel };
start();
